// The functions of cone_solver.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/cone_solver.hpp"

namespace rigid {

void ConeSolver::begin(Bodies<6>& bodies, StepData<6>& now)
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
}

void ConeSolver::finish(StepData<6>& now)
{
    for (std::size_t k = 0; k < rows.size(); ++k)
        now.solution.lambda[islands.rows[k]] = rows[k].lambda;
    now.solution.iterations = most_sweeps;
    now.solution.status = unsolved > 0 ? Status::iteration_limit : Status::solved;
}

void ConeSolver::solve_apart(SecondProblem& second, VecX& v, StepData<6>& now)
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
        if (solves_exactly(count)) {
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

std::pair<std::size_t, std::size_t> ConeSolver::rows_of(int island) const
{
    const auto at = [this](int i) {
        return static_cast<std::size_t>(
            islands.first_row[static_cast<std::size_t>(i)]);
    };
    return {at(island), at(island + 1) - at(island)};
}

ConeRows ConeSolver::problem_of(int island)
{
    const auto [first, count] = rows_of(island);
    const std::span<const Feedback> all(feedback);
    return {std::span(rows).subspan(first, count),
            all.empty() ? all : all.subspan(first, count),
            std::span<const int>(disc_at).subspan(first, count), discs,
            islands.bodies_of(island)};
}

void ConeSolver::find_discs()
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
void ConeSolver::solve_island(int island, VecX& u, StepData<6>& now)
{
    const std::size_t count = rows_of(island).second;
    const Real tolerance = sweeps.tolerance * now.length;
    const ConeRows problem = problem_of(island);
    const bool exact = solves_exactly(count);
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
    for (bool off = true; off && !patience.is_last(n, sweeps, residual, now); ++n) {
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

}  // namespace rigid
