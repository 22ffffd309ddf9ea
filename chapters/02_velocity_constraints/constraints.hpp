/// \file constraints.hpp
/// One scalar velocity constraint, the currency that all solvers deal in.
///
///     w = J u + b,   lo ≤ λ ≤ hi
///
/// A `Constraint` is what geometry gives (constraint_kinds.hpp). A `Row` is what a solver needs: J, what one
/// unit of λ does to the bodies, the bias and the bounds. `solve_row` answers one row exactly (2.7).
///
/// The signs: C ≥ 0 means separated, and a positive λ pushes: body b along the normal,
/// body a against it. The world is always body a.
#pragma once

#include "chapters/02_velocity_constraints/constraint_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigid {

//! [row]
/// One row of \f$w = Ju + b\f$ with the bounds of its impulse.
template <int Dof>
struct Row {
    Index a = world;
    Index b = 0;
    RowVec<Dof> Ja = RowVec<Dof>::Zero();
    RowVec<Dof> Jb = RowVec<Dof>::Zero();
    /// \f$M_a^{-1} J_a^T\f$: one unit of λ changes a's velocity so [1/kg]
    Vec<Dof> Wa = Vec<Dof>::Zero();
    Vec<Dof> Wb = Vec<Dof>::Zero();  ///< \f$M_b^{-1} J_b^T\f$ [1/kg]
    Real bias = 0;                   ///< b [m/s]
    Real lo = 0;                     ///< [N s]
    Real hi = infinity;              ///< [N s]

    /// \f$J u + b\f$ [m/s]: what is left of the constraint velocity, (2.3).
    Real velocity(const VecX& u) const
    {
        Real w = bias + Jb.dot(u.template segment<Dof>(Dof * b));
        if (a != world) w += Ja.dot(u.template segment<Dof>(Dof * a));
        return w;
    }

    /// \f$J M^{-1} J^T\f$ [1/kg]: how readily the row's velocity follows its
    /// impulse.
    Real inverse_effective_mass() const { return Ja.dot(Wa) + Jb.dot(Wb); }

    /// \f$A_{ii} = J M^{-1} J^T + \gamma\f$ [1/kg]: what one unit of λ does to the
    /// row's own w.
    Real diagonal() const { return inverse_effective_mass() + softness; }

    /// \f$u \leftarrow u + M^{-1} J^T \lambda\f$, (2.5).
    void apply(Real lambda, VecX& u) const
    {
        if (a != world) u.template segment<Dof>(Dof * a) += Wa * lambda;
        u.template segment<Dof>(Dof * b) += Wb * lambda;
    }

    // Of rows that follow an impulse (chapters 13 and 16); until then they stay as
    // they are here.
    /// γ ≥ 0 [1/kg]: w = J u + b + γ λ, so that the row gives way under its impulse
    Real softness = 0;
    /// the row n whose impulse bounds this one, |λ| ≤ μ λ_n; −1: lo and hi do
    int bounded_by = -1;
    Real friction = 0;  ///< μ ≥ 0
};
//! [row]

/// The row of a constraint, with any bounds.
/// \param constraint    C and J; C itself is not used: what to do about it is the caller's choice of bias
/// \param inverse_mass  [1/kg], length Dof·K; zero = cannot move
/// \param bias          b [m/s]
/// \param lo            least impulse [N s]
/// \param hi            greatest impulse [N s]
template <int Dof>
Row<Dof> make_row(const Constraint<Dof>& constraint, const VecX& inverse_mass,
                  Real bias, Real lo, Real hi)
{
    Row<Dof> row;
    row.a = constraint.a;
    row.b = constraint.b;
    row.Ja = constraint.Ja;
    row.Jb = constraint.Jb;
    if (row.a != world)
        row.Wa = inverse_mass.template segment<Dof>(Dof * row.a)
                     .cwiseProduct(row.Ja.transpose());
    row.Wb = inverse_mass.template segment<Dof>(Dof * row.b)
                 .cwiseProduct(row.Jb.transpose());
    row.bias = bias;
    row.lo = lo;
    row.hi = hi;
    return row;
}

