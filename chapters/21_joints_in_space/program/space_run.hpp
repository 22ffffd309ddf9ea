/// \file space_run.hpp
/// Bodies on joints: solved at once, or swept island by island.
#pragma once

#include "chapters/20_turning_in_space/program/solid_run.hpp"
#include "chapters/21_joints_in_space/joint_methods.hpp"

namespace rigid {

class JointSteps {
public:
    explicit JointSteps(const SolidSetup<JointedSolids>&)
    {
        islands_.solver.sweeps = {200, 1e-9};
    }

    void step(JointedSolids& scene, const Settings& settings,
              const StepSettings& how, StepData<6>& now)
    {
        if (settings.method == "exact") rigid::step(scene, how, exact_, now);
        else rigid::step(scene, how, islands_, now);
    }
    static void draw_ground(SolidPicture&, const JointedSolids&) {}
    static void draw_more(SolidPicture&, const JointedSolids&) {}

private:
    SpaceExact exact_;
    SpaceIslands islands_;
};

using JointState = SolidState<JointedSolids>;
using JointSetup = SolidSetup<JointedSolids>;
inline constexpr auto joint_demo = solid_demo<JointedSolids, JointSteps>;

}  // namespace rigid
