/// \file wide_islands.hpp
/// A large island, swept in lanes by chapter 17's solver.
///
///     it moves, a heap                            small steps of its own (heap_steps.hpp)
///     it moves, and something bounces             as many sweeps as are allowed
///     it stands                                   with momentum, as many as an exact solve may cost                          (18.4)
///         and all of it is slow                   further, until velocities are none: a heap that is too large to be solved
///                                                 exactly, as many as that needs
///
/// What stands begins its next step with this λ, so these sweeps are made once. What moves would have to make them in each step.
#pragma once

#include "chapters/17_wide_sweeps/wide_solver.hpp"
#include "chapters/18_islands/heap_steps.hpp"
#include "chapters/18_islands/island_places.hpp"

namespace rigid {

//! [wide]
/// One large island, its rows in lanes.
struct WideIsland {
    StepPart part;
    WideSolver<3> solver;
    int standing = 0;  ///< sweeps, where it stands
    HeapInLanes heap;
    bool stepped = false;  ///< by small steps, in this sub-step
    /// nothing moved when the sub-step began: it has been put down, or solved to the end
    bool lay = false;

    void take(const Islands& islands, int island, const IslandNote& note,
              const Bodies<3>& bodies, const StepData<3>& now, PartNumbers& numbers)
    {
        const std::span<const int> rows = islands.rows_of(island);
        part.take(rows, islands.bodies_of(island), now, bodies.count(), numbers);
        part.gather_rows(bodies, now);
        bundle_rows(part.now.rows, part.local.count(), solver.bundles);
        solver.colour(part.local, part.now);
        part.now.same_rows = has_rows_ = true;
        sweep_price_ = price_of_momentum(static_cast<std::int64_t>(rows.size()));
        // 10⁶ sweeps are more than any island that is large can pay for
        standing = static_cast<int>(
            std::min<std::int64_t>(note.to_stand / sweep_price_, 1'000'000));
    }

    /// \param sweeps  of islands that move
    /// \param slow    what is slower comes to rest; 0 = nothing [ℓ/s]
    void solve(const ImpulseSettings& sweeps, Real slow, const IslandNote& note,
               Bodies<3>& bodies, StepData<3>& now)
    {
        stepped = has_rows_ = false;
        part.gather(bodies, now);
        const StepData<3>& here = part.now;
        lay = are_slow(here.active, part.local.u, rounding * here.length,
                       here.length);
        const int at_rest = std::max(standing, note.to_rest);
        const bool stays = at_rest > note.sweeps && stand(here.active, part.local.u,
                                                          here.u_star, here.length);
        const bool rests = stays && are_slow(here.active, part.local.u,
                                             slow * here.length, here.length);
        solver.sweeps = sweeps;
        solver.sweeps.max_sweeps =
            stays ? std::max(standing, note.sweeps) : note.sweeps;
        solver.sweeps.tolerance =
            stays ? enough(note, rests, sweeps.tolerance) : note.until / now.length;
        began_ = rests ? first_residual() : 0;
        // once: what begins with as little has been there
        if (rests && note.to_rest > 0 &&
            began_ > sweeps.tolerance / 10 * here.length)
            solver.sweeps.max_sweeps = at_rest;
        solver.momentum = stays;
        solver.solve(part.local, part.now);
        part.scatter(bodies, now);
    }
    //! [wide]

    /// What the sweeps of the last solve cost, where it stands [entries]
    std::int64_t spent() const
    {
        return part.now.solution.iterations * sweep_price_;
    }

    /// Whether its sweeps go on in the next step: they halve what they begin with.
    /// \param r  the residual that they have left [m/s]
    bool get_on(Real r) const { return began_ > 2 * r; }

    /// (18.4a), of what moves
    void small_steps(const HeapSteps& how, const IslandNote& note,
                     Bodies<3>& bodies, StepData<3>& now)
    {
        if (!has_rows_) {
            part.gather_rows(bodies, now);
            solver.begin(part.local, part.now);
        }
        part.gather_velocities(bodies, now);
        heap(how, how.count(note.length), note.joined, now, part, solver.bundles,
             solver.wide);
        part.scatter(bodies, now);
        has_rows_ = false;
        stepped = true;
    }

private:
    /// Where a heap rests, sweeps go on as far as an exact solve would, and further
    /// where none may follow: what is left of each contact adds up to the speed of the
    /// top. Joints, which need no guesses, are left to an exact solve.
    /// \param tolerance  of the islands [ℓ/s]
    static Real enough(const IslandNote& note, bool rests, Real tolerance)
    {
        const bool is_left = note.joined && note.to_settle > 0;
        if (rests && note.to_rest > 0)
            return std::max(settled(tolerance) / 10, rounding);
        if (rests && note.may_be_exact && !is_left) return settled(tolerance);
        return note.may_be_exact ? tolerance : tolerance / 10;
    }
    /// The natural residual of the impulses that it begins with [m/s]; the velocities
    /// of the part are then theirs, until it is solved.
    Real first_residual()
    {
        const StepData<3>& here = part.now;
        const VecX& lambda = here.solution.lambda;
        for (const int k : here.active)
            part.local.velocity(k) = here.u_star.segment<3>(3 * k);
        for (std::size_t i = 0; i < here.rows.size(); ++i)
            here.rows[i].apply(lambda[static_cast<Index>(i)], part.local.u);
        return natural_residual(here.rows, lambda, part.local.u, here.length);
    }

    static constexpr Real rounding = 1e-10;  ///< of thousands of sweeps [ℓ/s]
    std::int64_t sweep_price_ = 0;           ///< of what stands [entries]
    Real began_ = 0;         ///< residual, of what rests, before its sweeps [m/s]
    bool has_rows_ = false;  ///< those of this sub-step are in `part`
};

}  // namespace rigid
