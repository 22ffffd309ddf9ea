/// \file island_choice.hpp
/// The solver stage of the engine: each island by the solver that suits it.
///
///     islands of the step ─┬─ small, or badly conditioned     trees of joints, and exact rows above them     (chapter 14)
///                          └─ all others                      sweeps until the residual is small            (chapter 10)
///                                 └─ not small enough?        exact, if it may be                           (the rescue)
///
/// Islands share no body that can move, so what each solver finds is the answer to the whole, (10.5). Whatever was done, the
/// natural residual of the rows decides what is called solved. A further solver is a further StepPart.
#pragma once

#include "chapters/10_skipping_work/by_islands.hpp"
#include "chapters/10_skipping_work/fall_asleep.hpp"
#include "chapters/14_joints/tree_solver.hpp"
#include "chapters/17_engine/definitions.hpp"
#include "chapters/17_engine/island_shape.hpp"
#include "chapters/17_engine/step_part.hpp"

namespace rigid {

//! [choice]
struct IslandChoice {
    Solving solving = Solving::by_island;
    ChoiceRule rule;
    Real tolerance = 1e-4;  ///< a residual below this is none [ℓ/s]

    IslandSolver<3> sweeps;
    TreeSolver exact, rescuer;
    Islands islands;  ///< of the step
    StepPart swept, exactly, rescued;

    bool was_configured = false;  ///< false: islands are to be listed again

    // Of the last step.
    std::int64_t entries = 0;  ///< of matrices, that exact solves looked at
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
        if (now.substep == 0) begin(bodies, now);
        swept.gather(bodies, now);
        exactly.gather(bodies, now);
        if (!swept.empty()) {
            sweeps.solve(swept.local, swept.now);
            swept.scatter(bodies, now);
        }
        if (!exactly.empty()) {
            exact.solve(exactly.local, exactly.now);
            entries += exact.bounded.entries;
            exactly.scatter(bodies, now);
        }
        rescue(bodies, now);
        judge(bodies, now);
    }
    //! [choice]

    /// Other biases, the same u*.
    void solve_again(SecondProblem& second, Bodies<3>& bodies, StepData<3>& now)
    {
        const auto again = [&](StepPart& part, auto& solver) {
            if (part.empty()) return;
            part.gather(second);
            solver.solve_again(part.second, part.local, part.now);
            part.scatter(bodies, now);
        };
        again(swept, sweeps);
        again(exactly, exact);
    }

    /// The biases alone, from rest: v = M⁻¹ Jᵀ Λ.
    void solve_apart(SecondProblem& second, VecX& v, StepData<3>& now)
    {
        bool done = true;
        const auto apart = [&](StepPart& part, auto& solver) {
            if (part.empty()) return;
            part.gather(second);
            part.second.solution.status = Status::solved;
            solver.solve_apart(part.second, part.v, part.now);
            done = done && part.second.solution.status == Status::solved;
            for (const int i : part.now.active)
                v.segment<3>(3 * part.bodies[static_cast<std::size_t>(i)]) =
                    part.v.segment<3>(3 * i);
            now.visits += std::exchange(part.now.visits, 0);
        };
        apart(swept, sweeps);
        apart(exactly, exact);
        if (!exactly.empty()) entries += exact.bounded_apart.entries;
        second.solution.status = done ? Status::solved : Status::iteration_limit;
    }

    /// The rows have another J.
    void factor_again(const Bodies<3>& bodies, const StepData<3>& now)
    {
        if (exactly.empty()) return;
        exactly.gather_rows(bodies, now);
        exact.factor_again(exactly.local, exactly.now);
    }

private:
    //! [split]
    /// Which islands there are, and which solver each of them gets. While rows and
    /// bodies are those of the step before, so is that.
    void begin(const Bodies<3>& bodies, const StepData<3>& now)
    {
        // what guesses began from and old factors do not outlive a step, so that
        // its bits depend on the state alone
        exact.bounded.forget();
        exact.bounded_apart.forget();
        rescuer.bounded.forget();
        exactly.second.solution.lambda.setZero();
        set_price(now.length);
        entries = 0;
        const bool same = same_motion(now.rows) && now.same_rows &&
                          now.same_bodies && was_configured;
        swept.now.same_rows = swept.now.same_bodies = same;
        if (same) return;
        was_configured = true;
        find_islands(bodies, now, {}, islands);
        swept.clear();
        exactly.clear();
        exact_count = swept_count = 0;
        may_be_exact_.assign(static_cast<std::size_t>(islands.count()), 0);
        for (int i = 0; i < islands.count(); ++i) {
            const std::span<const int> rows = islands.rows_of(i),
                                       members = islands.bodies_of(i);
            StepPart* part = &swept;
            if (!rows.empty() && solving != Solving::sweeps) {
                const IslandShape shape = survey_(bodies, now.rows, rows, members);
                const bool may = may_be_exact(shape, rule);
                may_be_exact_[static_cast<std::size_t>(i)] = may;
                if (solving == Solving::exact ? may : should_be_exact(shape, rule))
                    part = &exactly;
            }
            exact_count += part == &exactly;
            swept_count += part == &swept && !rows.empty();
            part->rows.insert(part->rows.end(), rows.begin(), rows.end());
            part->bodies.insert(part->bodies.end(), members.begin(), members.end());
            if (part == &exactly) may_be_exact_[static_cast<std::size_t>(i)] = 0;
        }
        swept.number(now, bodies.count());
        exactly.number(now, bodies.count());
    }
    //! [split]

    //! [price]
    /// What a solve may cost, and how good it must be where guesses do not settle it:
    /// as good as sweeps would leave it. (Half of that: joints add their rounding.)
    void set_price(Real length)
    {
        for (FrictionSettings* const how : {&exact.exact, &rescuer.exact}) {
            how->late = tolerance * length / 2;
            how->most_entries = rule.entries;
        }
    }
    //! [price]

    /// Whether rows move the bodies that they moved in the step before. A heavy body
    /// and a short arm may make that nothing in one step and something in the next.
    bool same_motion(const std::vector<Row<3>>& rows)
    {
        bool same = motion_.size() == rows.size();
        motion_.resize(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto here =
                static_cast<char>(2 * moves_a(rows[i]) + moves_b(rows[i]));
            same = same && motion_[i] == here;
            motion_[i] = here;
        }
        return same;
    }

    //! [rescue]
    /// What sweeps have left above the tolerance is solved exactly after all, where
    /// that is possible.
    void rescue(Bodies<3>& bodies, StepData<3>& now)
    {
        rescued_count = 0;
        if (solving != Solving::by_island || swept.empty()) return;
        rescued.clear();
        for (int i = 0; i < islands.count(); ++i) {
            if (!may_be_exact_[static_cast<std::size_t>(i)]) continue;
            const std::span<const int> rows = islands.rows_of(i),
                                       members = islands.bodies_of(i);
            if (natural_residual(now, rows, bodies.u) <= tolerance * now.length)
                continue;
            ++rescued_count;
            rescued.rows.insert(rescued.rows.end(), rows.begin(), rows.end());
            rescued.bodies.insert(rescued.bodies.end(), members.begin(),
                                  members.end());
        }
        if (rescued.empty()) return;
        rescued.number(now, bodies.count());
        rescued.gather(bodies, now);
        rescuer.solve(rescued.local, rescued.now);
        entries += rescuer.bounded.entries;
        rescued.scatter(bodies, now);
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
    std::vector<char> may_be_exact_;  ///< of each island that is swept
    std::vector<char> motion_;        ///< of each row: which of its bodies it moves
};

}  // namespace rigid
