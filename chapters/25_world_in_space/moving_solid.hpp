/// \file moving_solid.hpp
/// When two solids that move and turn first come within a given distance: chapter 12's conservative advancement.
///
///     c(τ) = c₀ + τ Δc,   R(τ) = R₀ exp(τ δ)                                                          (25.6)
///     r = n·(Δc_a − Δc_b) + max ‖δ_a × p̄‖ + max ‖δ_b × p̄‖   over the corners p̄ of each                 (25.7)
#pragma once

#include "chapters/12_contact_manifolds/time_of_impact.hpp"
#include "chapters/22_distance_of_solids/gjk.hpp"
#include "chapters/22_distance_of_solids/separating_axes.hpp"
#include "chapters/23_faces_that_touch/walled_solids.hpp"

namespace rigid {

//! [moving]
/// A body on its way through a step, (25.6).
struct MovingSolid {
    const std::vector<SolidForm>* forms = nullptr;
    Vec3 from = {0, 0, 0}, way = {0, 0, 0};  ///< of its centroid [m]
    Mat3 R = Mat3::Identity();               ///< R₀
    Vec3 turn = {0, 0, 0};                   ///< δ, in the body's axes

    Vec3 centre_at(Real part) const { return from + part * way; }
    Mat3 axes_at(Real part) const { return R * rotation_matrix(Vec3(part * turn)); }
    MovingSolid piece(Real begin, Real end) const
    {
        return {forms, centre_at(begin), (end - begin) * way, axes_at(begin),
                (end - begin) * turn};
    }
    PlacedSolid& place(const SolidForm& form, Real part, PlacedSolid& memory) const
    {
        memory.place(form, centre_at(part), axes_at(part));
        return memory;
    }
};

/// The way of body k from x to y. Of all turns from one to the other, which differ
/// by whole ones, it is the one that its spin makes.
inline MovingSolid motion_of(const std::vector<SolidForm>& forms, const VecX& x,
                             const VecX& y, Index k, const Vec3& spin_times_h)
{
    MovingSolid m;
    m.forms = &forms;
    m.from = centre_of(x, k), m.way = centre_of(y, k) - m.from;
    m.R = rotation_of(x, k);
    m.turn = rotation_vector(Mat3(m.R.transpose() * rotation_of(y, k)));
    const Real angle = m.turn.norm();
    if (!(angle > 0)) return m;
    const Vec3 axis = m.turn / angle;
    m.turn +=
        2 * pi * std::round((axis.dot(spin_times_h) - angle) / (2 * pi)) * axis;
    return m;
}
//! [moving]

//! [turning]
/// How far a corner of a core goes by turning, at most [m]. What is round about a
/// corner goes no farther.
inline Real turning(const MovingSolid& m, const SolidForm& form)
{
    Real farthest = 0;
    for (const Vec3& p : form.hull.vertices)
        farthest = std::max(farthest, cross(m.turn, p).norm());
    return farthest;
}
//! [turning]

/// How far two solids are apart, and along which direction from a to b.
struct SolidGap {
    Real gap = infinity;  ///< [m]; negative: the least way that parts them
    Vec3 normal = {0, 1, 0};
};

//! [gap]
/// The distance of their cores by (22.1); where these overlap, the best axis.
inline SolidGap gap_of(const PlacedSolid& a, const PlacedSolid& b)
{
    const Real radii = a.radius() + b.radius();
    const Nearest near = nearest_points(a, b);
    if (near.distance > 1e-7 * (a.form->reach + b.form->reach))
        return {near.distance - radii, (near.on_b - near.on_a) / near.distance};
    const Axis face = best_face(a, b, 0), edges = best_across_edges(a, b);
    const Axis& best = edges.separation > face.separation ? edges : face;
    // two round ones with one centre: any direction parts them
    return {(best.separation > -infinity ? best.separation : 0) - radii,
            best.normal};
}

inline SolidGap gap_of(const SolidWall& wall, const PlacedSolid& b)
{
    const Vec3& lowest = b.corner(b.support(-wall.normal));
    return {wall.normal.dot(lowest) - wall.offset - b.radius(), wall.normal};
}
//! [gap]

struct SolidImpactMemory {
    PlacedSolid a, b;
};

//! [impact]
/// (12.9) with (25.7).
inline Impact time_of_impact(const MovingSolid& a, const SolidForm& of_a,
                             const MovingSolid& b, const SolidForm& of_b,
                             Real target, Real tolerance, SolidImpactMemory& memory)
{
    const Real turns = turning(a, of_a) + turning(b, of_b);
    return advance_gap(
        [&](Real part) {
            return gap_of(a.place(of_a, part, memory.a),
                          b.place(of_b, part, memory.b));
        },
        [&](const Vec3& n) { return n.dot(a.way - b.way) + turns; }, target,
        tolerance);
}

inline Impact time_of_impact(const SolidWall& wall, const MovingSolid& b,
                             const SolidForm& of_b, Real target, Real tolerance,
                             SolidImpactMemory& memory)
{
    const Real turns = turning(b, of_b);
    return advance_gap(
        [&](Real part) { return gap_of(wall, b.place(of_b, part, memory.b)); },
        [&](const Vec3& n) { return turns - n.dot(b.way); }, target, tolerance);
}
//! [impact]

}  // namespace rigid
