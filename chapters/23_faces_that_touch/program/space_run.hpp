/// \file space_run.hpp
/// Smooth solids that touch: at up to four points of a pair, or at the deepest alone.
#pragma once

#include "chapters/20_turning_in_space/program/solid_run.hpp"
#include "chapters/23_faces_that_touch/smooth_touching.hpp"

#include <algorithm>

namespace rigid {

/// The deepest overlap of contacts where the step found them [m].
inline Real deepest_overlap(const StepData<6>& now)
{
    Real deepest = 0;
    for (const Constraint<6>& c : now.constraints)
        if (c.kind == ConstraintKind::unilateral) deepest = std::max(deepest, -c.C);
    return deepest;
}

class TouchingSteps {
public:
    explicit TouchingSteps(const SolidSetup<WalledSolids>&)
    {
        one_point_.contacts.points = 1;
    }

    void step(WalledSolids& scene, const Settings& settings,
              const StepSettings& how, StepData<6>& now)
    {
        SmoothSweeps& method =
            settings.method == "one_point" ? one_point_ : four_points_;
        method.solver.sweeps = {static_cast<int>(settings["sweeps"]), 1e-6};
        rigid::step(scene, how, method, now);
    }
    static void draw_ground(SolidPicture&, const WalledSolids&) {}
    static void draw_more(SolidPicture&, const WalledSolids&) {}

private:
    SmoothSweeps four_points_, one_point_;
};

using TouchingState = SolidState<WalledSolids>;
using TouchingSetup = SolidSetup<WalledSolids>;
inline constexpr auto touching_demo = solid_demo<WalledSolids, TouchingSteps>;

}  // namespace rigid