//! [row_of]
/// The row of a constraint by its kind. An impulse is a force times h, so a motor
/// of ±F has the bounds ±hF.
/// \param bias  b [m/s]; of a kind without an error own_bias()
/// \param h     time step [s]
template <int Dof>
Row<Dof> row_of(const Constraint<Dof>& constraint, const VecX& inverse_mass,
                Real bias, Real h)
{
    const bool pulls = constraint.kind != ConstraintKind::unilateral;
    Row<Dof> row =
        make_row(constraint, inverse_mass, bias, pulls ? -infinity : 0, infinity);
    switch (constraint.kind) {
    case ConstraintKind::bilateral:
    case ConstraintKind::unilateral:
        break;
    case ConstraintKind::motor:
        row.hi = h * constraint.force;
        row.lo = -row.hi;
        break;
    case ConstraintKind::friction:
        row.bounded_by = constraint.bounded_by;
        row.friction = constraint.friction;
        break;
    case ConstraintKind::spring:
        row.softness = 1 / (h * (h * constraint.stiffness + constraint.damping));
        if (!(constraint.force > 0)) break;
        row.hi = h * constraint.force;
        row.lo = -h * constraint.force;
        break;
    case ConstraintKind::inerter:
        row.softness = 1 / constraint.inertance;
        break;
    }
    return row;
}
//! [row_of]

/// What a row's impulse may be, given the impulses of all rows: between its lo and hi, or within ±μ λ_n.
template <int Dof>
std::pair<Real, Real> bounds_of(const Row<Dof>& row, const VecX& lambda)
{
    if (row.bounded_by < 0) return {row.lo, row.hi};
    const Real most = row.friction * std::max(Real{0}, lambda[row.bounded_by]);
    return {-most, most};
}

/// \f$w = 0\f$: the impulse may push and pull.
template <int Dof>
Row<Dof> bilateral(const Constraint<Dof>& constraint, const VecX& inverse_mass,
                   Real bias = 0)
{
    return make_row(constraint, inverse_mass, bias, -infinity, infinity);
}

/// \f$0 \le \lambda \perp w \ge 0\f$: the impulse may only push.
template <int Dof>
Row<Dof> unilateral(const Constraint<Dof>& constraint, const VecX& inverse_mass,
                    Real bias = 0)
{
    return make_row(constraint, inverse_mass, bias, 0, infinity);
}

/// The verdict on one row, or on several that have to hold together.
enum class Verdict {
    independent,  ///< every w is as wanted, by exactly one λ
    redundant,    ///< every w is as wanted, by many λ
    conflicting,  ///< no velocity gives every w that is wanted
};

/// The answer to one row.
struct RowAnswer {
    Real lambda = 0;  ///< [N s]
    Real w = 0;       ///< \f$Ju + b\f$ after the impulse [m/s]
    Verdict verdict = Verdict::independent;
};

//! [solve_row]
/// (2.7) and (2.20): the impulse that gives one row its wanted velocity, held
/// within its bounds.
///
/// A row whose bodies cannot move has nothing to act on. The verdict is whether it
/// is met as it is (redundant) or whether no impulse can meet it (conflicting; λ is
/// then zero).
/// \param u  velocities before the impulse [m/s]; they are not changed, see
///           Row::apply()
template <int Dof>
RowAnswer solve_row(const Row<Dof>& row, const VecX& u)
{
    const Real w = row.velocity(u);
    const Real A = row.diagonal();  // J M⁻¹ Jᵀ
    if (!(A > 0)) {
        const Real bound = w > 0   ? row.lo
                           : w < 0 ? row.hi
                                   : std::clamp<Real>(0, row.lo, row.hi);
        if (std::isfinite(bound)) return {bound, w, Verdict::redundant};
        return {0, w, Verdict::conflicting};
    }
    const Real lambda = std::clamp(-w / A, row.lo, row.hi);
    return {lambda, w + A * lambda, Verdict::independent};
}
//! [solve_row]

}  // namespace rigid
