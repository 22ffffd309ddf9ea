/// \file space_contact.hpp
/// A contact in space: a point of either body and a normal; and its row.
///
///     C = n·(p_b − p_a) − ρ_a − ρ_b,   J = (−n, −R_aᵀ(r_a × n)),  (n, R_bᵀ(r_b × n))                       (23.3)
///
/// The points are fixed in the bodies, where the cores touch. So a ball's is its centre: it may roll, and the gap stays.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/20_turning_in_space/solid_scene.hpp"

namespace rigid {

/// The row of a contact's normal: Source::part. (Those of its friction are chapter 24's.)
inline constexpr int push_part = 0;

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
/// (23.3): the gap and its derivative.
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

}  // namespace rigid
