/// \file space_friction.hpp
/// The rows of a contact's friction in space.
///
///     tangent   the J of (23.3) with t₁ and t₂ across n, and both arms to the point between the surfaces         (24.1)
///     turn      J = (0, −ℓ R_aᵀe),  (0, ℓ R_bᵀe) with e = t₁ and t₂, which rolling is about, and e = n        (24.6)
#pragma once

#include "chapters/23_faces_that_touch/space_contact.hpp"

namespace rigid {

/// The rows of a contact besides that of its normal: Source::part.
enum SpacePart : int {
    first_tangent = push_part + 1,  ///< and, next to it, the second
    second_tangent,
    first_roll,
    second_roll,
    spin_part
};

//! [drag]
/// (24.1): friction along t₁ or t₂. Both bodies are dragged at one point, between
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

/// (24.6): a moment against rolling, about t₁ or t₂, or against spinning about n.
/// Its w is a speed like that of the other rows, at the distance ℓ.
/// \param length  ℓ [m]
Constraint<6> turn_constraint(const SpaceContact& contact, const ContactPlace& p,
                              SpacePart part, int number, Real length);

}  // namespace rigid
