/// \file island_solvers.hpp
/// To each island of a step a solver of its own, in numbers of its own; what one of them does changes no bit of another.
#pragma once

#include "chapters/18_islands/exact_islands.hpp"
#include "chapters/18_islands/island_pieces.hpp"
#include "chapters/18_islands/island_places.hpp"
#include "chapters/18_islands/island_pool.hpp"
#include "chapters/18_islands/wide_islands.hpp"

namespace rigid {

struct SweptIsland {
    StepPart part;
    IslandSolver<3> solver;
};

/// Another problem on the rows of a part, by the solver of the part.
template <class Part>
struct PartApart {
    Part& one;

    void solve_apart(SecondProblem& second, VecX& v, StepData<3>& now)
    {
        StepPart& part = one.part;
        part.gather(second);
        part.second.solution.status = Status::solved;
        one.solver.solve_apart(part.second, part.v, part.now);
        second.solution.status = part.second.solution.status;
        part.scatter_apart(second, v, now);
    }
    /// The rows have another J.
    void factor_again(const Bodies<3>& bodies, const StepData<3>& now)
    {
        one.factor_again(bodies, now);
    }
};

struct IslandSolvers {
    IslandPlaces all;     ///< of the step
    IslandPieces pieces;  ///< of those
    TreeStock stock;      ///< of memory for exact solves
    IslandPool<ExactIsland> exactly;
    IslandPool<TreePart> held;
    IslandPool<SweptIsland> swept;
    IslandPool<WideIsland> wide;
    IslandPool<TreePart> rescuers;
    IslandPool<TreePart> struck;  ///< what bounces
    int exact_count = 0, swept_count = 0;

    //! [split]
    /// Which islands there are, and to each the solver that it has.
    void begin(const Bodies<3>& bodies, const StepData<3>& now,
               const ChoiceRule& rule, Solving solving, int most_sweeps,
               Real tolerance)
    {
        const bool same =
            all.look(bodies, now, rule, solving, most_sweeps, tolerance);
        const int count = all.islands.count();
        if (!same) {
            exactly.for_each([&](ExactIsland& one) { one.give_back(stock); });
            exactly.clear(count), held.clear(count);
            swept.clear(count), wide.clear(count);
            exact_count = swept_count = 0;
            for (int i = 0; i < count; ++i) place(i, bodies, now);
        }
        // guesses and old factors do not outlive a step
        rescuers.clear(count), struck.clear(count);
        stock.entries = 0;
        for_each_lent([](TreePart& one) { one.forget(); });
        held.for_each([](TreePart& one) { one.forget(); });
        swept.for_each([&](SweptIsland& one) {
            one.part.now.same_rows = one.part.now.same_bodies = same;
        });
    }

    RowsToSolve rows_to_solve(int i)
    {
        return {stock, all.islands.rows_of(i), all.islands.bodies_of(i)};
    }

    void place(int i, const Bodies<3>& bodies, const StepData<3>& now)
    {
        const IslandNote& note = all.note(i);
        const std::span<const int> rows = all.islands.rows_of(i),
                                   members = all.islands.bodies_of(i);
        const Index count = bodies.count();
        swept_count += note.place != IslandPlace::exact && !rows.empty();
        if (note.place == IslandPlace::exact) {
            ++exact_count;
            ExactIsland& one = exactly.take(i);
            one.answered = one.is_known = false;
            return;
        }
        if (note.place == IslandPlace::held) {
            held.take(i).part.take(rows, members, now, count, numbers_);
            return;
        }
        if (static_cast<int>(rows.size()) >= note.lanes || note.steps) {
            wide.take(i).take(all.islands, i, note, bodies, now, numbers_);
            return;
        }
        swept.take(i).part.take(rows, members, now, count, numbers_);
    }
    //! [split]

    /// Trees for an island that has another solver, or for its impacts.
    TreePart& tree_of(IslandPool<TreePart>& pool, int i, const Bodies<3>& bodies,
                      const StepData<3>& now)
    {
        if (TreePart* one = pool.find(i)) return *one;
        TreePart& one = pool.take(i);
        one.part.take(all.islands.rows_of(i), all.islands.bodies_of(i), now,
                      bodies.count(), numbers_);
        one.forget();
        return one;
    }

