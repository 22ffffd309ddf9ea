/// \file island_choice.hpp
/// The solver stage of this chapter: each island by the solver that suits it.
///
///     islands of the step ─┬─ small, or cheaper so            trees of joints, and exact rows above them     (chapter 15)
///                          │      └─ as it was?              the impulses of the step before
///                          ├─ joints that sweeps would lose  trees of joints, and sweeps above them        (chapter 15)
///                          ├─ a heap that moves               small steps of its own, in lanes              (chapters 8, 17)
///                          ├─ many rows                       sweeps in lanes until the residual is small   (chapter 17)
///                          └─ all others                      sweeps until the residual is small            (chapter 10)
///                                 └─ not small enough?        exact, if it may be                           (the rescue)
///     what comes to rest                                      exact to the end, if it may be                 (settling)
///
/// Islands share no body that can move, so what each solver finds is the answer to the whole, (10.5), and what one of them is
/// does not change a bit of another. Whatever was done, the natural residual of the rows decides what is called solved.
#pragma once

#include "chapters/10_skipping_work/by_islands.hpp"
#include "chapters/15_trees/newton_positions.hpp"
#include "chapters/18_islands/island_solvers.hpp"
#include "common/jobs.hpp"

namespace rigid {

//! [choice]
struct IslandChoice : IslandSolvers, PlainSolver {
    Solving solving = Solving::by_island;
    ChoiceRule rule;
    Real tolerance = 1e-4;  ///< a residual below this is none [ℓ/s]
    ImpulseSettings sweeps;
    int most_exact = 600;  ///< rows with bounds of an island that is solved exactly
    Real slow = 0;    ///< an island of slower bodies is solved to the end [ℓ/s]
    HeapSteps heaps;  ///< of heaps that move
    Jobs jobs;        ///< for islands
    Reflections reflections;

    // Of the last step.
    int rescued_count = 0;
    int stepped_count = 0;   ///< heaps that went by small steps
    int answered_count = 0;  ///< of the exact ones, by their old impulses
    int most_sweeps = 0;     ///< of the island that needed the most

    void require_valid() const;
    Real noise() const { return sweeps.tolerance; }
    const Islands* islands_found() const { return &all.islands; }

    void solve(Bodies<3>& bodies, StepData<3>& now)
    {
        if (now.substep == 0) {
            begin(bodies, now, rule, solving, sweeps.max_sweeps,
                  tolerance * now.length);
            most_sweeps = 0;
            reflections.bounced.clear();
        }
        set_price(tolerance * now.length / 2, rule.entries, rule, stock.exact);
        stock.most_exact = most_exact;
        late_.clear();
        bodies_ = &bodies;
        answered_count = rescued_count = stepped_count = unsolved = 0;
        now.solution.residual = 0;
        const int count = all.islands.count();
        for (int i = 0; i < count; ++i) {
            lessen_start(i, now);
            reflect(i, bodies, now);
        }
        pieces.list(all.islands);
        in_pieces(jobs, pieces.count(), 1, [&](int first, int end) {
            for (int i = pieces.begin(first); i < pieces.begin(end); ++i)
                solve_island(i, bodies, now);
        });
        for (int i = 0; i < count; ++i) {
            look_again(i, bodies, now);
            judge(i, bodies, now);
            if (struck.find(i))
                reflections.add_impulses(all.islands.rows_of(i), now);
        }
        now.visits += take_visits();
        now.solution.iterations = most_sweeps;
        now.solution.status =
            unsolved == 0 ? Status::solved : Status::iteration_limit;
    }
    //! [choice]

    void bounce_late(Bodies<3>& bodies, StepData<3>& now)
    {
        for (const int i : late_) {
            PartApart<TreePart> apart{*struck.find(i)};
            reflections.at_the_end(all.islands.rows_of(i), all.islands.bodies_of(i),
                                   apart, bodies, now);
        }
    }

    /// \param visit  (rows, bodies, what solves them apart, what is corrected)
    template <class Visit>
    void for_each_problem(const StepData<3>& now, const Visit& visit)
    {
        for (int i = 0; i < all.islands.count(); ++i) {
            if (const WideIsland* lanes = wide.find(i); lanes && lanes->stepped) {
                lanes->heap.move(lanes->part, *bodies_);  // it is there already
                if (!all.note(i).joined) continue;
            }
            Apart apart{*this, i, *bodies_};
            const Corrected what = corrected(i);
            visit(all.islands.rows_of(i), all.islands.bodies_of(i), apart, what);
            if (what == Corrected::overlaps) meet_joints(i, *bodies_, now, visit);
        }
    }

private:
    //! [reflect]
    /// Impacts come first, and their joints and contacts are solved exactly.
    void reflect(int i, const Bodies<3>& bodies, StepData<3>& now)
    {
        const std::span<const int> rows = all.islands.rows_of(i);
        if (!bounces(rows, now)) return;
        TreePart& one = tree_of(struck, i, bodies, now);
        prepare(one, tolerance * now.length / 2, rule.entries, most_exact);
        one.part.gather(bodies, now);
        one.solver.factor_again(one.part.local, one.part.now);
        PartApart<TreePart> apart{one};
        reflections(rows, all.islands.bodies_of(i), apart, bodies, now);
        if (reflections.any_late) late_.push_back(i);
    }
    //! [reflect]

