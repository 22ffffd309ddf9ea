/// \file geometry.hpp
/// The constraints between discs: C by geometry, J by the chain rule.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "common/contact.hpp"
#include "common/shapes.hpp"

namespace rigid {

/// Two bodies keep their distance: \f$C = \lVert x_b - x_a \rVert - L\f$.
/// Two centres in one point have no direction; J then points along y.
inline Constraint<2> distance_constraint(const VecX& x, const Link& link)
{
    const Vec2 d = x.segment<2>(2 * link.b) - x.segment<2>(2 * link.a);
    const Real length = d.norm();
    const Vec2 n = length > 0 ? Vec2(d / length) : Vec2(0, 1);
    return {link.a, link.b, length - link.length, -n.transpose(), n.transpose()};
}

/// Two discs, or a disc and a wall, stay apart: C is the gap.
inline Constraint<2> contact_constraint(const Contact& contact)
{
    const RowVec<2> n = contact.normal.transpose();
    return {contact.a, contact.b, contact.gap, contact.a == world ? RowVec<2>::Zero() : RowVec<2>(-n), n};
}

}  // namespace rigid
