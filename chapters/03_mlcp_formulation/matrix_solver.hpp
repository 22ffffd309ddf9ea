/// \file matrix_solver.hpp
/// The solver stage with a matrix: A and q are assembled, and any solver of the MLCP finds λ.
#pragma once

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/03_mlcp_formulation/coupled_bounds.hpp"
#include "chapters/03_mlcp_formulation/separate_blocks.hpp"
#include "chapters/03_mlcp_formulation/step_data.hpp"

#include <type_traits>
#include <utility>

namespace rigid {

/// Calls a solver of either form: void(const Mlcp&, Solution&), or Solution(const Mlcp&).
template <class Solve>
void hand_over(Solve& solve, const Mlcp& mlcp, Solution& solution)
{
    if constexpr (std::is_invocable_v<Solve&, const Mlcp&, Solution&>)
        solve(mlcp, solution);
    else solution = solve(mlcp);
}

//! [matrix]
template <class Solve>
struct MatrixSolver : PlainSolver {
    Solve find;  ///< void(const Mlcp&, Solution&), or Solution(const Mlcp&)
    AssemblyScratch scratch;
    Mlcp mlcp;

    /// The least change of u* that keeps to the rows: w = A λ + q, complementary to
    /// λ (3.12); u = u* + M⁻¹ Jᵀ λ (3.9).
    template <int Dof>
    void solve(Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        assemble(now.rows, now.u_star, scratch, mlcp);
        solve_rows(now);
        apply_impulses(now.solution.lambda, bodies, now);
    }

    /// Other biases, the same u*: λ and u become the answer to them.
    template <int Dof>
    void solve_again(SecondProblem& second, Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            mlcp.q[static_cast<Index>(i)] += second.bias[i] - now.rows[i].bias;
        solve_rows(now);
        apply_impulses(now.solution.lambda, bodies, now);
    }

    /// The biases alone, from rest: v = M⁻¹ Jᵀ Λ.
    template <int Dof>
    void solve_apart(SecondProblem& second, VecX& v, StepData<Dof>& now)
    {
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const auto row = static_cast<Index>(i);
            mlcp.q[row] = second.left_out[i] ? 0 : second.bias[i];
            if (second.left_out[i]) mlcp.lo[row] = mlcp.hi[row] = 0;
        }
        second.solution.lambda.setZero(mlcp.size());
        find_in_lengths(second.solution, now.length);
        for (const int k : now.active) v.template segment<Dof>(Dof * k).setZero();
        apply(now.rows, second.solution.lambda, v);
    }

private:
    /// A tolerance of m/s would be another one in a scene of another size: a solver
    /// gets speeds in ℓ a second.
    void find_in_lengths(Solution& solution, Real length)
    {
        if (length != 1) {
            for (VecX* numbers : {&mlcp.q, &mlcp.lo, &mlcp.hi, &solution.lambda})
                *numbers /= length;
        }
        hand_over(find, mlcp, solution);
        if (has_no_answer(solution.status))  // then others must not lose theirs
            solve_by_blocks(
                mlcp,
                [this](const Mlcp& block, Solution& one) {
                    hand_over(find, block, one);
                },
                solution);
        if (length != 1) {
            for (VecX* numbers : {&mlcp.q, &mlcp.lo, &mlcp.hi, &solution.lambda})
                *numbers *= length;
            solution.residual *= length;
        }
    }

    template <int Dof>
    void solve_rows(StepData<Dof>& now)
    {
        const auto solve = [this, &now](const Mlcp&, Solution& solution) {
            find_in_lengths(solution, now.length);
        };
        if (is_coupled(now.rows))
            solve_coupled(now.rows, solve, mlcp, now.solution);
        else solve(mlcp, now.solution);
    }

    template <int Dof>
    static void apply_impulses(const VecX& lambda, Bodies<Dof>& bodies,
                               const StepData<Dof>& now)
    {
        for (const int k : now.active)
            bodies.velocity(k) = now.u_star.template segment<Dof>(Dof * k);
        apply(now.rows, lambda, bodies.u);
    }
};
//! [matrix]

}  // namespace rigid
