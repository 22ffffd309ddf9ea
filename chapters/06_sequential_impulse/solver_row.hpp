/// \file solver_row.hpp
/// One row as a sweep reads it, and the visit: solve it for its own impulse on the bodies' velocities, clamp
/// the accumulated impulse, apply the difference.
///
///     Δλ = clamp(λ − w / A_ii, lo, hi) − λ,   w = J u + b,   u ← u + M⁻¹ Jᵀ Δλ
///
/// The rows lie in memory in the order of the visits, each with its λ, so that a sweep reads forward.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"

#include <cmath>
#include <span>
#include <vector>

namespace rigid {

template <int Dof>
struct SolverRow {
    RowVec<Dof> Ja, Jb;  ///< blocks of J; zero for what cannot be moved
    Vec<Dof> Wa, Wb;     ///< \f$M^{-1} J^T\f$ [1/kg]
    Real bias;           ///< b [m/s]
    Real mass;           ///< effective mass 1 / A_ii [kg]; 0 = no impulse changes this row
    Real lo, hi;         ///< bounds of λ [N s]
    Real lambda;         ///< accumulated impulse [N s]
    int a, b;            ///< where the velocities of the bodies begin; the world has a place of its own
};

/// The rows in the order of the visits. The world's velocity stands behind those of the K bodies and stays zero,
/// so that no visit has to ask.
/// \param rows    m valid rows
/// \param order   row numbers in the order of the visits; empty = as they are
/// \param bodies  K
/// \param lambda  m: the impulses to begin with [N s]
/// \param out     m rows; memory is kept
template <int Dof>
void prepare(const std::vector<Row<Dof>>& rows, std::span<const int> order, Index bodies, const VecX& lambda,
             std::vector<SolverRow<Dof>>& out)
{
    out.resize(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const std::size_t i = order.empty() ? k : static_cast<std::size_t>(order[k]);
        const Row<Dof>& row = rows[i];
        SolverRow<Dof>& visited = out[k];
        visited.Ja = row.Ja;
        visited.Jb = row.Jb;
        visited.Wa = row.Wa;
        visited.Wb = row.Wb;
        visited.bias = row.bias;
        const Real A = row.compliance();
        visited.mass = A > 0 ? 1 / A : 0;
        visited.lo = row.lo;
        visited.hi = row.hi;
        visited.lambda = lambda[static_cast<Index>(i)];
        visited.a = static_cast<int>(Dof * (row.a == world ? bodies : row.a));
        visited.b = static_cast<int>(Dof * row.b);
    }
}

//! [visit]
/// One visit of one row. u has Dof·(K + 1) numbers, the last Dof of them zero.
/// \return  Δλ [N s]
template <int Dof>
Real visit(SolverRow<Dof>& row, VecX& u)
{
    auto ua = u.template segment<Dof>(row.a);
    auto ub = u.template segment<Dof>(row.b);
    const Real w = row.bias + row.Ja.dot(ua) + row.Jb.dot(ub);
    Real lambda = row.lambda - row.mass * w;
    lambda = lambda < row.lo ? row.lo : lambda;
    lambda = lambda > row.hi ? row.hi : lambda;
    const Real change = lambda - row.lambda;
    row.lambda = lambda;
    ua += row.Wa * change;
    ub += row.Wb * change;
    return change;
}
//! [visit]

}  // namespace rigid
