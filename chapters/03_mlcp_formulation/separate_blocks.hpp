/// \file separate_blocks.hpp
/// Rows that share no body are separate problems: where the whole has no answer, most of them still have theirs.
///
/// A is block diagonal when its rows are grouped by what meets what, (3.18). A solver that takes all rows as one problem
/// says `infeasible` of all of them if two rods at the other end of the scene contradict each other. So the blocks are
/// found, and each is solved by itself. Of the whole it stays true that it is not solved.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "common/union_find.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace rigid {

/// The rows of each block, ascending; the block of the lowest row comes first.
std::vector<std::vector<int>> blocks_of(const Mlcp& mlcp);

/// The problem of some of its rows, given in ascending order, that meet no others.
Mlcp part_of(const Mlcp& mlcp, const std::vector<int>& rows);

/// What a solver says of a problem that it has given up, whatever it was: no λ, or none that it can find.
constexpr bool has_no_answer(Status status)
{
    return status == Status::infeasible || status == Status::singular ||
           status == Status::ray_termination;
}

//! [by_blocks]
/// Solves block by block, from a cold start. Leaves the solution as it is if there
/// is only one block.
/// \param solve     void(const Mlcp&, Solution&), where the Solution holds the λ to
///                  start from
/// \param solution  out: λ of each block as its own solve left it, the last status
///                  that is not `solved`, the largest residual, and all iterations,
///                  those of the whole included
template <class Solve>
void solve_by_blocks(const Mlcp& mlcp, const Solve& solve, Solution& solution)
{
    const std::vector<std::vector<int>> blocks = blocks_of(mlcp);
    if (blocks.size() < 2) return;
    VecX lambda = VecX::Zero(mlcp.size()).cwiseMax(mlcp.lo).cwiseMin(mlcp.hi);
    solution.status = Status::solved;
    solution.residual = 0;
    for (const std::vector<int>& rows : blocks) {
        Solution one;
        one.lambda = lambda(rows);
        solve(part_of(mlcp, rows), one);
        lambda(rows) = one.lambda;
        solution.iterations += one.iterations;
        solution.residual = std::max(solution.residual, one.residual);
        if (one.status != Status::solved) solution.status = one.status;
    }
    solution.lambda = lambda;
}
//! [by_blocks]

}  // namespace rigid
