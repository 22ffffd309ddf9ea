/// \file island_choice.hpp
/// The solver stage of the engine: each island by the solver that suits it.
///
///     islands of the step ─┬─ small, or cheaper so            trees of joints, and exact rows above them     (chapter 14)
///                          ├─ many rows                       sweeps in lanes until the residual is small   (chapter 16)
///                          └─ all others                      sweeps until the residual is small            (chapter 10)
///                                 └─ not small enough?        exact, if it may be                           (the rescue)
///     what comes to rest                                      exact to the end, if it may be                 (settling)
///
/// Islands share no body that can move, so what each solver finds is the answer to the whole, (10.5). Whatever was done, the
/// natural residual of the rows decides what is called solved. A further solver is a further StepPart.
#pragma once

#include "chapters/10_skipping_work/by_islands.hpp"
#include "chapters/17_engine/island_rescue.hpp"
#include "chapters/17_engine/island_shape.hpp"
#include "chapters/17_engine/known_motion.hpp"
#include "chapters/17_engine/wide_islands.hpp"

namespace rigid {

//! [choice]
struct IslandChoice {
    Solving solving = Solving::by_island;
    ChoiceRule rule;
    Real tolerance = 1e-4;  ///< a residual below this is none [ℓ/s]

    IslandSolver<3> sweeps;
    TreeSolver exact;
    IslandRescue rescuer;
    Islands islands;  ///< of the step
    StepPart swept, exactly;
    WideIslands wide;

    bool was_configured = false;  ///< false: islands are to be listed again
    /// an island of slower bodies is solved to the end; 0 = none [ℓ/s]
    Real slow = 0;

    // Of the last step.
    std::int64_t entries =
        0;  ///< that the solve of `exactly` looked at, less old joints
    int exact_count = 0, swept_count = 0, rescued_count = 0, unsolved = 0;

    void require_valid() const
    {
        if (!(tolerance > 0) || !std::isfinite(tolerance))
            throw std::invalid_argument("the tolerance of the islands is " +
                                        shortest(tolerance) +
                                        "; it must be positive and finite");
        sweeps.require_valid();
        exact.require_valid();
    }

    void solve(Bodies<3>& bodies, StepData<3>& now)
    {
        // as good as sweeps leave it; half of that, for joints add their rounding
        set_price(tolerance * now.length / 2, rule.entries, exact);
        if (now.substep == 0) begin(bodies, now);
        swept.gather(bodies, now);
        exactly.gather(bodies, now);
        if (swept.empty()) sweeps.most_sweeps = 0;
        else {
            sweeps.solve(swept.local, swept.now);
            swept.scatter(bodies, now);
        }
        // noise of sweeps is no reason to stay awake
        wide.solve(sweeps.sweeps, slow > 0 ? tolerance / 10 : tolerance, bodies,
                   now);
        sweeps.most_sweeps = std::max(sweeps.most_sweeps, wide.most_sweeps);
        if (!exactly.empty()) {
            exact.solve(exactly.local, exactly.now);
            entries += exact.bounded.entries;
            exactly.scatter(bodies, now);
        }
        rescue(bodies, now);
        settle(bodies, now);
        judge(bodies, now);
    }
    //! [choice]

    /// Other biases, the same u*.
    void solve_again(SecondProblem& second, Bodies<3>& bodies, StepData<3>& now)
    {
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
        if (!exactly.empty()) entries += exact.bounded_apart.entries;
        second.solution.status = done ? Status::solved : Status::iteration_limit;
    }

    /// All that exact solves of this step have looked at.
    std::int64_t all_entries() const
    {
        return entries + rescuer.entries + joint_entries(exact) +
               joint_entries(rescuer.solver);
    }

    /// The rows have another J.
    void factor_again(const Bodies<3>& bodies, const StepData<3>& now)
    {
        if (exactly.empty()) return;
        exactly.gather_rows(bodies, now);
        exact.factor_again(exactly.local, exactly.now);
    }

private:
    /// Each part with the solver that it has.
    template <class Visit>
    void for_each_part(const Visit& visit)
    {
        visit(swept, sweeps);
        for (WideIsland& one : wide.islands()) visit(one.part, one.solver);
        visit(exactly, exact);
    }

