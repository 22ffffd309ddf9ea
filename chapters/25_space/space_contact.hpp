/// \file space_contact.hpp
/// A contact in space: a point of either body and a normal; its row, and the rows of its friction.
///
///     normal    C = n·(p_b − p_a) − ρ_a − ρ_b,   J = (−n, −R_aᵀ(r_a × n)),  (n, R_bᵀ(r_b × n))             (25.34)
///     tangent   the same J with t₁ and t₂ across n, and both arms to the point between the surfaces       (25.35)
///     turn      J = (0, −ℓ R_aᵀe),  (0, ℓ R_bᵀe) with e = t₁ and t₂, which rolling is about, and e = n        (25.43)
///
/// The points are fixed in the bodies, where the cores touch. So a ball's is its centre: it may roll, and the gap stays.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/08_warm_starting/impulse_cache.hpp"
#include "chapters/25_space/space_scene.hpp"

namespace rigid {

/// The rows of a contact: Source::part.
enum SpacePart : int {
    push_part = 0,
    first_tangent,  ///< and, next to it, the second
    second_tangent,
    first_roll,
    second_roll,
    spin_part
};

//! [row]
/// n·(velocity of the point at x + r) of a body with the axes R, as a row.
inline RowVec<6> point_row(const Mat3& R, const Vec3& r, const Vec3& n)
{
    RowVec<6> row;
    row << n.transpose(), (R.transpose() * cross(r, n)).transpose();
    return row;
}
//! [row]

/// Where the two points of a contact are at the positions x, with the arms to them.
struct ContactPlace {
    Mat3 Ra, Rb;
    Vec3 arm_a, arm_b, way;      ///< from the centroids; way = p_b − p_a
    Index a = world, b = world;  ///< whose rotations these are
};

/// \param p  the place of another contact, which may be of the same bodies, or none
void find_place(const SpaceContact& contact, const VecX& x, ContactPlace& p);

inline ContactPlace place_of(const SpaceContact& contact, const VecX& x)
{
    ContactPlace p;
    find_place(contact, x, p);
    return p;
}

//! [push]
/// (25.34): the gap and its derivative.
inline Constraint<6> push_constraint(const SpaceContact& contact,
                                     const ContactPlace& p)
{
    Constraint<6> c;
    c.a = contact.a, c.b = contact.b;
    c.C = contact.normal.dot(p.way) - contact.radius_a - contact.radius_b;
    c.Jb = point_row(p.Rb, p.arm_b, contact.normal);
    if (c.a != world) c.Ja = -point_row(p.Ra, p.arm_a, contact.normal);
    c.kind = ConstraintKind::unilateral;
    c.bounces = true;
    return c;
}
//! [push]

//! [drag]
/// (25.35): friction along t₁ or t₂. Both bodies are dragged at one point, between
/// the surfaces.
/// \param number  of the contact's normal among the constraints of the step
inline Constraint<6> drag_constraint(const SpaceContact& contact,
                                     const ContactPlace& p, SpacePart part,
                                     int number)
{
    const Vec3& n = contact.normal;
    const Vec3 t1 = across(n), t = part == first_tangent ? t1 : cross(n, t1);
    const Real gap = n.dot(p.way) - contact.radius_a - contact.radius_b;
    const Vec3 arm_b = p.arm_b - (contact.radius_b + gap / 2) * n;
    Constraint<6> c;
    c.a = contact.a, c.b = contact.b;
    c.Jb = point_row(p.Rb, arm_b, t);
    // the same point, from a
    const Vec3 arm_a = arm_b + p.way + p.arm_a - p.arm_b;
    if (c.a != world) c.Ja = -point_row(p.Ra, arm_a, t);
    c.kind = ConstraintKind::friction;
    c.bounded_by = number;
    c.friction = contact.grip.friction;
    return c;
}
//! [drag]

/// (25.43): a moment against rolling, about t₁ or t₂, or against spinning about n.
/// Its w is a speed like that of the other rows, at the distance ℓ.
/// \param length  ℓ [m]
Constraint<6> turn_constraint(const SpaceContact& contact, const ContactPlace& p,
                              SpacePart part, int number, Real length);

/// Chapter 8's name of a row.
inline ImpulseKey contact_key(const SpaceContact& contact, int part = 0)
{
    return {static_cast<std::int32_t>(contact.a),
            static_cast<std::int32_t>(contact.b),
            static_cast<std::int32_t>(contact.feature), part};
}

}  // namespace rigid
