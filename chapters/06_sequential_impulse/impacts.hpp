/// \file impacts.hpp
/// Several bodies that touch, and one that hits: two laws of impact, both with the same momentum and energy.
///
///     simultaneous   all rows at once, b = e v⁻ with the v⁻ before the impact: one complementarity problem
///     sequential     one contact after the other, each an impact of two bodies, until none approaches any more
///
/// (6.19) and (6.20). Newton's cradle behaves like the second.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <cmath>
#include <vector>

namespace rigid {

/// The biases of the simultaneous law: each row that hits, J u + b < 0, is to leave with e times its own approach.
/// \param rows  contacts, with b = 0 where they touch and b = C/h where a gap C is left
/// \param e     restitution, 0 … 1
/// \param u     velocities before the impact [m/s]
template <int Dof>
void newton_biases(std::vector<Row<Dof>>& rows, Real e, const VecX& u)
{
    for (Row<Dof>& row : rows) {
        const Real w = row.velocity(u);
        if (w < 0) row.bias = e * (w - row.bias);
    }
}

/// The sequential law: whichever row hits, J u + b < 0, in the order of the rows, gets the impulse of an impact of
/// its two bodies alone. λ sums up all of its impacts.
///
/// `solved` when no row hits any more. Balls on a line come to that end, but with e < 1 it may take infinitely
/// many impacts: then `iteration limit`. `infeasible` when a row hits between bodies that cannot move.
/// \param rows       contacts, 0 ≤ λ, with the biases as above
/// \param tolerance  [m/s]
/// \param u          in: before the impact, out: after it [m/s]
template <int Dof>
void sequential_impacts(const std::vector<Row<Dof>>& rows, Real e, Real tolerance,
                        int max_sweeps, VecX& u, Solution& solution)
{
    solution.lambda.setZero(static_cast<Index>(rows.size()));
    solution.status = Status::iteration_limit;
    solution.iterations = 0;
    bool hopeless = false;  // a row hits, and nothing moves it
    //! [sequential]
    for (bool any = true; any && solution.iterations < max_sweeps;
         ++solution.iterations) {
        any = false;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Row<Dof>& row = rows[i];
            const Real w = row.velocity(u), approach = w - row.bias,
                       A = row.inverse_effective_mass();
            if (!(w < -tolerance || std::isnan(w))) continue;
            if (!(A > 0)) {
                hopeless = true;
                continue;
            }
            const Real lambda = -(1 + e) * approach / A;
            row.apply(lambda, u);
            solution.lambda[static_cast<Index>(i)] += lambda;
            any = true;
        }
        if (!any) solution.status = Status::solved;
    }
    //! [sequential]
    if (hopeless) solution.status = Status::infeasible;
    solution.residual = 0;
    for (const Row<Dof>& row : rows) {
        const Real hits = -row.velocity(u);
        // also takes over a NaN
        if (!(hits <= solution.residual)) solution.residual = hits;
        if (std::isnan(solution.residual)) return;
    }
}

}  // namespace rigid
