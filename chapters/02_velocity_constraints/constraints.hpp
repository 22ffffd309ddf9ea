/// \file constraints.hpp
/// One scalar velocity constraint, the currency that all solvers deal in.
///
///     w = J u + b,   lo ≤ λ ≤ hi
///
/// A `Constraint` is what geometry knows of it at the present positions: C and its
/// derivative J. A `Row` is what a solver needs: J, what one unit of λ does to the
/// bodies, the bias and the bounds.
#pragma once

#include "common/bodies.hpp"

namespace rigid {

/// \f$C(x)\f$ and \f$J = \partial C / \partial x\f$ at the present positions.
template <int Dof>
struct Constraint {
    Index a = world;  ///< the world is always a
    Index b = 0;
    Real C = 0;       ///< ≥ 0 means separated (unilateral), = 0 means fulfilled (bilateral) [m]
    RowVec<Dof> Ja = RowVec<Dof>::Zero();  ///< block of J for body a; zero for the world
    RowVec<Dof> Jb = RowVec<Dof>::Zero();  ///< block of J for body b
};

/// One row of \f$w = Ju + b\f$ with the bounds of its impulse.
template <int Dof>
struct Row {
    Index a = world;
    Index b = 0;
    RowVec<Dof> Ja = RowVec<Dof>::Zero();
    RowVec<Dof> Jb = RowVec<Dof>::Zero();
    Vec<Dof> Wa = Vec<Dof>::Zero();  ///< \f$M_a^{-1} J_a^T\f$: what one unit of λ does to the velocity of a [1/kg]
    Vec<Dof> Wb = Vec<Dof>::Zero();  ///< \f$M_b^{-1} J_b^T\f$
    Real bias = 0;                   ///< b [m/s]
    Real lo = 0;                     ///< [N s]
    Real hi = infinity;              ///< [N s]

    /// \f$J u + b\f$ [m/s]: what is left of the constraint velocity.
    Real velocity(const VecX& u) const
    {
        Real w = bias + Jb.dot(u.template segment<Dof>(Dof * b));
        if (a != world) w += Ja.dot(u.template segment<Dof>(Dof * a));
        return w;
    }

    /// \f$J M^{-1} J^T\f$ [1/kg]: how readily the row's velocity follows its impulse.
    Real compliance() const { return Ja.dot(Wa) + Jb.dot(Wb); }

    /// \f$u \leftarrow u + M^{-1} J^T \lambda\f$
    void apply(Real lambda, VecX& u) const
    {
        if (a != world) u.template segment<Dof>(Dof * a) += Wa * lambda;
        u.template segment<Dof>(Dof * b) += Wb * lambda;
    }
};

/// The row of a constraint, with any bounds.
template <int Dof>
Row<Dof> make_row(const Constraint<Dof>& constraint, const VecX& inverse_mass, Real bias, Real lo, Real hi)
{
    Row<Dof> row;
    row.a = constraint.a;
    row.b = constraint.b;
    row.Ja = constraint.Ja;
    row.Jb = constraint.Jb;
    if (row.a != world)
        row.Wa = inverse_mass.template segment<Dof>(Dof * row.a).cwiseProduct(row.Ja.transpose());
    row.Wb = inverse_mass.template segment<Dof>(Dof * row.b).cwiseProduct(row.Jb.transpose());
    row.bias = bias;
    row.lo = lo;
    row.hi = hi;
    return row;
}

/// \f$w = 0\f$: the impulse may push and pull.
template <int Dof>
Row<Dof> bilateral(const Constraint<Dof>& constraint, const VecX& inverse_mass, Real bias = 0)
{
    return make_row(constraint, inverse_mass, bias, -infinity, infinity);
}

/// \f$0 \le \lambda \perp w \ge 0\f$: the impulse may only push.
template <int Dof>
Row<Dof> unilateral(const Constraint<Dof>& constraint, const VecX& inverse_mass, Real bias = 0)
{
    return make_row(constraint, inverse_mass, bias, 0, infinity);
}

}  // namespace rigid
