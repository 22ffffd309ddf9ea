/// \file curves.hpp
/// A bead on a wire: body k stays on the curve g(x) = 0.
///
///     C = g(x_k),   J = ∇g(x_k)ᵀ
///
/// (2.9). The curve may be a circle, an ellipse, or any function of the reader's own, with a
/// gradient that is given or that automatic differentiation finds.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "common/text.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <unsupported/Eigen/AutoDiff>

namespace rigid {

//! [curve]
/// (2.9): body k stays where g is zero.
/// \param x         positions [m]
/// \param k         the body
/// \param g         any callable: a point to a number
/// \param gradient  any callable: a point to the gradient of g there
template <class G, class Gradient>
Constraint<2> curve_constraint(const VecX& x, Index k, const G& g,
                               const Gradient& gradient)
{
    const Vec2 p = x.segment<2>(2 * k);
    const Vec2 J = gradient(p);
    return {world, k, g(p), RowVec<2>::Zero(), J.transpose()};
}

/// The same without a gradient: g is evaluated once, on numbers that carry their
/// derivative.
/// \param x  positions [m]
/// \param k  the body
/// \param g  a callable that takes a 2-vector of any number type T and returns a T
template <class G>
Constraint<2> curve_constraint(const VecX& x, Index k, const G& g)
{
    using Dual = Eigen::AutoDiffScalar<Vec2>;  // a value and its two derivatives
    const Eigen::Matrix<Dual, 2, 1> p(Dual(x[2 * k], 2, 0),
                                      Dual(x[2 * k + 1], 2, 1));
    const Dual value = g(p);
    return {world, k, value.value(), RowVec<2>::Zero(),
            value.derivatives().transpose()};
}
//! [curve]

//! [circle]
/// (2.10): a circle about the origin, \f$C = (x^T x - r^2) / 2r\f$ [m]. The divisor
/// makes J a unit vector on the wire. Throws std::invalid_argument unless the
/// radius is positive.
inline Constraint<2> circle_constraint(const VecX& x, Index k, Real radius)
{
    if (!(radius > 0))
        throw std::invalid_argument("the radius of the wire is " +
                                    shortest(radius) + " m; it must be positive");
    const Vec2 p = x.segment<2>(2 * k);
    return {world, k, (p.squaredNorm() - radius * radius) / (2 * radius),
            RowVec<2>::Zero(), p.transpose() / radius};
}
//! [circle]

/// (2.11): an ellipse about the origin with the semi-axes \f$a_1, a_2\f$ along x and y,
/// \f$C = \tfrac12 (x^2/a_1^2 + y^2/a_2^2 - 1)\f$, a pure number; see normalised().
/// Throws std::invalid_argument unless both semi-axes are positive.
inline Constraint<2> ellipse_constraint(const VecX& x, Index k,
                                        const Vec2& half_axes)
{
    if (!(half_axes.minCoeff() > 0))
        throw std::invalid_argument("the shorter semi-axis of the wire is " +
                                    shortest(half_axes.minCoeff()) +
                                    " m; both must be positive");
    const Vec2 p = x.segment<2>(2 * k);
    const Vec2 gradient = p.cwiseQuotient(half_axes.cwiseAbs2());
    return {world, k, (gradient.dot(p) - 1) / 2, RowVec<2>::Zero(),
            gradient.transpose()};
}

/// The same constraint divided by ‖J‖: C is then, near the curve, the distance from it [m], and
/// λ is the size of the impulse [N s]. The velocity that a solver finds is the same.
/// A zero gradient (the centre of a circle) is left alone.
inline Constraint<2> normalised(Constraint<2> constraint)
{
    const Real length =
        std::sqrt(constraint.Ja.squaredNorm() + constraint.Jb.squaredNorm());
    if (!(length > 0)) return constraint;
    constraint.C /= length;
    constraint.Ja /= length;
    constraint.Jb /= length;
    return constraint;
}

}  // namespace rigid
