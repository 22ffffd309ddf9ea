/// \file cone_solver.hpp
/// Chapter 10's sweeps, island by island, with a disc for the two rows of friction of each contact.
///
///     stop when r ≤ tolerance, r the largest natural residual of a row (3.15) or of a disc (25.38)
#pragma once

#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/10_skipping_work/islands.hpp"
#include "chapters/25_space/cone_newton.hpp"
#include "chapters/25_space/level_sweeps.hpp"
#include "chapters/25_space/space_contact.hpp"
#include "chapters/25_space/sweep_patience.hpp"

namespace rigid {

//! [cone_solver]
struct ConeSolver : PlainSolver {
    /// of each island; a tolerance of 0 makes all sweeps
    ImpulseSettings sweeps{50, 1e-6};
    SweepPatience patience;  ///< with what they leave
    int corners = 0;         ///< of the pyramid that friction is in; 0: a disc
    /// islands of up to so many rows are solved by Algorithm 25.2, and swept where that
    /// finds no answer; 0: all are swept
    int exact_rows = 0;
    ConeNewton newton;
    /// rows that share no body are visited side by side; false: one by one, which
    /// gives the same bits
    bool wide = true;

    // What is kept from step to step.
    Islands islands;
    std::vector<SolverRow<6>> rows;  ///< island by island
    std::vector<Feedback> feedback;
    std::vector<int> place_of;
    std::vector<DiscOfRows> discs;
    std::vector<int> disc_at;  ///< of each row: the disc that begins there, or −1
    LevelSweeps<std::min(full_lanes<Real>, 4)> lanes;  ///< eight are no faster
    std::vector<int> swept;             ///< islands that are not done
    std::vector<SolverRow<6>> pushing;  ///< in the second problem
    int most_sweeps = 0;                ///< of the last step
    int guesses = 0, unanswered = 0;    ///< of Algorithm 25.2; islands that it left

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
        if (now.substep == 0) most_sweeps = unsolved = guesses = unanswered = 0;
        find_islands(bodies, now, {}, islands);
        VecX& lambda = now.solution.lambda;
        clamp_start(now.rows, lambda);
        for (const int k : now.active)
            bodies.velocity(k) = now.u_star.segment<6>(6 * k);
        prepare<6>(now.rows, islands.rows, lambda, rows);
        prepare_feedback<6>(now.rows, islands.rows, rows, place_of, feedback);
        find_discs();
        for (const SolverRow<6>& row : rows) {
            bodies.u.segment<6>(row.a) += row.Wa * row.lambda;
            bodies.u.segment<6>(row.b) += row.Wb * row.lambda;
        }
        now.solution.residual = 0;
        if (wide && corners == 0) solve_together(bodies, now);
        else
            for (int i = 0; i < islands.count(); ++i)
                solve_island(i, bodies.u, now);
        for (std::size_t k = 0; k < rows.size(); ++k)
            lambda[islands.rows[k]] = rows[k].lambda;
        now.solution.iterations = most_sweeps;
        now.solution.status =
            unsolved > 0 ? Status::iteration_limit : Status::solved;
    }
    //! [cone_solver]

    /// The biases alone, from rest and without friction: v = M⁻¹ Jᵀ Λ.
    void solve_apart(SecondProblem& second, VecX& v, StepData<6>& now);

    /// Relaxation is refused in space by the contacts stage.
    void solve_again(SecondProblem&, Bodies<6>&, StepData<6>&) const {}

private:
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
    /// The same, side by side: each island ends by itself, and leaves its lanes.
    void solve_together(Bodies<6>& bodies, StepData<6>& now);

    /// Whether an island ends after n sweeps.
    bool is_done(int island, int n, VecX& u, StepData<6>& now);
    void note(int sweep_count, Real residual, StepData<6>& now)
    {
        most_sweeps = std::max(most_sweeps, sweep_count);
        unsolved += !(residual <= sweeps.tolerance * now.length);
        now.solution.residual = std::max(now.solution.residual, residual);
    }
};

}  // namespace rigid
