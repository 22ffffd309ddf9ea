/// \file island_choice.hpp
/// The solver stage of the engine: each island by the solver that suits it.
///
///     islands of the step ─┬─ small, or cheaper so            trees of joints, and exact rows above them     (chapter 14)
///                          │      └─ as it was?              the impulses of the step before
///                          ├─ joints that sweeps would lose  trees of joints, and sweeps above them        (chapter 14)
///                          ├─ many rows                       sweeps in lanes until the residual is small   (chapter 16)
///                          └─ all others                      sweeps until the residual is small            (chapter 10)
///                                 └─ not small enough?        exact, if it may be                           (the rescue)
///     what comes to rest                                      exact to the end, if it may be                 (settling)
///
/// Islands share no body that can move, so what each solver finds is the answer to the whole, (10.5), and what one of them is
/// does not change a bit of another. Whatever was done, the natural residual of the rows decides what is called solved.
#pragma once

#include "chapters/10_skipping_work/by_islands.hpp"
#include "chapters/14_joints/newton_positions.hpp"
#include "chapters/17_engine/exact_islands.hpp"
#include "chapters/17_engine/island_places.hpp"
#include "chapters/17_engine/wide_islands.hpp"

#include <deque>

namespace rigid {

/// Islands that one kind of solver has in a step; keeps the memory of those that were.
template <class Island>
struct IslandPool {
    std::deque<Island> all;
    int count = 0;
    std::vector<int> place;  ///< of each island of the step here; −1

    void clear(int islands)
    {
        count = 0;
        place.assign(static_cast<std::size_t>(islands), -1);
    }
    Island& take(int island)
    {
        if (count == static_cast<int>(all.size())) all.emplace_back();
        place[static_cast<std::size_t>(island)] = count;
        return all[static_cast<std::size_t>(count++)];
    }
    /// The one that was taken last is none after all.
    void give_back(int island)
    {
        --count;
        place[static_cast<std::size_t>(island)] = -1;
    }
    Island* find(int island)
    {
        const int at = place[static_cast<std::size_t>(island)];
        return at < 0 ? nullptr : &all[static_cast<std::size_t>(at)];
    }
    template <class Visit>
    void for_each(const Visit& visit)
    {
        for (int i = 0; i < count; ++i) visit(all[static_cast<std::size_t>(i)]);
    }
};

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
};

//! [choice]
struct IslandChoice {
    Solving solving = Solving::by_island;
    ChoiceRule rule;
    Real tolerance = 1e-4;  ///< a residual below this is none [ℓ/s]
    ImpulseSettings sweeps;
    int most_exact = 600;  ///< rows with bounds of an island that is solved exactly
    /// an island of slower bodies is solved to the end; 0 = none [ℓ/s]
    Real slow = 0;

    IslandPlaces all;  ///< of the step
    IslandPool<ExactIsland> exactly;
    IslandPool<TreePart> held;
    IslandPool<SweptIsland> swept;
    IslandPool<WideIsland> wide;
    IslandPool<TreePart> rescuers;
    IslandPool<TreePart> struck;  ///< what bounces
    Reflections reflections;

    // Of the last step.
    int exact_count = 0, swept_count = 0, rescued_count = 0, unsolved = 0;
    int answered_count = 0;  ///< of the exact ones, by their old impulses
    int most_sweeps = 0;     ///< of the island that needed the most

    void require_valid() const
    {
        if (!(tolerance > 0) || !std::isfinite(tolerance))
            throw std::invalid_argument("the tolerance of the islands is " +
                                        shortest(tolerance) +
                                        "; it must be positive and finite");
        rigid::require_valid(sweeps);
    }

    void solve(Bodies<3>& bodies, StepData<3>& now)
    {
        if (now.substep == 0) begin(bodies, now);
        bodies_ = &bodies;
        answered_count = rescued_count = unsolved = 0;
        now.solution.residual = 0;
        for (int i = 0; i < all.islands.count(); ++i) {
            lessen_start(i, now);
            reflect(i, bodies, now);
            solve_island(i, bodies, now);
            judge(i, bodies, now);
            if (struck.find(i))
                reflections.add_impulses(all.islands.rows_of(i), now);
        }
        now.solution.iterations = most_sweeps;
        now.solution.status =
            unsolved == 0 ? Status::solved : Status::iteration_limit;
    }
    //! [choice]

