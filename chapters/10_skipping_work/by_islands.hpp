/// \file by_islands.hpp
/// The solver stage of the step, island by island: each is solved for as long as it needs, small ones exactly.
#pragma once

#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/10_skipping_work/exact_island.hpp"
#include "chapters/10_skipping_work/island_solver.hpp"
#include "chapters/10_skipping_work/islands.hpp"

namespace rigid {

/// No exact answer for islands whose rows follow impulses: they are swept. Chapter 13
/// has one for friction.
struct SweepTheCoupled {
    template <int Dof>
    IslandAnswer operator()(std::span<SolverRow<Dof>>, std::span<const Feedback>,
                            Real, VecX&) const
    {
        return {};
    }
};

//! [by_islands]
/// \tparam Coupled  an exact solver of small islands whose rows follow impulses
template <int Dof, class Coupled = SweepTheCoupled>
struct IslandSolver : PlainSolver {
    /// of each island; a tolerance of 0 makes all sweeps
    ImpulseSettings sweeps;
    /// of the rows in their island: given or coloured
    Order ordering = Order::coloured;
    /// islands of up to so many rows are solved exactly
    int exact_rows = 8;
    /// of each row: sweeps over its island; empty = those above
    std::vector<int> allowed;
    /// of each row: the tolerance of its island [ℓ/s]; empty = that of the sweeps
    std::vector<Real> enough;
    /// an island of slower bodies is swept to a hundredth of its tolerance, and of
    /// what its largest impulse does to its row to 1e-4: what sweeps leave adds up
    /// along a stack and would keep it awake [ℓ/s]; 0 = none
    Real slow = 0;
    bool apart = true;  ///< false: all rows are one problem
    Coupled coupled;

    // What is kept from step to step.
    Islands islands;
    Colouring colouring;
    std::vector<int> order;
    /// how the rows were ordered when the islands were found
    Order ordered = Order::given;
    std::vector<SolverRow<Dof>> rows;  ///< island by island
    std::vector<Feedback> feedback;    ///< of each of them; empty = none has any
    std::vector<int> place_of;
    std::deque<ExactScratch> exact;

    // Of the last step.
    int most_sweeps = 0;        ///< of the island that needed the most
    int exact_count = 0;        ///< islands that were solved exactly
    ImpulseSettings in_metres;  ///< the sweeps, with a tolerance in m/s

    void require_valid() const
    {
        rigid::require_valid(sweeps);
        if (ordering != Order::given && ordering != Order::coloured)
            throw std::invalid_argument("the order is " +
                                        std::string(to_string(ordering)) +
                                        "; this solver has given and coloured");
    }

    Real noise() const { return sweeps.tolerance; }
    const Islands* islands_found() const { return &islands; }

    /// Each island by itself, from the λ that now.solution holds.
    void solve(Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        in_metres = sweeps;
        in_metres.tolerance *= now.length;
        if (now.substep == 0) {
            most_sweeps = exact_count = unsolved = 0;
            arrange(bodies, now);
        }
        VecX& lambda = now.solution.lambda;
        clamp_start(now.rows, lambda);
        for (const int k : now.active)
            bodies.velocity(k) = now.u_star.template segment<Dof>(Dof * k);
        prepare<Dof>(now.rows, islands.rows, lambda, rows);
        prepare_feedback<Dof>(now.rows, islands.rows, rows, place_of, feedback);
        for (const SolverRow<Dof>& row : rows) {
            bodies.u.template segment<Dof>(row.a) += row.Wa * row.lambda;
            bodies.u.template segment<Dof>(row.b) += row.Wb * row.lambda;
        }
        for_each_problem([&](std::size_t first, std::size_t count) {
            solve_one(first, count, bodies.u, now);
        });
        for (std::size_t k = 0; k < rows.size(); ++k)
            lambda[islands.rows[k]] = rows[k].lambda;
        now.solution.iterations = most_sweeps;
        now.solution.status =
            unsolved > 0 ? Status::iteration_limit : Status::solved;
    }
    //! [by_islands]

    /// Other biases, the same u*: the sweeps go on from the present λ and u.
    void solve_again(SecondProblem& second, Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        for (std::size_t k = 0; k < rows.size(); ++k)
            change_bias(k, second.bias[row_at(k)], rows, feedback);
        sweep_each(second, bodies.u, now);
        for (std::size_t k = 0; k < rows.size(); ++k)
            now.solution.lambda[islands.rows[k]] = rows[k].lambda;
    }

