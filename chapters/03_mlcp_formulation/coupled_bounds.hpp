/// \file coupled_bounds.hpp
/// Rows whose bounds another row's impulse sets, for solvers of the MLCP, which take fixed bounds only.
///
///     hi_i = μ λ_n,   lo_i = −μ λ_n
///
/// Solve with the bounds that the present λ_n gives, set the bounds again, and so on until they no longer change
/// (Panagiotopoulos' iteration: friction with known normal forces, again and again \cite panagiotopoulos1975). It
/// contracts where μ is small; what does not settle is reported as `iteration limit`. Chapter 13 has better answers.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "chapters/03_mlcp_formulation/verification.hpp"

#include <tuple>
#include <vector>

namespace rigid {

inline constexpr int most_bound_rounds = 100;

template <int Dof>
bool is_coupled(const std::vector<Row<Dof>>& rows)
{
    return std::any_of(rows.begin(), rows.end(),
                       [](const Row<Dof>& row) { return row.bounded_by >= 0; });
}

/// Sets the bounds that other rows set, by λ.
template <int Dof>
void set_bounds(const std::vector<Row<Dof>>& rows, const VecX& lambda, Mlcp& mlcp)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        std::tie(mlcp.lo[static_cast<Index>(i)], mlcp.hi[static_cast<Index>(i)]) =
            bounds_of(rows[i], lambda);
}

//! [rounds]
/// Solves the MLCP of these rows, of which some are bounded by others.
/// \param solve     void(const Mlcp&, Solution&)
/// \param mlcp      in: A and q; the bounds are overwritten, at the end those of
///                  the answer
/// \param solution  in: the λ to start from; out: the answer. `solved` if λ,
///                  brought into the bounds that it sets itself, is an answer with
///                  these bounds by (3.16c) and (3.16d), with the share of `accept`
template <int Dof, class Solve>
void solve_coupled(const std::vector<Row<Dof>>& rows, Solve&& solve, Mlcp& mlcp,
                   Solution& solution, const Acceptance& accept = {1e-9, 0})
{
    if (solution.lambda.size() != mlcp.size()) solution.lambda.setZero(mlcp.size());
    set_bounds(rows, solution.lambda, mlcp);
    for (int round = 0; round < most_bound_rounds; ++round) {
        solve(mlcp, solution);
        if (solution.status != Status::solved) return;
        set_bounds(rows, solution.lambda, mlcp);
        solution.lambda = solution.lambda.cwiseMax(mlcp.lo).cwiseMin(mlcp.hi);
        const Verification verified = verify(mlcp, solution.lambda, accept);
        solution.residual = verified.residual;
        if (verified.solved) return;
    }
    solution.status = Status::iteration_limit;
}
//! [rounds]

}  // namespace rigid