    /// Each island is a problem by itself.
    /// \param visit  (rows, bodies, what solves them apart, whether joints are met)
    template <class Visit>
    void for_each_problem(const StepData<3>&, const Visit& visit)
    {
        for (int i = 0; i < all.islands.count(); ++i) {
            Apart apart{*this, i};
            visit(all.islands.rows_of(i), all.islands.bodies_of(i), apart,
                  exactly.find(i) != nullptr || held.find(i) != nullptr);
        }
    }

    /// All that exact solves of this step have looked at.
    std::int64_t all_entries()
    {
        std::int64_t sum = 0;
        const auto add = [&sum](TreePart& one) { sum += one.all_entries(); };
        exactly.for_each(add), held.for_each(add), rescuers.for_each(add);
        return sum;
    }

private:
    //! [apart]
    /// Other problems on the rows of one island.
    struct Apart {
        IslandChoice& choice;
        int island;

        /// The biases alone, from rest: v = M⁻¹ Jᵀ Λ.
        void solve_apart(SecondProblem& second, VecX& v, StepData<3>& now)
        {
            if (ExactIsland* one = choice.exactly.find(island))
                one->refresh(*choice.bodies_, now);
            choice.with_solver(island, [&](auto& one) {
                PartApart<std::remove_reference_t<decltype(one)>>{one}.solve_apart(
                    second, v, now);
            });
            for (TreePart* one :
                 {static_cast<TreePart*>(choice.exactly.find(island)),
                  choice.held.find(island)})
                if (one)
                    one->entries += one->solver.others[second.arcs].bounded.entries;
        }
        /// The rows have another J.
        void factor_again(const Bodies<3>& bodies, const StepData<3>& now)
        {
            if (ExactIsland* one = choice.exactly.find(island))
                one->factor_again(bodies, now);
            if (TreePart* one = choice.held.find(island))
                one->factor_again(bodies, now);
        }
    };
    //! [apart]

    /// The island as it has a solver.
    template <class Visit>
    void with_solver(int island, const Visit& visit)
    {
        if (ExactIsland* one = exactly.find(island)) visit(*one);
        else if (TreePart* tree = held.find(island)) visit(*tree);
        else if (WideIsland* lanes = wide.find(island)) visit(*lanes);
        else if (SweptIsland* some = swept.find(island)) visit(*some);
    }