    //! [meet]
    Corrected corrected(int i)
    {
        if (exactly.find(i) || held.find(i)) return Corrected::arcs_and_errors;
        const bool in_lanes = all.note(i).moves && wide.find(i);
        return in_lanes && all.note(i).trees ? Corrected::overlaps
                                             : Corrected::errors;
    }
    /// Where joints that move were swept in lanes, their errors go out by their trees.
    /// \param visit  of for_each_problem
    template <class Visit>
    void meet_joints(int i, const Bodies<3>& bodies, const StepData<3>& now,
                     const Visit& visit)
    {
        TreePart& one = tree_of(rescuers, i, bodies, now);
        one.part.gather(bodies, now);
        PartApart<TreePart> apart{one};
        visit(all.islands.rows_of(i), all.islands.bodies_of(i), apart,
              Corrected::joints);
    }
    //! [meet]

    //! [apart]
    /// Other problems on the rows of one island.
    struct Apart {
        IslandSolvers& solvers;
        int island;
        const Bodies<3>& bodies;  ///< of the sub-step under way

        /// The biases alone, from rest: v = M⁻¹ Jᵀ Λ.
        void solve_apart(SecondProblem& second, VecX& v, StepData<3>& now)
        {
            const auto by = [&](auto& one) {
                PartApart<std::remove_reference_t<decltype(one)>>{one}.solve_apart(
                    second, v, now);
            };
            const auto by_trees = [&](TreePart& one) {
                by(one);
                one.entries += one.solver.others[second.arcs].bounded.entries;
            };
            if (ExactIsland* one = solvers.exactly.find(island))
                by_trees(one->refresh(solvers.rows_to_solve(island), bodies, now));
            else if (TreePart* tree = solvers.held.find(island)) by_trees(*tree);
            else if (WideIsland* lanes = solvers.wide.find(island)) by(*lanes);
            else if (SweptIsland* some = solvers.swept.find(island)) by(*some);
        }
        /// The rows have another J.
        void factor_again(const Bodies<3>& now_at, const StepData<3>& now)
        {
            if (ExactIsland* one = solvers.exactly.find(island))
                one->refresh(solvers.rows_to_solve(island), now_at, now)
                    .factor_again(now_at, now);
            if (TreePart* one = solvers.held.find(island))
                one->factor_again(now_at, now);
        }
    };
    //! [apart]

    /// What moves does not need all of its old impulses.
    void lessen_start(int i, StepData<3>& now)
    {
        if (!all.note(i).moves) return;
        const std::span<const int> rows = all.islands.rows_of(i);
        if (zeros_.size() != now.u_star.size()) zeros_.setZero(now.u_star.size());
        const Real t = best_part(now, rows, all.islands.bodies_of(i), zeros_);
        if (t < 1)
            for (const int row : rows) now.solution.lambda[row] *= t;
    }

    /// All that exact solves of this step have looked at.
    std::int64_t all_entries()
    {
        std::int64_t sum = stock.entries;
        const auto add = [&sum](TreePart& one) { sum += one.all_entries(); };
        for_each_lent(add);
        held.for_each(add), rescuers.for_each(add), struck.for_each(add);
        return sum;
    }

    /// Those of this sub-step that are not counted yet.
    std::int64_t take_visits()
    {
        std::int64_t sum = std::exchange(stock.visits, 0);
        const auto take = [&sum](auto& one) {
            sum += std::exchange(one.part.visits, 0);
        };
        exactly.for_each(
            [&](ExactIsland& one) { sum += std::exchange(one.visits, 0); });
        for_each_lent(take);
        held.for_each(take), swept.for_each(take);
        wide.for_each(take), rescuers.for_each(take), struck.for_each(take);
        return sum;
    }

private:
    template <class Visit>
    void for_each_lent(const Visit& visit)
    {
        exactly.for_each([&](ExactIsland& one) {
            if (one.trees >= 0) visit(stock.at(one.trees));
        });
    }

    PartNumbers numbers_;
    VecX zeros_;  ///< of the length of u
};

}  // namespace rigid
