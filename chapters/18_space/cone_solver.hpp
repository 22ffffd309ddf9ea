/// \file cone_solver.hpp
/// Chapter 10's sweeps, island by island, with a disc for the two rows of friction of each contact.
///
///     stop when r ≤ tolerance, r the largest natural residual of a row (3.15) or of a disc (18.38)
#pragma once

#include "chapters/10_skipping_work/islands.hpp"
#include "chapters/18_space/cone_newton.hpp"
#include "chapters/18_space/level_sweeps.hpp"
#include "chapters/18_space/space_contact.hpp"
#include "chapters/18_space/sweep_patience.hpp"

namespace rigid {

//! [cone_solver]
struct ConeSolver {
    /// of each island; a tolerance of 0 makes all sweeps
    ImpulseSettings sweeps{50, 1e-6};
    SweepPatience patience;  ///< with what they leave
    int corners = 0;         ///< of the pyramid that friction is in; 0: a disc
    /// islands of up to so many rows are solved by Algorithm 18.2, and swept where that
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
    int most_sweeps = 0, unsolved = 0;  ///< of the last step
    int guesses = 0, unanswered = 0;    ///< of Algorithm 18.2; islands that it left

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
    void solve_apart(SecondProblem& second, VecX& v, StepData<6>& now)
    {
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const auto number = static_cast<std::size_t>(islands.rows[k]);
            rows[k].lambda = 0;
            if (second.left_out[number]) rows[k].mass = rows[k].lo = rows[k].hi = 0;
            else rows[k].bias = second.bias[number];
        }
        disc_at.assign(rows.size(), -1);
        for (const int k : now.active) v.segment<6>(6 * k).setZero();
        for (int i = 0; i < islands.count(); ++i) {
            const auto [first, count] = rows_of(i);
            if (is_exact(count)) {
                ConeRows problem = problem_of(i);
                problem.feedback = {};
                if (newton.solve(problem, second.tolerance, v)) continue;
            }
            pushing.clear();  // a row without mass changes nothing
            for (const SolverRow<6>& row : std::span(rows).subspan(first, count))
                if (row.mass > 0) pushing.push_back(row);
            now.visits +=
                sweep_on<6>(pushing, {}, second.max_sweeps, second.tolerance, v);
        }
    }

    /// Relaxation is refused in space by the contacts stage.
    void solve_again(SecondProblem&, Bodies<6>&, StepData<6>&) const {}

private:
    std::pair<std::size_t, std::size_t> rows_of(int island) const
    {
        const auto at = [this](int i) {
            return static_cast<std::size_t>(
                islands.first_row[static_cast<std::size_t>(i)]);
        };
        return {at(island), at(island + 1) - at(island)};
    }

    bool is_exact(std::size_t count) const
    {
        return corners == 0 && count > 0 &&
               count <= static_cast<std::size_t>(exact_rows);
    }
    ConeRows problem_of(int island)
    {
        const auto [first, count] = rows_of(island);
        const std::span<const Feedback> all(feedback);
        return {std::span(rows).subspan(first, count),
                all.empty() ? all : all.subspan(first, count),
                std::span<const int>(disc_at).subspan(first, count), discs,
                islands.bodies_of(island)};
    }

    /// Two neighbours that follow one normal with one μ share a disc.
    void find_discs()
    {
        discs.clear();
        disc_at.assign(rows.size(), -1);
        for (std::size_t k = 0; k + 1 < feedback.size(); ++k) {
            const Feedback &p = feedback[k], &q = feedback[k + 1];
            if (p.bounding == 0 || q.bounding + 1 != p.bounding ||
                p.friction != q.friction)
                continue;
            disc_at[k] = static_cast<int>(discs.size());
            discs.push_back(disc_of_rows(rows, k));
            discs.back().corners = corners;
            ++k;
        }
    }

    //! [solve_island]
    void solve_island(int island, VecX& u, StepData<6>& now)
    {
        const std::size_t count = rows_of(island).second;
        const Real tolerance = sweeps.tolerance * now.length;
        const ConeRows problem = problem_of(island);
        const bool exact = is_exact(count);
        if (exact) {
            const bool found = newton.solve(problem, tolerance, u);
            guesses += newton.guesses;
            now.visits += static_cast<std::int64_t>(count) * (1 + newton.guesses);
            if (found) {
                now.solution.residual =
                    std::max(now.solution.residual, newton.residual);
                return;
            }
            ++unanswered;
        }
        Real residual = infinity;
        int n = 0;
        for (bool off = true; off && !patience.is_last(n, sweeps, residual, now);
             ++n) {
            off = sweep_cones(problem, tolerance, u);
            now.visits += static_cast<std::int64_t>(count);
            // a small change is no small residual (chapter 4): look
            if (!(tolerance > 0) || (off && n + 1 < sweeps.max_sweeps)) continue;
            residual = residual_of(problem, u);
            off = !(residual <= tolerance);
        }
        if (exact && newton.residual < residual) {  // sweeps have made it no better
            newton.give_back(problem, u);
            residual = newton.residual;
        }
        note(n, residual, now);
    }
    //! [solve_island]
    //! [together]
    /// The same, side by side: each island ends by itself, and leaves its lanes.
    void solve_together(Bodies<6>& bodies, StepData<6>& now)
    {
        swept.clear();
        lanes.levels.begin(bodies.count(), islands.count());
        for (int i = 0; i < islands.count(); ++i) {
            const auto [first, count] = rows_of(i);
            if (is_exact(count) || count == 0 || sweeps.max_sweeps == 0) {
                solve_island(i, bodies.u, now);
                continue;
            }
            swept.push_back(i);
            lanes.levels.add(problem_of(i), i, first, bodies);
        }
        if (swept.empty()) return;
        lanes.arrange({rows, feedback, disc_at, discs, {}}, bodies);
        for (int n = 1; !swept.empty(); ++n) {
            lanes.sweep(sweeps.tolerance * now.length);
            std::erase_if(swept,
                          [&](int i) { return is_done(i, n, bodies.u, now); });
        }
    }

    /// Whether an island ends after n sweeps.
    bool is_done(int island, int n, VecX& u, StepData<6>& now)
    {
        const auto [first, count] = rows_of(island);
        const Real tolerance = sweeps.tolerance * now.length;
        now.visits += static_cast<std::int64_t>(count);
        if (n < sweeps.max_sweeps && lanes.off[static_cast<std::size_t>(island)])
            return false;
        for (const int k : islands.bodies_of(island))
            for (Index i = 6 * k; i < 6 * k + 6; ++i) u[i] = lanes.number(i);
        for (std::size_t k = first; k < first + count; ++k)
            rows[k].lambda = lanes.lambda(k);
        Real residual = infinity;
        if (tolerance > 0) residual = residual_of(problem_of(island), u);
        const bool last = patience.is_last(n, sweeps, residual, now);
        if (!last && tolerance > 0 && !(residual <= tolerance)) return false;
        lanes.leave(island);
        note(n, residual, now);
        return true;
    }
    //! [together]
    void note(int sweep_count, Real residual, StepData<6>& now)
    {
        most_sweeps = std::max(most_sweeps, sweep_count);
        unsolved += !(residual <= sweeps.tolerance * now.length);
        now.solution.residual = std::max(now.solution.residual, residual);
    }
};

}  // namespace rigid