    //! [split]
    /// Which islands there are, and to each the solver that it has.
    void begin(const Bodies<3>& bodies, const StepData<3>& now)
    {
        const bool same = all.look(bodies, now, rule, solving, sweeps.max_sweeps,
                                   tolerance * now.length);
        const int count = all.islands.count();
        most_sweeps = 0;
        if (!same) {
            exactly.clear(count), held.clear(count);
            swept.clear(count), wide.clear(count);
            exact_count = swept_count = 0;
            for (int i = 0; i < count; ++i) place(i, bodies, now);
        }
        // guesses and old factors do not outlive a step
        rescuers.clear(count), struck.clear(count);
        const auto forget = [](TreePart& one) { one.forget(); };
        exactly.for_each(forget), held.for_each(forget);
        swept.for_each([&](SweptIsland& one) {
            one.part.now.same_rows = one.part.now.same_bodies = same;
        });
        wide.for_each([&](WideIsland& one) { one.part.now.same_rows = same; });
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
            exactly.take(i).take(all.islands, i, now, count, numbers_);
            return;
        }
        if (note.place == IslandPlace::held) {
            held.take(i).part.take(rows, members, now, count, numbers_);
            return;
        }
        if (static_cast<int>(rows.size()) >= rule.wide) {
            if (wide.take(i).take(all.islands, i, note, bodies, now, numbers_))
                return;
            wide.give_back(i);
        }
        swept.take(i).part.take(rows, members, now, count, numbers_);
    }
    //! [split]

    //! [reflect]
    /// Impacts come first, and their joints and contacts are solved exactly.
    void reflect(int i, const Bodies<3>& bodies, StepData<3>& now)
    {
        if (now.restitution.empty()) return;
        const std::span<const int> rows = all.islands.rows_of(i);
        const auto bounces = [&](int row) {
            return now.restitution[static_cast<std::size_t>(row)] > 0;
        };
        if (std::none_of(rows.begin(), rows.end(), bounces)) return;
        TreePart* one = struck.find(i);
        if (!one) {
            one = &struck.take(i);
            one->part.take(rows, all.islands.bodies_of(i), now, bodies.count(),
                           numbers_);
            one->forget();
        }
        prepare(*one, tolerance * now.length / 2, rule.entries, most_exact);
        one->part.gather(bodies, now);
        one->solver.factor_again(one->part.local, one->part.now);
        PartApart<TreePart> apart{*one};
        reflections(rows, all.islands.bodies_of(i), apart, bodies, now);
    }
    //! [reflect]

    //! [solve_island]
    void solve_island(int i, Bodies<3>& bodies, StepData<3>& now)
    {
        const IslandNote& note = all.note(i);
        // as good as sweeps leave it; half of that, for joints add their rounding
        const Real late = tolerance * now.length / 2;
        if (ExactIsland* one = exactly.find(i)) {
            prepare(*one, late, rule.entries, most_exact);
            one->solve(tolerance * now.length / 1000, bodies, now);
            answered_count += one->answered;
        } else if (TreePart* tree = held.find(i)) {
            prepare(*tree, late, rule.entries, std::max(1, rule.always));
            tree->solver.sweeps = rule.held;
            tree->solve(bodies, now);
        } else if (WideIsland* lanes = wide.find(i)) {
            // noise of sweeps is no reason to stay awake
            lanes->solve(sweeps, slow > 0 ? tolerance / 10 : tolerance, note,
                         bodies, now);
            most_sweeps =
                std::max(most_sweeps, lanes->part.now.solution.iterations);
        } else if (SweptIsland* some = swept.find(i)) {
            some->part.gather(bodies, now);
            some->solver.sweeps = sweeps;
            some->solver.sweeps.max_sweeps = note.sweeps;
            some->solver.sweeps.tolerance = note.until / now.length;
            // where nothing is solved to the end, what comes to rest is swept on
            some->solver.slow = solving == Solving::sweeps ? slow : 0;
            some->solver.solve(some->part.local, some->part.now);
            some->part.scatter(bodies, now);
            most_sweeps = std::max(most_sweeps, some->solver.most_sweeps);
        }
        rescue(i, bodies, now);
        settle(i, bodies, now);
    }
    //! [solve_island]

    void prepare(TreePart& one, Real late, std::int64_t entries, int most) const
    {
        one.solver.most_exact = most;
        set_price(late, entries, rule, one.solver);
    }

    //! [rescue]
    /// What sweeps have left above what is good enough is solved exactly after all,
    /// where that is possible.
    void rescue(int i, Bodies<3>& bodies, StepData<3>& now)
    {
        const Real most = all.rescued_above(i);
        if (solving != Solving::by_island || most == infinity ||
            natural_residual(now, all.islands.rows_of(i), bodies.u) <= most)
            return;
        ++rescued_count;
        solve_after_all(i, tolerance * now.length / 2, rule.entries, bodies, now);
    }

    /// What comes to rest is solved to the end: sweeps leave it velocities, and so
    /// does an exact solve that was content with the tolerance.
    void settle(int i, Bodies<3>& bodies, StepData<3>& now)
    {
        if (solving == Solving::sweeps || !(slow > 0)) return;
        const IslandPlace place = all.place(i);
        const ExactIsland* one = exactly.find(i);
        const Real length = now.length;
        const bool meant =
            (place == IslandPlace::swept || (one && !one->answered)) &&
            are_slow(all.islands.bodies_of(i), bodies.u, slow * length, length);
        if (meant && !(natural_residual(now, all.islands.rows_of(i), bodies.u) <=
                       tolerance * length / 1000))
            solve_after_all(i, 0, rule.entries / 10, bodies, now);
    }

    void solve_after_all(int i, Real late, std::int64_t entries, Bodies<3>& bodies,
                         StepData<3>& now)
    {
        TreePart* one = rescuers.find(i);
        if (!one) {
            one = &rescuers.take(i);
            one->part.take(all.islands.rows_of(i), all.islands.bodies_of(i), now,
                           bodies.count(), numbers_);
            one->forget();
        }
        prepare(*one, late, entries, most_exact);
        one->solve(bodies, now);
    }
    //! [rescue]

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

    void judge(int i, const Bodies<3>& bodies, StepData<3>& now)
    {
        const ExactIsland* one = exactly.find(i);
        const Real r =
            one && one->answered
                ? one->residual
                : natural_residual(now, all.islands.rows_of(i), bodies.u);
        unsolved += !(r <= all.note(i).enough);
        Real& largest = now.solution.residual;
        if (!(r <= largest || std::isnan(largest))) largest = r;
    }

    PartNumbers numbers_;
    const Bodies<3>* bodies_ = nullptr;  ///< of the sub-step under way
    VecX zeros_;                         ///< of the length of u
};
static_assert(SolvesProblems<IslandChoice>);

}  // namespace rigid
