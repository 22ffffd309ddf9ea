/// \file cloth_contact.hpp
/// A particle against a solid: one row along the normal and the disc of friction, in positions.
///
///     C = n·(x − s) ≥ 0,   ΔΛ = −C/A clamped so that Λ ≥ 0,   A = 1/m + n·(1/m_b + …) n              (28.1)
///     ‖Λ_t‖ ≤ μ Λ,  against the way that the particle has slid on the solid
///
/// s moves with the solid. A solid that can move gets −P and its moment, so what the cloth gains it loses.
#pragma once

#include "chapters/28_cloth_that_touches/nearest_parts.hpp"
#include "chapters/28_cloth_that_touches/touching_cloth.hpp"

namespace rigid {

/// How far a point is outside of a shape, in its axes, and along which normal.
struct ClothGap {
    Real gap = 0;  ///< [m]; negative: inside
    Vec3 normal = {0, 1, 0};
};

//! [gap]
inline ClothGap gap_to(const ClothSolid& s, const Vec3& p)
{
    using Shape = ClothSolid::Shape;
    if (s.shape == Shape::wall) return {p.y(), {0, 1, 0}};
    // from the core: a point, a line or a box
    const Vec3 core = p.cwiseMax(-s.half).cwiseMin(s.half), d = p - core;
    if (const Real length = d.norm(); length > 0)
        return {length - s.radius, d / length};
    const Vec3 inside = s.half - p.cwiseAbs();
    int side =
        1;  // a capsule's axis and a ball's centre have no nearest side: upwards
    if (s.shape == Shape::box) inside.minCoeff(&side);
    Vec3 n(0, 0, 0);
    n[side] = p[side] < 0 ? -1 : 1;
    return {-inside[side] - s.radius, n};
}
//! [gap]

/// No point of a ball, a capsule or a box is farther from its centre [m]; the others have no end here.
inline Real reach_of(const ClothSolid& s)
{
    using Shape = ClothSolid::Shape;
    return s.shape == Shape::wall || s.shape == Shape::mesh
               ? infinity
               : (1 + 1e-9) * (s.half.norm() + s.radius);
}

/// The same of a mesh, whose triangles are looked at within `reach`; infinite if there
/// are none. Of several nearest triangles, at an edge or a corner, the one says the side
/// whose plane is farthest away; beyond its border a mesh has no back.
ClothGap gap_to(const TriangleMesh& mesh, const Vec3& p, Real reach,
                std::vector<int>& stack, std::vector<int>& near);

//! [contact]
struct ClothContact {
    int particle = 0, solid = 0;
    Vec3 normal = {0, 1, 0};  ///< out of the solid
    Vec3 arm = {0, 0,
                0};   ///< from the solid's centre to the point that touches [m]
    Real offset = 0;  ///< n·x at which C = 0, before the solid moves [m]
    Vec3 from = {0, 0, 0};   ///< x at the start of the sub-step [m]
    bool held = false;       ///< the solid takes no impulse
    Vec3 goes = {0, 0, 0};   ///< how far its point has moved [m]
    Real A = 0, At = 0;      ///< along the normal; the most along a tangent [1/kg]
    Real lambda = 0;         ///< Λ [N s²]
    Vec3 slide = {0, 0, 0};  ///< Λ_t [N s²]
};
//! [contact]

/// (28.5): the impulse that the midpoint takes back of a contact's Λ n + Λ_t [N s].
/// \param bounce  ū − u₀ along the contact: half of what its velocity has changed by [m/s]
/// \param A, At    along the normal and across [1/kg]
/// \param most     of Λ_t: less than that sticks [N s²]
Vec3 taken_back(const Vec3& bounce, const Vec3& normal, Real lambda,
                const Vec3& slide, Real A, Real At, Real most, Real h);

/// What contacts need to know of each solid, and what is kept from step to step.
struct ClothTouch {
    bool middle = false;  ///< the step is by the midpoint
    std::vector<Mat3> R;  ///< of the solids at the start of the sub-step
    VecX u0;     ///< velocities of the solids there, with what a limit drew back
    VecX moved;  ///< δ of each: centre [m], turn in its axes [rad]
    VecX unlimited;  ///< δ before a limit of strain drew back
    std::vector<ClothContact> contacts;
    Real margin = 0;               ///< particles that come as near have a row [m]
    std::vector<int> stack, near;  ///< memory for the trees of meshes

    /// Solids at the start of a sub-step, with gravity in their velocities: δ = h u*.
    void begin(TouchingCloth& cloth, Real h);
    /// The contacts of particles that are at x and came from x0.
    void find(const TouchingCloth& cloth, const VecX& x0, const VecX& x);
    /// One visit of each tie, and of each contact, normal then disc.
    void visit(const TouchingCloth& cloth, VecX& x);
    /// Solids get the velocity of δ, as particles by (27.25) and (27.15).
    void set_velocities(TouchingCloth& cloth, Real h, Real whole);
    /// (28.5): of the midpoint, whose velocities have gone on from u0, what touches does not bounce.
    void rest_in_the_middle(TouchingCloth& cloth, Real h, const VecX& u0) const;
    /// calm(); solids move by δ.
    void end(TouchingCloth& cloth, Real h);
    /// What pushed an overlap out is no velocity: a contact that pushed does not part.
    void calm(TouchingCloth& cloth, Real h) const;

    /// How far a point of a solid has moved with it if all moved by δ, or its velocity
    /// if δ is that of all. \param arm  from its centre [m]
    Vec3 way(const VecX& delta, int solid, const Vec3& arm) const
    {
        const auto k = static_cast<std::size_t>(solid);
        return delta.segment<3>(6 * solid) +
               cross(R[k] * delta.segment<3>(6 * solid + 3), arm);
    }
    /// Adds P to a solid at the end of an arm: [N s²] to a δ, [N s] to a velocity.
    void push(const TouchingCloth& cloth, VecX& delta, int solid, const Vec3& arm,
              const Vec3& P) const
    {
        const auto inverse = cloth.solids.inverse_mass.segment<6>(6 * solid);
        const auto k = static_cast<std::size_t>(solid);
        delta.segment<3>(6 * solid) += inverse.head<3>().cwiseProduct(P);
        delta.segment<3>(6 * solid + 3) +=
            inverse.tail<3>().cwiseProduct(R[k].transpose() * cross(arm, P));
    }

private:
    /// P at a tie that takes d of its particle's way on its solid.
    Vec3 tie_impulse(const TouchingCloth& cloth, const ClothTie& tie,
                     const Vec3& d) const;
    void visit_ties(const TouchingCloth& cloth, VecX& x);
};

}  // namespace rigid
