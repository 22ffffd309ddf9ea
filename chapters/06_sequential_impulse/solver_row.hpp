/// \file solver_row.hpp
/// One row as a sweep reads it, and the visit: solve it for its own impulse on the bodies' velocities, clamp
/// the accumulated impulse, apply the difference.
///
///     Δλ = clamp(λ − w / A_ii, lo, hi) − λ,   w = J u + b,   u ← u + M⁻¹ Jᵀ Δλ
///
/// (6.3) to (6.5). The rows lie in memory in the order of the visits, each with its λ, so that a sweep reads
/// forward. \cite catto2005 \cite catto2006
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"

#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

template <int Dof>
struct SolverRow {
    RowVec<Dof> Ja, Jb;  ///< blocks of J
    Vec<Dof> Wa, Wb;     ///< \f$M^{-1} J^T\f$ [1/kg]
    Real bias;           ///< b [m/s]
    /// effective mass 1 / A_ii [kg]; 0 = no impulse changes this row
    Real mass;
    Real lo, hi;  ///< bounds of λ [N s]
    Real lambda;  ///< accumulated impulse [N s]
    /// where the velocities of the bodies begin; a row of the world has a = b and
    /// Ja = 0
    int a, b;
};

/// The rows in the order of the visits.
///
/// The world never moves, so its velocity is a constant zero and has no place in memory: if it had one, each row
/// against the world would write its zeros there, and the next would wait for them.
/// \param rows    m valid rows
/// \param order   row numbers in the order of the visits; empty = as they are
/// \param lambda  m: the impulses to begin with [N s]
/// \param out     m rows; memory is kept
template <int Dof>
void prepare(const std::vector<Row<Dof>>& rows, std::span<const int> order,
             const VecX& lambda, std::vector<SolverRow<Dof>>& out)
{
    out.resize(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const std::size_t i =
            order.empty() ? k : static_cast<std::size_t>(order[k]);
        const Row<Dof>& row = rows[i];
        SolverRow<Dof>& visited = out[k];
        visited.Jb = row.Jb;
        visited.Wb = row.Wb;
        visited.b = static_cast<int>(Dof * row.b);
        //! [world]
        if (row.a == world) {
            visited.Ja.setZero();
            visited.Wa.setZero();
            visited.a = visited.b;
        } else {
            visited.Ja = row.Ja;
            visited.Wa = row.Wa;
            visited.a = static_cast<int>(Dof * row.a);
        }
        //! [world]
        const Real A =
            visited.Ja.dot(visited.Wa) + visited.Jb.dot(visited.Wb) + row.softness;
        visited.mass = A > 0 ? 1 / A : 0;
        visited.bias = row.bias;
        visited.lo = row.lo;
        visited.hi = row.hi;
        visited.lambda = lambda[static_cast<Index>(i)];
    }
}

/// Throws std::invalid_argument unless the order is empty or names each of m rows once.
/// \param seen  memory
void require_order(std::span<const int> order, std::size_t m,
                   std::vector<char>& seen);

/// \f$J u + b\f$ [m/s]. The sums of both bodies are made side by side.
template <int Dof>
inline Real velocity(const SolverRow<Dof>& row, const Vec<Dof>& ua,
                     const Vec<Dof>& ub)
{
    return row.bias + (row.Ja.transpose().cwiseProduct(ua) +
                       row.Jb.transpose().cwiseProduct(ub))
                          .sum();
}

//! [visit]
/// One visit of one row, (6.3) to (6.5).
/// \param u  Dof·K [m/s]
/// \return   Δλ [N s]
template <int Dof>
inline Real visit(SolverRow<Dof>& row, VecX& u)
{
    const Vec<Dof> ua = u.template segment<Dof>(row.a);
    const Vec<Dof> ub = u.template segment<Dof>(row.b);
    const Real w = velocity(row, ua, ub);
    // (6.3): the total that brings w to zero
    Real lambda = row.lambda - row.mass * w;
    // (6.4): clamp the sum, not the correction
    lambda = lambda < row.lo ? row.lo : lambda;
    lambda = lambda > row.hi ? row.hi : lambda;
    const Real change = lambda - row.lambda;
    row.lambda = lambda;
    u.template segment<Dof>(row.a) =
        ua + row.Wa * change;  // (6.5); b comes last: a row of the world has a = b
    u.template segment<Dof>(row.b) = ub + row.Wb * change;
    return change;
}
//! [visit]

//! [sweep]
/// Visits each row once.
/// \param tolerance  [m/s]
/// \return           how many rows were found off by more than the tolerance,
///     expressed as the velocity Δλ_i A_ii
template <int Dof>
int sweep(std::span<SolverRow<Dof>> rows, VecX& u, Real tolerance,
          bool backwards = false)
{
    int changed = 0;
    const std::ptrdiff_t step = backwards ? -1 : 1;
    SolverRow<Dof>* row =
        rows.data() +
        (backwards ? static_cast<std::ptrdiff_t>(rows.size()) - 1 : 0);
    // a NaN counts
    for (std::size_t k = rows.size(); k > 0; --k, row += step)
        changed += !(std::abs(visit(*row, u)) <= tolerance * row->mass);
    return changed;
}
//! [sweep]

// Compiled once, in solver_row.cpp.
#define RIGID_SOLVER_ROW(TEMPLATE, Dof)                                            \
    TEMPLATE void prepare(const std::vector<Row<Dof>>&, std::span<const int>,      \
                          const VecX&, std::vector<SolverRow<Dof>>&);              \
    TEMPLATE int sweep(std::span<SolverRow<Dof>>, VecX&, Real, bool);
RIGID_SOLVER_ROW(extern template, 2)
RIGID_SOLVER_ROW(extern template, 3)
RIGID_SOLVER_ROW(extern template, 6)

}  // namespace rigid
