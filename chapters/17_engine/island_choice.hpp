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
/// Islands share no body that can move, so what each solver finds is the answer to the whole, (10.5). Whatever was done, the
/// natural residual of the rows decides what is called solved. A further solver is a further StepPart.
#pragma once

#include "chapters/10_skipping_work/by_islands.hpp"
#include "chapters/17_engine/exact_islands.hpp"
#include "chapters/17_engine/island_places.hpp"
#include "chapters/17_engine/wide_islands.hpp"

namespace rigid {

//! [choice]
struct IslandChoice {
    Solving solving = Solving::by_island;
    ChoiceRule rule;
    Real tolerance = 1e-4;  ///< a residual below this is none [ℓ/s]
    /// an island of slower bodies is solved to the end; 0 = none [ℓ/s]
    Real slow = 0;

    IslandPlaces all;  ///< of the step
    IslandSolver<3> sweeps;
    StepPart swept;
    WideIslands wide;
    ExactIslands exactly;
    TreePart held;
    IslandRescue rescuer;

    // Of the last step.
    int exact_count = 0, swept_count = 0, rescued_count = 0, unsolved = 0;

    void require_valid() const
    {
        if (!(tolerance > 0) || !std::isfinite(tolerance))
            throw std::invalid_argument("the tolerance of the islands is " +
                                        shortest(tolerance) +
                                        "; it must be positive and finite");
        sweeps.require_valid();
        exactly.solver.require_valid();
    }

    void solve(Bodies<3>& bodies, StepData<3>& now)
    {
        // as good as sweeps leave it; half of that, for joints add their rounding
        for (TreeSolver* solver : {&exactly.solver, &held.solver})
            set_price(tolerance * now.length / 2, rule.entries, rule, *solver);
        if (now.substep == 0) begin(bodies, now);
        lessen_start(now);
        swept.gather(bodies, now);
        if (swept.empty()) sweeps.most_sweeps = 0;
        else {
            sweeps.solve(swept.local, swept.now);
            swept.scatter(bodies, now);
        }
        // noise of sweeps is no reason to stay awake
        wide.solve(sweeps.sweeps, slow > 0 ? tolerance / 10 : tolerance, bodies,
                   now);
        sweeps.most_sweeps = std::max(sweeps.most_sweeps, wide.most_sweeps);
        exactly.solve(all.islands, tolerance * now.length / 1000, bodies, now);
        held.solve(bodies, now);
        rescue(bodies, now);
        settle(bodies, now);
        judge(bodies, now);
    }
    //! [choice]

    /// Other biases, the same u*.
    void solve_again(SecondProblem& second, Bodies<3>& bodies, StepData<3>& now)
    {
        exactly.refresh(now);
        for_each_part([&](StepPart& part, auto& solver) {
            if (part.empty()) return;
            part.gather(second);
            solver.solve_again(part.second, part.local, part.now);
            part.scatter(bodies, now);
        });
    }

    /// The biases alone, from rest: v = M⁻¹ Jᵀ Λ.
    void solve_apart(SecondProblem& second, VecX& v, StepData<3>& now)
    {
        bool done = true;
        exactly.refresh(now);
        for_each_part([&](StepPart& part, auto& solver) {
            if (part.empty()) return;
            part.gather(second);
            part.second.solution.status = Status::solved;
            solver.solve_apart(part.second, part.v, part.now);
            done = done && part.second.solution.status == Status::solved;
            for (const int i : part.now.active)
                v.segment<3>(3 * part.bodies[static_cast<std::size_t>(i)]) =
                    part.v.segment<3>(3 * i);
            now.visits += std::exchange(part.now.visits, 0);
        });
        for (TreePart* it : {static_cast<TreePart*>(&exactly), &held})
            if (!it->part.empty()) it->entries += it->solver.bounded_apart.entries;
        second.solution.status = done ? Status::solved : Status::iteration_limit;
    }

    /// All that exact solves of this step have looked at.
    std::int64_t all_entries() const
    {
        return exactly.all_entries() + held.all_entries() + rescuer.all_entries();
    }

    /// The rows have another J.
    void factor_again(const Bodies<3>& bodies, const StepData<3>& now)
    {
        exactly.factor_again(bodies, now);
        held.factor_again(bodies, now);
    }

private:
    /// Each part with the solver that it has.
    template <class Visit>
    void for_each_part(const Visit& visit)
    {
        visit(swept, sweeps);
        for (WideIsland& one : wide.islands()) visit(one.part, one.solver);
        visit(exactly.part, exactly.solver);
        visit(held.part, held.solver);
    }

