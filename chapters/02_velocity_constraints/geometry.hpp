/// \file geometry.hpp
/// The constraints between bodies and the world: C by geometry, J by the chain rule.
///
///     distance    C = ‖x_b − x_a‖ − L              J = (−nᵀ, nᵀ),  n = (x_b − x_a)/‖x_b − x_a‖
///     anchor      C = ‖x_b − p‖ − L                J = nᵀ,         n = (x_b − p)/‖x_b − p‖
///     alignment   C = nᵀ(x_b − x_a) − c            J = (−nᵀ, nᵀ)
///     linear      C = n_aᵀ x_a + n_bᵀ x_b − c      J = (n_aᵀ, n_bᵀ)
///     rope        C = L − ‖x_a − p‖ − ‖x_b − q‖    J = (−n_aᵀ, −n_bᵀ)
///     contact     C = gap                          J = (−nᵀ, nᵀ)
///
/// Each is derived in the text (2.12) to (2.17) and checked in the tests against automatic
/// differentiation. Curves are in curves.hpp.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "common/contact.hpp"
#include "common/shapes.hpp"

namespace rigid {

/// d/‖d‖ and ‖d‖. What is shorter than 10⁻⁷⁵ has no direction; it is given y.
struct Direction {
    Vec2 n;       ///< unit vector
    Real length;  ///< [m]

    explicit Direction(const Vec2& d) : n(0, 1), length(d.norm())
    {
        n = direction_of(d, length, n);
    }
};

/// (2.13): two bodies keep their distance, \f$C = \lVert x_b - x_a \rVert - L\f$.
/// Two centres in one point have no direction; J then points along y.
inline Constraint<2> distance_constraint(const VecX& x, const Link& link)
{
    const Direction d(x.segment<2>(2 * link.b) - x.segment<2>(2 * link.a));
    return {link.a, link.b, d.length - link.length, -d.n.transpose(),
            d.n.transpose()};
}

/// (2.13) against the world: body k keeps its distance L from a point that does not move.
inline Constraint<2> anchor_constraint(const VecX& x, Index k, const Vec2& anchor,
                                       Real length)
{
    const Direction d(x.segment<2>(2 * k) - anchor);
    return {world, k, d.length - length, RowVec<2>::Zero(), d.n.transpose()};
}

//! [alignment]
/// (2.14): the distance from a to b along one direction is given, \f$C = n^T(x_b -
/// x_a) - c\f$. With a = world it is the place itself, \f$C = n^T x_b - c\f$: a
/// rail, a lift shaft, a floor.
template <int Dof>
Constraint<Dof> alignment_constraint(const VecX& x, Index a, Index b,
                                     const Vec<Dof>& n, Real offset)
{
    Constraint<Dof> row{a, b, n.dot(x.template segment<Dof>(Dof * b)) - offset,
                        RowVec<Dof>::Zero(), n.transpose()};
    if (a == world) return row;
    row.C -= n.dot(x.template segment<Dof>(Dof * a));
    row.Ja = -n.transpose();
    return row;
}
//! [alignment]

/// (2.15): a linear relation, \f$C = n_a^T x_a + n_b^T x_b - c\f$: gears, racks, a rope that winds up.
template <int Dof>
Constraint<Dof> linear_constraint(const VecX& x, Index a, const Vec<Dof>& na,
                                  Index b, const Vec<Dof>& nb, Real offset)
{
    const Real C = na.dot(x.template segment<Dof>(Dof * a)) +
                   nb.dot(x.template segment<Dof>(Dof * b)) - offset;
    return {a, b, C, na.transpose(), nb.transpose()};
}

/// (2.16): a rope of length L runs from body a over two points of the world, p and q, to body b.
/// C is its slack, \f$C = L - \lVert x_a - p \rVert - \lVert x_b - q \rVert\f$: a rope pulls, hence
/// `unilateral`; where it is known to be taut, `bilateral`. The part between p and q doesn't count.
inline Constraint<2> rope_constraint(const VecX& x, Index a, const Vec2& p, Index b,
                                     const Vec2& q, Real length)
{
    const Direction da(x.segment<2>(2 * a) - p);
    const Direction db(x.segment<2>(2 * b) - q);
    return {a,
            b,
            length - da.length - db.length,
            -da.n.transpose(),
            -db.n.transpose(),
            ConstraintKind::unilateral};
}

//! [contact]
/// (2.17): two discs, or a disc and a wall, stay apart: C is the gap, n the normal
/// from a to b.
inline Constraint<2> contact_constraint(const Contact& contact)
{
    const RowVec<2> n = contact.normal.transpose();
    const RowVec<2> on_a = contact.a == world ? RowVec<2>::Zero() : RowVec<2>(-n);
    return {contact.a, contact.b, contact.gap, on_a, n, ConstraintKind::unilateral,
            true};
}
//! [contact]

}  // namespace rigid