    //! [solve_island]
    void solve_island(int i, Bodies<3>& bodies, StepData<3>& now)
    {
        const IslandNote& note = all.note(i);
        // as good as sweeps leave it; half of that: joints add their rounding
        const Real late = tolerance * now.length / 2;
        WideIsland* lanes = wide.find(i);
        if (lanes && note.steps && !bounces(all.islands.rows_of(i), now)) {
            lanes->small_steps(heaps, note, bodies, now);
            return;
        }
        if (ExactIsland* one = exactly.find(i)) {
            one->solve(rows_to_solve(i), settled(tolerance * now.length),
                       slow * now.length, bodies, now);
        } else if (TreePart* tree = held.find(i)) {
            prepare(*tree, late, rule.entries, std::max(1, rule.always));
            tree->solver.sweeps = rule.held;
            tree->solve(bodies, now);
        } else if (lanes) {
            lanes->solve(sweeps, slow, note, bodies, now);
        } else if (SweptIsland* some = swept.find(i)) {
            some->part.gather(bodies, now);
            some->solver.sweeps = sweeps;
            some->solver.sweeps.max_sweeps = note.sweeps;
            some->solver.sweeps.tolerance = note.until / now.length;
            // where nothing is solved to the end, what comes to rest is swept on
            some->solver.slow = solving == Solving::sweeps ? slow : 0;
            some->solver.solve(some->part.local, some->part.now);
            some->part.scatter(bodies, now);
        }
    }
    //! [solve_island]

    /// What has been solved is counted, and what should be solved further is.
    void look_again(int i, Bodies<3>& bodies, StepData<3>& now)
    {
        if (const ExactIsland* one = exactly.find(i))
            answered_count += one->answered;
        else if (const WideIsland* lanes = wide.find(i)) {
            if (lanes->stepped) return;
            most_sweeps =
                std::max(most_sweeps, lanes->part.now.solution.iterations);
        } else if (const SweptIsland* some = swept.find(i))
            most_sweeps = std::max(most_sweeps, some->solver.most_sweeps);
        rescue(i, bodies, now);
        settle(i, bodies, now);
    }

    void prepare(TreePart& one, Real late, std::int64_t entries, int most) const
    {
        one.solver.most_exact = most;
        set_price(late, entries, rule, one.solver.exact);
    }

    //! [rescue]
    /// What sweeps leave above what is good enough is solved exactly, if it may be.
    void rescue(int i, Bodies<3>& bodies, StepData<3>& now)
    {
        const Real most = all.rescued_above(i);
        if (solving != Solving::by_island || most == infinity ||
            natural_residual(now, all.islands.rows_of(i), bodies.u) <= most)
            return;
        ++rescued_count;
        solve_after_all(i, tolerance * now.length / 2, rule.entries, bodies, now);
    }

    /// What comes to rest is solved to the end, after sweeps and lenient exact solves.
    void settle(int i, Bodies<3>& bodies, StepData<3>& now)
    {
        const IslandNote& note = all.note(i);
        if (solving == Solving::sweeps || !(slow > 0) || note.to_settle == 0)
            return;
        const auto is_slow = [&](Real speed) {
            return are_slow(all.islands.bodies_of(i), bodies.u, speed, now.length);
        };
        const ExactIsland* one = exactly.find(i);
        if ((note.place != IslandPlace::swept && !(one && !one->answered)) ||
            !is_slow(slow * now.length))
            return;
        const Real r = natural_residual(now, all.islands.rows_of(i), bodies.u);
        const WideIsland* lanes = wide.find(i);
        if (r <= settled(tolerance * now.length)) {
            // after many sweeps guesses, which begin there and cost no more
            if (lanes && lanes->lay && lanes->spent() >= note.to_stand / 10)
                solve_after_all(i, 0, lanes->spent(), bodies, now);
        } else if (!(lanes && lanes->get_on(r)) &&
                   is_slow(note.length * r))  // (18.11)
            solve_after_all(i, 0, note.to_settle, bodies, now);
    }

    void solve_after_all(int i, Real late, std::int64_t entries, Bodies<3>& bodies,
                         StepData<3>& now)
    {
        TreePart& one = tree_of(rescuers, i, bodies, now);
        prepare(one, late, entries, most_exact);
        one.solve(bodies, now);
    }
    //! [rescue]

    void judge(int i, const Bodies<3>& bodies, StepData<3>& now)
    {
        const ExactIsland* one = exactly.find(i);
        const WideIsland* lanes = wide.find(i);
        const bool stepped = lanes && lanes->stepped;
        const Real r =
            one && one->answered ? one->residual
            : stepped            ? lanes->heap.residual
                      : natural_residual(now, all.islands.rows_of(i), bodies.u);
        // small steps have no answer to compare with: that they are numbers is all
        const bool good = stepped ? std::isfinite(r) : r <= all.note(i).enough;
        stepped_count += stepped;
        unsolved += !good;
        Real& largest = now.solution.residual;
        if (!(r <= largest || std::isnan(largest))) largest = r;
    }

    Bodies<3>* bodies_ = nullptr;  ///< of the sub-step under way
    std::vector<int> late_;        ///< islands with bounces at the end
};

}  // namespace rigid
