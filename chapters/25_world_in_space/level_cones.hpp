/// \file level_cones.hpp
/// Chapter 24's solver, its sweeps side by side: the same bits, sooner.
#pragma once

#include "chapters/24_friction_is_a_disc/cone_solver.hpp"
#include "chapters/25_world_in_space/level_sweeps.hpp"

#include <algorithm>

namespace rigid {

//! [level_cones]
struct LevelCones : ConeSolver {
    /// rows that share no body are visited side by side; false: one by one, which
    /// gives the same bits
    bool wide = true;

    LevelSweeps<std::min(full_lanes<Real>, 4)> lanes;  ///< eight are no faster
    std::vector<int> swept;  ///< islands that are not done

    void solve(Bodies<6>& bodies, StepData<6>& now)
    {
        if (!wide || corners != 0) return ConeSolver::solve(bodies, now);
        begin(bodies, now);
        solve_together(bodies, now);
        finish(now);
    }
    //! [level_cones]

private:
    /// Each island ends by itself, and leaves its lanes.
    void solve_together(Bodies<6>& bodies, StepData<6>& now);

    /// Whether an island ends after n sweeps.
    bool is_done(int island, int n, VecX& u, StepData<6>& now);
};

}  // namespace rigid
