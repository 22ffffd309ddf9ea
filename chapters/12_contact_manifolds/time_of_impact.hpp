/// \file time_of_impact.hpp
/// When two moving shapes first come within a given distance: conservative advancement.
///
///     τ ← τ + (gap − target) / r,   r = n·(v_a − v_b) + |ω_a| R_a + |ω_b| R_b                          (12.9)
///
/// Along the normal n of the nearest points no two points of the shapes can close the gap faster than r, turning
/// included, for R the way from the centroid to the farthest vertex. So the shapes do not touch before the new τ, and no
/// impact is ever passed \cite mirtich1996thesis. Straight motion takes one round; those of a turning shape get shorter
/// towards the impact.
#pragma once

#include "chapters/12_contact_manifolds/manifold.hpp"
#include "chapters/12_contact_manifolds/wall_manifold.hpp"

namespace rigid {

/// A shape that moves from one pose to another, evenly, while τ goes from 0 to 1.
struct MovingShape {
    const Polygon* shape = nullptr;
    Vec<3> from = Vec<3>::Zero(), to = Vec<3>::Zero();

    Vec<3> at(Real part) const { return from + part * (to - from); }
    MovingShape piece(Real begin, Real end) const
    {
        return {shape, at(begin), at(end)};
    }
    Vec<3> way() const { return to - from; }
};

/// R of all shapes of a body, and what is round about them [m]
inline Real farthest_point(const RigidScene& scene, Index k)
{
    Real farthest = 0;
    scene.for_each_shape(k, [&](Index i) {
        const auto at = static_cast<std::size_t>(i);
        if (at >= scene.shapes.size()) return;  // a point
        const Polygon& shape = scene.shapes[at];
        farthest = std::max(farthest, turning_radius(shape) + shape.radius);
    });
    return farthest;
}

struct Impact {
    bool hit = false;
    bool close = false;     ///< so close at the start that nothing was looked for
    Real start = infinity;  ///< gap at τ = 0 [m]
    Real part = 1;          ///< τ, 0 … 1; 1 without a hit
    int rounds = 0;         ///< distances computed
};

/// Memory of time_of_impact(): shapes that are placed.
struct ImpactMemory {
    PlacedShape a, b;
};

//! [advance]
/// (12.9), for any gap(τ) with its normal: from τ = 0 until the gap is at most
/// `target` + `tolerance`.
/// \param gap_at  of τ: what has a `gap` and a `normal`
/// \param rate    Real(normal): no faster can the gap close [m a unit of τ]
/// \return        no hit if it is so close at the start: that is a contact
///                already. After 100 rounds the present τ is called a hit: early,
///                never late
template <class GapAt, class Rate>
Impact advance_gap(const GapAt& gap_at, const Rate& rate, Real target,
                   Real tolerance)
{
    Impact impact;
    Real part = 0;
    while (++impact.rounds <= 100) {
        const auto [gap, normal] = gap_at(part);
        if (part == 0) impact.start = gap;
        if (gap <= target + tolerance) {
            impact.close = part == 0;
            if (impact.close) return impact;
            break;
        }
        const Real closing = rate(normal);
        if (!(closing > 0)) return impact;
        if (part + (gap - target) / closing >= 1) return impact;
        part += (gap - target) / closing;
    }
    impact.hit = true;
    impact.part = part;
    return impact;
}

/// The same for shapes in the plane.
/// \param nearest  Manifold(Real τ)
template <class Nearest, class Rate>
Impact advance(const Nearest& nearest, const Rate& rate, Real target,
               Real tolerance)
{
    return advance_gap(
        [&nearest](Real part) {
            const Manifold m = nearest(part);
            return std::pair<Real, Vec2>(m.deepest(), m.normal);
        },
        rate, target, tolerance);
}

inline Impact time_of_impact(const MovingShape& a, const MovingShape& b,
                             Real target, Real tolerance, ImpactMemory& memory)
{
    const Vec<3> wa = a.way(), wb = b.way();
    const Real turning = std::abs(wa[2]) * turning_radius(*a.shape) +
                         std::abs(wb[2]) * turning_radius(*b.shape);
    return advance(
        [&](Real part) {
            memory.a.move(*a.shape, a.at(part));
            memory.b.move(*b.shape, b.at(part));
            return collide(memory.a.view(), memory.b.view());
        },
        [&](const Vec2& n) { return n.dot(wa.head<2>() - wb.head<2>()) + turning; },
        target, tolerance);
}
//! [advance]

/// The same against a half-space.
Impact time_of_impact(const HalfSpace& wall, const MovingShape& b, Real target,
                      Real tolerance, ImpactMemory& memory);

}  // namespace rigid
