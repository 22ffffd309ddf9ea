/// \file exact_island.hpp
/// A small island solved exactly from where its λ stand: one or two rows in closed form, more by chapter 9.
///
///     w' = w + A Δ,   lo − λ ≤ Δ ≤ hi − λ,   Δ complementary to w'
///
/// (10.10): the problem of the correction Δ, whose answer is near zero when the previous λ still fits. The answer depends on
/// the island's own rows, λ and u alone: room is kept for each number of rows, but no guess.
#pragma once

#include "chapters/06_sequential_impulse/block.hpp"
#include "chapters/09_active_sets/active_sets.hpp"
#include "chapters/10_skipping_work/island_solver.hpp"

#include <deque>
#include <utility>

namespace rigid {

/// Room for islands of one number of rows. What one of them found is nothing to the next.
struct ExactScratch {
    Mlcp mlcp;  ///< A is stored full: n columns in each line
    ActiveSetMemory memory;
    Solution solution;
};

//! [closed_form]
/// One row is solved by one visit, two rows by chapter 6's block (6.21). False
/// where the two are so nearly the same row that rounding would make the answer
/// useless, and where nothing moves one of them.
template <int Dof>
bool solve_in_closed_form(std::span<SolverRow<Dof>> rows, VecX& u)
{
    if (rows.size() == 1) {
        visit(rows[0], u);
        return true;
    }
    if (!(rows[0].mass > 0 && rows[1].mass > 0)) return false;
    const Real A12 = coupling(rows[0], rows[1]);
    if (!(A12 * A12 * rows[0].mass * rows[1].mass < 1 - 1e-8)) return false;
    visit_block(rows[0], rows[1], A12, 0, u);
    return true;
}
//! [closed_form]

//! [first_guess]
/// Which rows are at a bound: those whose own λ is, but for a row whose w drives it
/// off.
template <int Dof>
void guess_from_impulses(std::span<const SolverRow<Dof>> rows, const Mlcp& mlcp,
                         ActiveSetMemory& memory)
{
    memory.cases.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Real w = mlcp.q[static_cast<Index>(i)];
        memory.cases[i] = rows[i].lambda <= rows[i].lo && w >= 0 ? BoundState::at_lo
                          : rows[i].lambda >= rows[i].hi && w <= 0
                              ? BoundState::at_hi
                              : BoundState::between;
    }
    memory.dependent = false;
    memory.proximal.previous.setZero(mlcp.size());
}
//! [first_guess]

/// Solves these rows exactly. Where chapter 9 cannot, λ and u are left as they are. `sweeps` counts guesses.
/// \param enough   if the natural residual is below this as it is, there is nothing to solve [m/s]
/// \param scratch  one for each number of rows; grows without a copy
template <int Dof>
IslandAnswer solve_exactly(std::span<SolverRow<Dof>> rows, Real enough,
                           std::deque<ExactScratch>& scratch, VecX& u)
{
    IslandAnswer answer;
    answer.residual = natural_residual<Dof>(rows, u);
    answer.visits = static_cast<std::int64_t>(rows.size());
    if (answer.residual <= enough) {
        answer.status = Status::solved;
        return answer;
    }
    if (rows.size() <= 2 && solve_in_closed_form(rows, u)) {
        const Real before =
            std::exchange(answer.residual, natural_residual<Dof>(rows, u));
        answer.visits += 2 * static_cast<std::int64_t>(rows.size());
        answer.sweeps = 1;
        if (answer.residual <= std::max(enough, 1e-10 * before)) {
            answer.status = Status::solved;
            return answer;
        }
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
        mlcp.q[i] = velocity<Dof>(row, u.template segment<Dof>(row.a),
                                  u.template segment<Dof>(row.b));
        mlcp.lo[i] = row.lo - row.lambda;
        mlcp.hi[i] = row.hi - row.lambda;
    }
    // an overflow has no answer
    if (!mlcp.q.allFinite() ||
        !Eigen::Map<const VecX>(mlcp.A.valuePtr(), n * n).allFinite())
        return answer;
    guess_from_impulses<Dof>(rows, mlcp, memory);
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