    //! [split]
    /// Which islands there are, and each to the solver that it has.
    void begin(const Bodies<3>& bodies, const StepData<3>& now)
    {
        exactly.forget();
        held.forget();
        rescuer.forget();
        const bool same =
            all.look(bodies, now, rule, solving, sweeps.sweeps.max_sweeps,
                     tolerance * now.length);
        swept.now.same_rows = swept.now.same_bodies = same;
        for (WideIsland& one : wide.islands()) one.part.now.same_rows = same;
        if (same) return;
        swept.clear();
        held.part.clear();
        exactly.clear();
        wide.count = 0;
        sweeps.allowed.clear();
        sweeps.enough.clear();
        exact_count = swept_count = 0;
        for (int i = 0; i < all.islands.count(); ++i) {
            const IslandNote& note = all.note(i);
            const std::span<const int> rows = all.islands.rows_of(i),
                                       members = all.islands.bodies_of(i);
            const bool goes = note.place >= IslandPlace::swept;
            swept_count += note.place != IslandPlace::exact && !rows.empty();
            if (note.place == IslandPlace::exact) {
                exactly.add(all.islands, i);
                continue;
            }
            if (goes && static_cast<int>(rows.size()) >= rule.wide &&
                wide.take(bodies, now, rows, members, note))
                continue;
            (goes ? swept : held.part).add(rows, members);
            if (!goes) continue;
            sweeps.allowed.insert(sweeps.allowed.end(), rows.size(), note.sweeps);
            sweeps.enough.insert(sweeps.enough.end(), rows.size(),
                                 note.until / now.length);
        }
        exact_count = static_cast<int>(exactly.all.size());
        for (StepPart* part : {&swept, &exactly.part, &held.part})
            part->number(now, bodies.count());
    }
    //! [split]

    //! [rescue]
    /// What sweeps have left above what is good enough is solved exactly after all,
    /// where that is possible.
    void rescue(Bodies<3>& bodies, StepData<3>& now)
    {
        rescued_count = 0;
        if (solving != Solving::by_island) return;
        set_price(tolerance * now.length / 2, rule.entries, rule, rescuer.solver);
        rescued_count = rescuer(all.islands, bodies, now,
                                [&](int i) { return all.rescued_above(i); });
    }

    /// What comes to rest is solved to the end: sweeps leave it velocities, and so
    /// does an exact solve that was content with the tolerance.
    void settle(Bodies<3>& bodies, StepData<3>& now)
    {
        if (solving == Solving::sweeps || !(slow > 0)) return;
        set_price(0, rule.entries / 10, rule, rescuer.solver);
        const Real length = now.length, speed = slow * length;
        rescuer(all.islands, bodies, now, [&](int i) {
            const IslandPlace place = all.place(i);
            const bool meant =
                (place == IslandPlace::swept ||
                 (place == IslandPlace::exact && !exactly.answered)) &&
                are_slow(all.islands.bodies_of(i), bodies.u, speed, length);
            return meant ? tolerance * length / 1000 : infinity;
        });
    }
    //! [rescue]

    /// What moves does not need all of its old impulses.
    void lessen_start(StepData<3>& now)
    {
        for (int i = 0; i < all.islands.count(); ++i) {
            if (!all.note(i).moves) continue;
            const std::span<const int> rows = all.islands.rows_of(i);
            if (zeros_.size() != now.u_star.size())
                zeros_.setZero(now.u_star.size());
            const Real t = best_part(now, rows, all.islands.bodies_of(i), zeros_);
            if (t < 1)
                for (const int row : rows) now.solution.lambda[row] *= t;
        }
    }

    void judge(const Bodies<3>& bodies, StepData<3>& now)
    {
        unsolved = 0;
        Real largest = 0;
        for (int i = 0; i < all.islands.count(); ++i) {
            const Real r =
                exactly.answered && all.place(i) == IslandPlace::exact
                    ? exactly.residual(i)
                    : natural_residual(now, all.islands.rows_of(i), bodies.u);
            unsolved += !(r <= all.note(i).enough);
            if (!(r <= largest || std::isnan(largest))) largest = r;
        }
        now.solution.residual = largest;
        now.solution.iterations = sweeps.most_sweeps;
        now.solution.status =
            unsolved == 0 ? Status::solved : Status::iteration_limit;
    }

    VecX zeros_;  ///< of the length of u
};

}  // namespace rigid
