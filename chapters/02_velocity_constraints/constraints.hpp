/// \file constraints.hpp
/// One scalar velocity constraint, the currency that all solvers deal in.
///
///     w = J u + b,   lo ≤ λ ≤ hi
///
/// A `Constraint` is what geometry knows of it at the present positions: C and its
/// derivative J, and of which kind it is. A `Row` is what a solver needs: J, what one unit of λ does to the
/// bodies, the bias and the bounds. `solve_row` answers one row exactly (2.7).
///
/// The signs: C ≥ 0 means separated, and a positive λ pushes: body b along the normal,
/// body a against it. The world is always body a.
#pragma once

#include "common/bodies.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <string>

namespace rigid {

/// What the impulse of a constraint may do, and whether C is an error to be corrected.
enum class ConstraintKind : unsigned char {
    bilateral,   ///< pushes and pulls: C = 0, and any other C is an error
    unilateral,  ///< only pushes: C ≥ 0, and C < 0 is an error
    motor,       ///< C is to grow at a given speed, as far as a force allows; C itself is no error
};

/// \f$C(x)\f$ and \f$J = \partial C / \partial x\f$ at the present positions, (2.2), and the kind of the constraint.
/// All later code asks for the kind, never for a row's place in a list.
template <int Dof>
struct Constraint {
    Index a = world;  ///< the world is always a
    Index b = 0;
    Real C = 0;  ///< ≥ 0 means separated (unilateral), = 0 means fulfilled (bilateral) [m]
    RowVec<Dof> Ja = RowVec<Dof>::Zero();  ///< block of J for body a; zero for the world
    RowVec<Dof> Jb = RowVec<Dof>::Zero();  ///< block of J for body b
    ConstraintKind kind = ConstraintKind::bilateral;
    bool bounces = false;  ///< a contact: its bodies may part faster than they need to (chapter 6)
    Real speed = 0;        ///< of a motor: the wanted J u [m/s]
    Real force = 0;        ///< of a motor: at most this, to either side [N]
};

//! [row]
/// One row of \f$w = Ju + b\f$ with the bounds of its impulse.
template <int Dof>
struct Row {
    Index a = world;
    Index b = 0;
    RowVec<Dof> Ja = RowVec<Dof>::Zero();
    RowVec<Dof> Jb = RowVec<Dof>::Zero();
    Vec<Dof> Wa = Vec<Dof>::Zero();  ///< \f$M_a^{-1} J_a^T\f$: one unit of λ changes a's velocity so [1/kg]
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

    /// \f$J M^{-1} J^T\f$ [1/kg]: how readily the row's velocity follows its impulse.
    Real inverse_effective_mass() const { return Ja.dot(Wa) + Jb.dot(Wb); }

    /// \f$u \leftarrow u + M^{-1} J^T \lambda\f$, (2.5).
    void apply(Real lambda, VecX& u) const
    {
        if (a != world) u.template segment<Dof>(Dof * a) += Wa * lambda;
        u.template segment<Dof>(Dof * b) += Wb * lambda;
    }
};
//! [row]

/// The row of a constraint, with any bounds.
/// \param constraint    C and J; C itself is not used: what to do about it is the caller's choice of bias
/// \param inverse_mass  [1/kg], length Dof·K; zero = cannot move
/// \param bias          b [m/s]
/// \param lo            least impulse [N s]
/// \param hi            greatest impulse [N s]
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

//! [row_of]
/// The row of a constraint by its kind. An impulse is a force times h, so a motor of ±F has the bounds ±hF.
/// \param bias  b [m/s]; of a motor −speed
/// \param h     time step [s]
template <int Dof>
Row<Dof> row_of(const Constraint<Dof>& constraint, const VecX& inverse_mass, Real bias, Real h)
{
    switch (constraint.kind) {
    case ConstraintKind::unilateral:
        return make_row(constraint, inverse_mass, bias, 0, infinity);
    case ConstraintKind::motor:
        return make_row(constraint, inverse_mass, bias, -h * constraint.force, h * constraint.force);
    case ConstraintKind::bilateral:
        break;
    }
    return make_row(constraint, inverse_mass, bias, -infinity, infinity);
}
//! [row_of]

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

/// What can be said of one row, or of several that have to hold together.
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
/// (2.7) and (2.20): the impulse that gives one row its wanted velocity, held within its bounds.
///
/// A row whose bodies cannot move has nothing to act on. The verdict says whether it is met as
/// it is (redundant) or whether no impulse can meet it (conflicting; λ is then zero).
/// \param u  velocities before the impulse [m/s]; they are not changed, see Row::apply()
template <int Dof>
RowAnswer solve_row(const Row<Dof>& row, const VecX& u)
{
    const Real w = row.velocity(u);
    const Real A = row.inverse_effective_mass();  // J M⁻¹ Jᵀ
    if (!(A > 0)) {
        const Real bound = w > 0 ? row.lo : w < 0 ? row.hi : std::clamp<Real>(0, row.lo, row.hi);
        if (std::isfinite(bound)) return {bound, w, Verdict::redundant};
        return {0, w, Verdict::conflicting};
    }
    const Real lambda = std::clamp(-w / A, row.lo, row.hi);
    return {lambda, w + A * lambda, Verdict::independent};
}
//! [solve_row]

/// Throws std::invalid_argument, naming the row, unless each row joins two of the bodies 0 … count − 1, or the world and
/// one of them. One pass, before the sweeps: they look at no index.
template <int Dof, class Rows>
void require_bodies(const Rows& rows, Index count)
{
    std::size_t i = 0;
    for (const Row<Dof>& row : rows) {
        if (row.b < 0 || row.b >= count || row.a < world || row.a >= count)
            throw std::invalid_argument("row " + std::to_string(i) + " joins bodies " +
                                        std::to_string(row.a) + " and " + std::to_string(row.b) +
                                        "; there are bodies 0 to " + std::to_string(count - 1) +
                                        ", and -1 as first body is the world");
        ++i;
    }
}

/// Throws std::invalid_argument, naming row and value, unless the row's numbers are finite, its
/// bodies are two of 0 … count-1 (or the world and one), and lo ≤ hi.
/// \param row    the row to look at
/// \param name   what to call it, such as "row 3"
/// \param count  number of bodies K
template <int Dof>
void require_valid(const Row<Dof>& row, const std::string& name, Index count)
{
    const auto refuse = [&name](const std::string& what) { throw std::invalid_argument(name + " " + what); };
    if (row.b < 0 || row.b >= count || row.a < world || row.a >= count)
        refuse("joins bodies " + std::to_string(row.a) + " and " + std::to_string(row.b) +
               "; there are bodies 0 to " + std::to_string(count - 1) +
               ", and -1 as first body is the world");
    if (row.a == row.b) refuse("joins body " + std::to_string(row.a) + " to itself");
    if (!row.Ja.allFinite() || !row.Jb.allFinite()) refuse("has an entry of J that is not finite");
    if (!row.Wa.allFinite() || !row.Wb.allFinite())
        refuse("has an entry of the inverse mass times J that is not finite");
    if (!std::isfinite(row.bias)) refuse("has the bias " + shortest(row.bias) + " m/s; it must be finite");
    if (!(row.lo <= row.hi))
        refuse("has the bounds lo = " + shortest(row.lo) + " and hi = " + shortest(row.hi) +
               " N s; lo must not be above hi");
}

}  // namespace rigid
