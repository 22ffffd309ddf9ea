/// \file exact_island.hpp
/// A small island solved exactly, by chapter 9, from where its λ stand.
///
///     w' = w + A Δ,   lo − λ ≤ Δ ≤ hi − λ,   Δ complementary to w'
///
/// (10.6): the problem of the correction Δ, whose answer is near zero when yesterday's λ still fits. Memory is kept for
/// each number of rows, so that islands of different sizes don't take it from each other.
#pragma once

#include "chapters/09_active_sets/active_sets.hpp"
#include "chapters/10_skipping_work/island_solver.hpp"

namespace rigid {

/// What is kept for islands of one number of rows.
struct ExactScratch {
    Mlcp mlcp;  ///< A is stored full: n columns in each line
    ActiveSetMemory memory;
    Solution solution;
};

/// J_i M⁻¹ J_jᵀ of two rows of bodies that both may share.
template <int Dof>
Real coupling(const SolverRow<Dof>& i, const SolverRow<Dof>& j)
{
    Real sum = 0;
    if (i.a == j.a) sum += i.Ja.dot(j.Wa);
    if (i.a == j.b) sum += i.Ja.dot(j.Wb);
    if (i.b == j.a) sum += i.Jb.dot(j.Wa);
    if (i.b == j.b) sum += i.Jb.dot(j.Wb);
    return sum;
}

/// Solves these rows exactly; λ and u are changed only if that is `solved`. `sweeps` counts guesses.
/// \param enough   if the natural residual is below this as it is, there is nothing to solve [m/s]
/// \param scratch  one for each number of rows; grows
template <int Dof>
IslandAnswer solve_exactly(std::span<SolverRow<Dof>> rows, Real enough, std::vector<ExactScratch>& scratch,
                           VecX& u)
{
    IslandAnswer answer;
    answer.residual = natural_residual(std::span<const SolverRow<Dof>>(rows), u);
    answer.visits = static_cast<std::int64_t>(rows.size());
    if (answer.residual <= enough) {
        answer.status = Status::solved;
        return answer;
    }
    if (scratch.size() <= rows.size()) scratch.resize(rows.size() + 1);
    auto& [mlcp, memory, solution] = scratch[rows.size()];
    const auto n = static_cast<Index>(rows.size());
    if (mlcp.size() != n) {
        mlcp.A = MatX::Ones(n, n).sparseView();
        mlcp.q = mlcp.lo = mlcp.hi = VecX::Zero(n);
    }
    //! [correction]
    for (Index i = 0; i < n; ++i) {
        const SolverRow<Dof>& row = rows[static_cast<std::size_t>(i)];
        for (Index j = 0; j <= i; ++j)
            mlcp.A.valuePtr()[i * n + j] = mlcp.A.valuePtr()[j * n + i] =
                coupling(row, rows[static_cast<std::size_t>(j)]);
        mlcp.q[i] = velocity<Dof>(row, u.template segment<Dof>(row.a), u.template segment<Dof>(row.b));
        mlcp.lo[i] = row.lo - row.lambda;
        mlcp.hi[i] = row.hi - row.lambda;
    }
    active_sets(mlcp, {}, memory, solution);
    //! [correction]
    answer.status = solution.status;
    answer.residual = solution.residual;
    answer.sweeps = solution.iterations;
    if (answer.status != Status::solved) return answer;
    for (Index i = 0; i < n; ++i) {
        SolverRow<Dof>& row = rows[static_cast<std::size_t>(i)];
        row.lambda = std::clamp(row.lambda + solution.lambda[i], row.lo, row.hi);
        u.template segment<Dof>(row.a) += row.Wa * solution.lambda[i];
        u.template segment<Dof>(row.b) += row.Wb * solution.lambda[i];
    }
    return answer;
}

}  // namespace rigid
