/// \file wide_islands.hpp
/// Large islands, each swept in lanes by chapter 16's solver.
///
///     it moves                                    as many sweeps as are allowed
///     it stands and no exact solve may follow     as many as an exact solve may cost, entries / (8 n) for n rows             (17.4)
///
/// What stands begins its next step with this λ, so these sweeps are made once. What moves would have to make them in each step.
#pragma once

#include "chapters/16_wide_sweeps/wide_solver.hpp"
#include "chapters/17_engine/island_places.hpp"

namespace rigid {

//! [wide]
/// One large island, its rows in lanes.
struct WideIsland {
    StepPart part;
    WideSolver<3> solver;
    int allowed = 0;   ///< sweeps, where it moves
    int standing = 0;  ///< and where it stands
    Real enough = 0;   ///< their tolerance, where it moves [ℓ/s]
};

struct WideIslands {
    std::vector<WideIsland> all;  ///< memory of those that were, too
    std::size_t count = 0;
    int most_sweeps = 0;  ///< of the island that needed the most

    std::span<WideIsland> islands() { return {all.data(), count}; }

    /// Takes an island in, if chapter 16 can: what bounds a row is in its bundle.
    /// \return  whether it did
    bool take(const Bodies<3>& bodies, const StepData<3>& now,
              std::span<const int> rows, std::span<const int> members,
              const IslandNote& note)
    {
        if (count == all.size()) all.emplace_back();
        WideIsland& one = all[count];
        one.part.rows.assign(rows.begin(), rows.end());
        one.part.bodies.assign(members.begin(), members.end());
        one.part.number(now, bodies.count());
        one.part.gather_rows(bodies, now);
        bundle_rows(one.part.now.rows, one.part.local.count(), trial_);
        if (!holds_bounds(one.part.now.rows, trial_)) return false;
        one.part.now.same_rows = false;
        one.allowed = note.sweeps;
        one.enough = note.until / now.length;
        const auto visited = static_cast<std::int64_t>(rows.size()) * price::visit;
        // 10⁶ sweeps are more than any island that is large can pay for
        one.standing = static_cast<int>(
            std::min<std::int64_t>(note.to_stand / visited, 1'000'000));
        ++count;
        return true;
    }

    /// \param sweeps  of islands that move
    /// \param enough  the tolerance of those that stand [ℓ/s]
    void solve(const ImpulseSettings& sweeps, Real enough, Bodies<3>& bodies,
               StepData<3>& now)
    {
        if (now.substep == 0) most_sweeps = 0;
        for (WideIsland& one : islands()) {
            one.part.gather(bodies, now);
            const StepData<3>& here = one.part.now;
            const bool stays =
                one.standing > one.allowed &&
                stand(here.active, one.part.local.u, here.u_star, here.length);
            one.solver.sweeps = sweeps;
            one.solver.sweeps.max_sweeps = stays ? one.standing : one.allowed;
            one.solver.sweeps.tolerance = stays ? enough : one.enough;
            one.solver.solve(one.part.local, one.part.now);
            most_sweeps = std::max(most_sweeps, one.part.now.solution.iterations);
            one.part.scatter(bodies, now);
        }
    }
    //! [wide]

private:
    Bundles trial_;
};

}  // namespace rigid