    /// The biases alone, from rest: v = M⁻¹ Jᵀ Λ.
    void solve_apart(SecondProblem& second, VecX& v, StepData<Dof>& now)
    {
        for (std::size_t k = 0; k < rows.size(); ++k) {
            rows[k].lambda = 0;
            if (second.left_out[row_at(k)]) rows[k].mass = 0;
            else change_bias(k, second.bias[row_at(k)], rows, feedback);
        }
        for (const int k : now.active) v.template segment<Dof>(Dof * k).setZero();
        sweep_each(second, v, now);
        second.solution.lambda.setZero(static_cast<Index>(now.rows.size()));
        for (std::size_t k = 0; k < rows.size(); ++k)
            second.solution.lambda[islands.rows[k]] = rows[k].lambda;
    }

private:
    std::size_t row_at(std::size_t k) const
    {
        return static_cast<std::size_t>(islands.rows[k]);
    }

    /// Calls visit(first, count) for the rows of each island, or for all of them.
    template <class Visit>
    void for_each_problem(const Visit& visit) const
    {
        if (!apart) visit(std::size_t{0}, rows.size());
        for (int i = 0; apart && i < islands.count(); ++i)
            visit(static_cast<std::size_t>(
                      islands.first_row[static_cast<std::size_t>(i)]),
                  islands.rows_of(i).size());
    }

    /// The rows of one problem, and what they follow.
    std::span<SolverRow<Dof>> some_rows(std::size_t first, std::size_t count)
    {
        return std::span<SolverRow<Dof>>(rows).subspan(first, count);
    }
    std::span<const Feedback> some_feedback(std::size_t first,
                                            std::size_t count) const
    {
        const std::span<const Feedback> follows(feedback);
        return follows.empty() ? follows : follows.subspan(first, count);
    }

    /// An island that is done is done, however long another one goes on.
    void sweep_each(const SecondProblem& second, VecX& v, StepData<Dof>& now)
    {
        for_each_problem([&](std::size_t first, std::size_t count) {
            now.visits +=
                sweep_on(some_rows(first, count), some_feedback(first, count),
                         second.max_sweeps, second.tolerance, v);
        });
    }

    /// While the rows are those of the step before, so are the islands.
    void arrange(const Bodies<Dof>& bodies, const StepData<Dof>& now)
    {
        if (now.same_bodies && now.same_rows && ordering == ordered) return;
        order.clear();
        if (ordering == Order::coloured)
            colour_rows_of<Dof>(now.active, bodies.count(), now.rows, colouring,
                                order);
        find_islands(bodies, now, order, islands);
        ordered = ordering;
    }

    void solve_one(std::size_t first, std::size_t count, VecX& u,
                   StepData<Dof>& now)
    {
        if (count == 0) return;
        const std::span<SolverRow<Dof>> island = some_rows(first, count);
        const std::span<const Feedback> follows = some_feedback(first, count);
        if (!feedback.empty() || static_cast<int>(count) <= exact_rows) {
            const IslandAnswer answer =
                feedback.empty()
                    ? solve_exactly(island, in_metres.tolerance, exact, u)
                    : coupled(island, follows, in_metres.tolerance, u);
            now.visits += answer.visits;
            if (answer.status == Status::solved) {
                ++exact_count;
                return;
            }
        }
        ImpulseSettings how = in_metres;
        if (!allowed.empty()) how.max_sweeps = allowed[row_at(first)];
        if (!enough.empty()) how.tolerance = enough[row_at(first)] * now.length;
        const Real good = how.tolerance;
        if (slow > 0 && are_slow(island, u, now.length))
            how.tolerance =
                std::min(how.tolerance / 100, 1e-4 * largest_change(island));
        const IslandAnswer answer = sweep_island(island, follows, how, u);
        most_sweeps = std::max(most_sweeps, answer.sweeps);
        now.visits += answer.visits;
        unsolved += answer.status != Status::solved && !(answer.residual <= good);
    }

    /// The most that an impulse changes the velocity of its own row by [m/s];
    /// infinity without any impulse
    static Real largest_change(std::span<const SolverRow<Dof>> island)
    {
        Real most = 0;
        for (const SolverRow<Dof>& row : island)
            if (row.mass > 0)
                most = std::max(most, std::abs(row.lambda) / row.mass);
        return most > 0 ? most : infinity;
    }

    /// Whether each body of these rows is, a spin at the distance ℓ.
    bool are_slow(std::span<const SolverRow<Dof>> island, const VecX& u,
                  Real length) const
    {
        constexpr int ways = Dof == 6 ? 3 : 2;  // the others are angles
        const auto speed2 = [&](Index from) {
            const Vec<Dof> v = u.template segment<Dof>(from);
            return v.template head<ways>().squaredNorm() +
                   length * length * v.template tail<Dof - ways>().squaredNorm();
        };
        const Real most = slow * length * slow * length;
        return std::all_of(island.begin(), island.end(), [&](const auto& row) {
            return speed2(row.a) <= most && speed2(row.b) <= most;
        });
    }
};

}  // namespace rigid
