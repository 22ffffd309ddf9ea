/// \file sequential_impulse.hpp
/// Sequential impulses: projected Gauss-Seidel on the bodies' velocities, without the matrix.
///
///     w = J u + b,   u = u* + M⁻¹ Jᵀ λ,   lo ≤ λ ≤ hi,   λ_i = lo_i or λ_i = hi_i or w_i = 0
///
/// The iterates are those of chapter 4 \cite catto2005 \cite catto2006; no A is built, so memory and the time of a
/// sweep are linear in the rows whatever the rows have in common.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "chapters/06_sequential_impulse/solver_row.hpp"

#include <cstdint>

namespace rigid {

struct ImpulseSettings {
    int max_sweeps = 10;
    Real tolerance = 0;      ///< of the natural residual [m/s]; 0 = always make all sweeps, and don't measure
    bool alternate = false;  ///< every second sweep runs backwards
};

/// Memory that is kept from step to step, and what has been done with it.
template <int Dof>
struct ImpulseMemory {
    std::vector<SolverRow<Dof>> rows;
    VecX u;                   ///< Dof·(K + 1) [m/s]; the last place is the world's
    std::int64_t visits = 0;  ///< rows visited by the last solve, those of its residuals included
};

/// The natural residual of the present λ and u [m/s], (3.15), without A: the diagonal and w are all it needs.
template <int Dof>
Real natural_residual(const std::vector<SolverRow<Dof>>& rows, const VecX& u)
{
    Real largest = 0;
    for (const SolverRow<Dof>& row : rows) {
        const Real w = row.bias + row.Ja.dot(u.template segment<Dof>(row.a)) +
                       row.Jb.dot(u.template segment<Dof>(row.b));
        const Real A = row.mass > 0 ? 1 / row.mass : 0;
        const Real r = natural_residual_row(A, row.lambda, w, row.lo, row.hi);
        if (!(r <= largest)) largest = r;  // also takes over a NaN
        if (std::isnan(largest)) return largest;
    }
    return largest;
}

/// Sweeps over the rows, starting from solution.lambda; solution.iterations counts the sweeps.
///
/// `solved` is said only when the natural residual was computed and met the tolerance.
/// Does not allocate once it has seen a scene of this size.
/// \param rows      m valid rows
/// \param order     row numbers in the order of the visits; empty = as they are
/// \param u         in: u*, velocities before all impulses; out: u* + M⁻¹ Jᵀ λ [m/s]
/// \param solution  in: the λ to start from (a vector of another length means zero); out: the answer
template <int Dof>
void sequential_impulse(const std::vector<Row<Dof>>& rows, std::span<const int> order,
                        const ImpulseSettings& settings, ImpulseMemory<Dof>& memory, VecX& u,
                        Solution& solution)
{
    const auto m = static_cast<Index>(rows.size());
    const Index bodies = u.size() / Dof;
    if (solution.lambda.size() != m) solution.lambda.setZero(m);
    for (Index i = 0; i < m; ++i)
        solution.lambda[i] = std::clamp(solution.lambda[i], rows[static_cast<std::size_t>(i)].lo,
                                        rows[static_cast<std::size_t>(i)].hi);
    prepare(rows, order, bodies, solution.lambda, memory.rows);

    // Yesterday's impulses, if any, act first.
    memory.u.resize(u.size() + Dof);
    memory.u.head(u.size()) = u;
    memory.u.template tail<Dof>().setZero();
    for (const SolverRow<Dof>& row : memory.rows) {
        memory.u.template segment<Dof>(row.a) += row.Wa * row.lambda;
        memory.u.template segment<Dof>(row.b) += row.Wb * row.lambda;
    }

    memory.visits = 0;
    solution.status = Status::iteration_limit;
    solution.residual = infinity;
    int sweep = 0;
    for (; sweep < settings.max_sweeps && solution.status != Status::solved; ++sweep) {
        Real change = 0;  // the residual that each row had when it was visited [m/s]
        const auto visit_and_see = [&](SolverRow<Dof>& row) {
            const Real delta = visit(row, memory.u);
            if (row.mass > 0) change = std::max(change, std::abs(delta) / row.mass);
        };
        if (settings.alternate && sweep % 2 == 1)
            for (std::size_t k = memory.rows.size(); k-- > 0;) visit_and_see(memory.rows[k]);
        else
            for (SolverRow<Dof>& row : memory.rows) visit_and_see(row);
        memory.visits += m;
        const bool look =
            settings.tolerance > 0 && (change <= settings.tolerance || sweep + 1 == settings.max_sweeps);
        if (!look) continue;
        solution.residual = natural_residual(memory.rows, memory.u);
        memory.visits += m;
        if (solution.residual <= settings.tolerance) solution.status = Status::solved;
    }

    solution.iterations = sweep;
    for (std::size_t k = 0; k < memory.rows.size(); ++k)
        solution.lambda[order.empty() ? static_cast<Index>(k) : order[k]] = memory.rows[k].lambda;
    u = memory.u.head(u.size());
}

}  // namespace rigid
