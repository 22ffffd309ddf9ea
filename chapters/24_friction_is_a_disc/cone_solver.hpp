/// \file cone_solver.hpp
/// Chapter 10's sweeps, island by island, with a disc for the two rows of friction of each contact.
///
///     stop when r ≤ tolerance, r the largest natural residual of a row (3.15) or of a disc (24.3)
#pragma once

#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/10_skipping_work/islands.hpp"
#include "chapters/20_turning_in_space/solid_scene.hpp"
#include "chapters/24_friction_is_a_disc/cone_newton.hpp"
#include "chapters/24_friction_is_a_disc/sweep_patience.hpp"

namespace rigid {

//! [cone_solver]
struct ConeSolver : PlainSolver {
    /// of each island; a tolerance of 0 makes all sweeps
    ImpulseSettings sweeps{50, 1e-6};
    SweepPatience patience;  ///< with what they leave
    int corners = 0;         ///< of the pyramid that friction is in; 0: a disc
    /// islands of up to so many rows are solved by Algorithm 24.2, and swept where that
    /// finds no answer; 0: all are swept
    int exact_rows = 0;
    ConeNewton newton;

    // What is kept from step to step.
    Islands islands;
    std::vector<SolverRow<6>> rows;  ///< island by island
    std::vector<Feedback> feedback;
    std::vector<int> place_of;
    std::vector<DiscOfRows> discs;
    std::vector<int> disc_at;  ///< of each row: the disc that begins there, or −1
    std::vector<SolverRow<6>> pushing;  ///< in the second problem
    int most_sweeps = 0;                ///< of the last step
    int guesses = 0, unanswered = 0;    ///< of Algorithm 24.2; islands that it left

    void require_valid() const
    {
        rigid::require_valid(sweeps), patience.require_valid();
        newton.settings.require_valid();
        if (exact_rows < 0)
            throw std::invalid_argument(
                "islands of up to " + std::to_string(exact_rows) +
                " rows are to be solved exactly; it must be zero or more");
        if (corners != 0 && corners < 3)
            throw std::invalid_argument(
                "a pyramid of friction has " + std::to_string(corners) +
                " corners; it must have three or more, or 0: a disc");
    }

    Real noise() const { return sweeps.tolerance; }
    const Islands* islands_found() const { return &islands; }

    /// Each island by itself, from the λ that now.solution holds.
    void solve(Bodies<6>& bodies, StepData<6>& now)
    {
        begin(bodies, now);
        for (int i = 0; i < islands.count(); ++i) solve_island(i, bodies.u, now);
        finish(now);
    }
    //! [cone_solver]

    /// The biases alone, from rest and without friction: v = M⁻¹ Jᵀ Λ.
    void solve_apart(SecondProblem& second, VecX& v, StepData<6>& now);

    /// Relaxation is refused in space by the contacts stage.
    void solve_again(SecondProblem&, Bodies<6>&, StepData<6>&) const {}

protected:
    /// Islands, rows and discs of a step, and what the start of λ does to u.
    void begin(Bodies<6>& bodies, StepData<6>& now);
    /// λ, and what is to be said of it.
    void finish(StepData<6>& now);

    std::pair<std::size_t, std::size_t> rows_of(int island) const;

    bool solves_exactly(std::size_t count) const
    {
        return corners == 0 && count > 0 &&
               count <= static_cast<std::size_t>(exact_rows);
    }
    ConeRows problem_of(int island);

    /// Two neighbours that follow one normal with one μ share a disc.
    void find_discs();

    void solve_island(int island, VecX& u, StepData<6>& now);
    void note(int sweep_count, Real residual, StepData<6>& now)
    {
        most_sweeps = std::max(most_sweeps, sweep_count);
        unsolved += !(residual <= sweeps.tolerance * now.length);
        now.solution.residual = std::max(now.solution.residual, residual);
    }
};

}  // namespace rigid