    //! [split]
    /// Which islands there are, and which solver each of them gets. While rows and
    /// bodies are those of the step before, so is that.
    void begin(const Bodies<3>& bodies, const StepData<3>& now)
    {
        // what guesses began from and old factors do not outlive a step, so that
        // its bits depend on the state alone
        exact.bounded.forget();
        exact.bounded_apart.forget();
        rescuer.solver.bounded.forget();
        exactly.second.solution.lambda.setZero();
        rescuer.entries = 0;
        entries = -joint_entries(exact) - joint_entries(rescuer.solver);
        const bool same = motion_.is_same(now.rows) && now.same_rows &&
                          now.same_bodies && was_configured;
        swept.now.same_rows = swept.now.same_bodies = same;
        for (WideIsland& one : wide.islands()) one.part.now.same_rows = same;
        if (same) return;
        was_configured = true;
        find_islands(bodies, now, {}, islands);
        swept.clear();
        exactly.clear();
        wide.count = 0;
        sweeps.allowed.clear();
        exact_count = swept_count = 0;
        place_of_.assign(static_cast<std::size_t>(islands.count()),
                         Place::only_swept);
        for (int i = 0; i < islands.count(); ++i) {
            const std::span<const int> rows = islands.rows_of(i),
                                       members = islands.bodies_of(i);
            Place& place = place_of_[static_cast<std::size_t>(i)];
            int allowed = sweeps.sweeps.max_sweeps;
            std::int64_t to_stand = 0;  // sweeps alone: as many as asked for
            if (!rows.empty() && solving != Solving::sweeps) {
                const IslandShape shape = survey_(bodies, now.rows, rows, members);
                const bool may = may_be_exact(shape, rule);
                if (may) place = Place::swept;
                else to_stand = rule.entries;
                if (solving == Solving::exact ? may : should_be_exact(shape, rule))
                    place = Place::exact;
                allowed = sweeps_worth(shape, rule, allowed);
            }
            exact_count += place == Place::exact;
            swept_count += place != Place::exact && !rows.empty();
            if (place != Place::exact &&
                static_cast<int>(rows.size()) >= rule.wide &&
                wide.take(bodies, now, rows, members, allowed, to_stand))
                continue;
            StepPart& part = place == Place::exact ? exactly : swept;
            part.rows.insert(part.rows.end(), rows.begin(), rows.end());
            part.bodies.insert(part.bodies.end(), members.begin(), members.end());
            if (place != Place::exact)
                sweeps.allowed.insert(sweeps.allowed.end(), rows.size(), allowed);
        }
        swept.number(now, bodies.count());
        exactly.number(now, bodies.count());
    }
    //! [split]

    //! [rescue]
    /// What sweeps have left above the tolerance is solved exactly after all, where
    /// that is possible.
    void rescue(Bodies<3>& bodies, StepData<3>& now)
    {
        rescued_count = 0;
        if (solving != Solving::by_island) return;
        set_price(tolerance * now.length / 2, rule.entries, rescuer.solver);
        rescued_count =
            rescuer(islands, bodies, now, tolerance * now.length, [&](int i) {
                return place_of_[static_cast<std::size_t>(i)] == Place::swept;
            });
    }

    /// What comes to rest is solved to the end: sweeps leave it velocities, and so
    /// does an exact solve that was content with the tolerance.
    void settle(Bodies<3>& bodies, StepData<3>& now)
    {
        if (solving == Solving::sweeps || !(slow > 0)) return;
        set_price(0, rule.entries / 10, rescuer.solver);
        const Real length = now.length, speed = slow * length;
        rescuer(islands, bodies, now, tolerance * length / 1000, [&](int i) {
            return place_of_[static_cast<std::size_t>(i)] != Place::only_swept &&
                   are_slow(islands.bodies_of(i), bodies.u, speed, length);
        });
    }
    //! [rescue]

    void judge(const Bodies<3>& bodies, StepData<3>& now)
    {
        unsolved = 0;
        Real largest = 0;
        for (int i = 0; i < islands.count(); ++i) {
            const Real r = natural_residual(now, islands.rows_of(i), bodies.u);
            unsolved += !(r <= tolerance * now.length);
            if (!(r <= largest)) largest = r;
        }
        now.solution.residual = largest;
        now.solution.iterations = sweeps.most_sweeps;
        now.solution.status =
            unsolved == 0 ? Status::solved : Status::iteration_limit;
    }

    IslandSurveyor survey_;
    /// Where an island is; the last: it must not be solved exactly either.
    enum class Place : std::uint8_t { exact, swept, only_swept };
    std::vector<Place> place_of_;
    KnownMotion motion_;
};

}  // namespace rigid
