/// \file impulse_solver.hpp
/// The solver stage of the step without a matrix: the rows are put in order, and swept.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/03_mlcp_formulation/verification.hpp"
#include "chapters/06_sequential_impulse/block.hpp"
#include "chapters/06_sequential_impulse/row_order.hpp"
#include "chapters/06_sequential_impulse/sequential_impulse.hpp"
#include "common/text.hpp"

namespace rigid {

/// The sweeps go on over rows that are prepared, from their present λ and u, until one of them finds no row off by
/// more than the tolerance.
/// \param feedback    of the rows; empty = none of them has any
/// \param max_sweeps  at most
/// \param tolerance   [m/s]
/// \return            rows visited
template <int Dof>
std::int64_t sweep_on(std::span<SolverRow<Dof>> rows,
                      std::span<const Feedback> feedback, int max_sweeps,
                      Real tolerance, VecX& u)
{
    int sweeps = 0;
    for (int changed = 1; sweeps < max_sweeps && changed > 0; ++sweeps)
        changed = sweep(rows, feedback, u, tolerance);
    return static_cast<std::int64_t>(rows.size()) * sweeps;
}

/// Throws std::invalid_argument, naming the setting and its value, unless both make sense.
inline void require_valid(const ImpulseSettings& sweeps)
{
    require_tolerance("the sweeps", sweeps.tolerance);
    if (sweeps.max_sweeps < 0)
        throw std::invalid_argument("the number of sweeps is " +
                                    std::to_string(sweeps.max_sweeps) +
                                    "; it must be zero or positive");
}

//! [sweeps]
/// Sweeps on the velocities themselves, (6.5): u is u* + M⁻¹ Jᵀ λ at each moment.
template <int Dof>
struct ImpulseSolver : PlainSolver {
    ImpulseSettings sweeps;
    Order ordering = Order::given;
    bool in_pairs = false;  ///< two rows in one visit, (6.21)
    Random random{1};       ///< for a shuffled order

    // What is kept from step to step.
    Colouring colouring;
    std::vector<int> order;  ///< of the visits; empty = as the rows are
    ImpulseMemory<Dof> memory;
    std::vector<Block> blocks;

    void require_valid() const { rigid::require_valid(sweeps); }
    Real noise() const { return sweeps.tolerance; }

    void solve(Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        const bool ordered = now.same_rows && ordering == Order::coloured &&
                             order.size() == now.rows.size();
        if (now.substep == 0 && !ordered)
            order_rows(now.rows, bodies.count(), ordering, random, colouring,
                       order);
        ImpulseSettings how = sweeps;
        how.alternate = ordering == Order::alternating;
        how.tolerance *= now.length;
        for (const int k : now.active)
            bodies.velocity(k) = now.u_star.template segment<Dof>(Dof * k);
        if (in_pairs)
            block_impulse(now.rows, std::span<const int>(order), how, memory,
                          blocks, bodies.u, now.solution);
        else
            sequential_impulse(now.rows, std::span<const int>(order), how, memory,
                               bodies.u, now.solution);
        now.visits += memory.visits;
    }
    //! [sweeps]

    /// The number of the row that is visited as number k.
    std::size_t row_at(std::size_t k) const
    {
        return order.empty() ? k : static_cast<std::size_t>(order[k]);
    }

    /// Other biases, the same u*: the sweeps go on from the present λ and u.
    void solve_again(SecondProblem& second, Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        for (std::size_t k = 0; k < memory.rows.size(); ++k)
            change_bias(k, second.bias[row_at(k)], memory.rows, memory.feedback);
        now.visits += sweep_on<Dof>(memory.rows, memory.feedback, second.max_sweeps,
                                    second.tolerance, memory.u);
        bodies.u = memory.u;
        for (std::size_t k = 0; k < memory.rows.size(); ++k)
            now.solution.lambda[static_cast<Index>(row_at(k))] =
                memory.rows[k].lambda;
    }

    /// The biases alone, from rest: v = M⁻¹ Jᵀ Λ. The λ of `memory` are those of v afterwards.
    void solve_apart(SecondProblem& second, VecX& v, StepData<Dof>& now)
    {
        for (std::size_t k = 0; k < memory.rows.size(); ++k) {
            SolverRow<Dof>& row = memory.rows[k];
            row.lambda = 0;
            if (second.left_out[row_at(k)]) row.mass = 0;
            else
                change_bias(k, second.bias[row_at(k)], memory.rows,
                            memory.feedback);
        }
        for (const int k : now.active) v.template segment<Dof>(Dof * k).setZero();
        now.visits += sweep_on<Dof>(memory.rows, memory.feedback, second.max_sweeps,
                                    second.tolerance, v);
    }
};

// Compiled once, in impulse_solver.cpp.
#define RIGID_IMPULSE_SOLVER(TEMPLATE, Dof)                                        \
    TEMPLATE std::int64_t sweep_on(std::span<SolverRow<Dof>>,                      \
                                   std::span<const Feedback>, int, Real, VecX&);
RIGID_IMPULSE_SOLVER(extern template, 2)
RIGID_IMPULSE_SOLVER(extern template, 3)
RIGID_IMPULSE_SOLVER(extern template, 6)

}  // namespace rigid
