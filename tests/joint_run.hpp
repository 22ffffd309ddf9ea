/// \file joint_run.hpp
/// Steps of a scene with joints, and how far its joints came apart meanwhile.
#pragma once

#include "chapters/14_joints/joint_method.hpp"

#include <algorithm>

/// \return  the largest error of a joint after any of the steps [m]
template <class Method>
rigid::Real run(rigid::JointedScene& scene, Method& method, rigid::Real h, long steps, int substeps = 1)
{
    rigid::StepData<3> now;
    rigid::Real worst = 0;
    for (long i = 0; i < steps; ++i) {
        step(scene, {.h = h, .substeps = substeps}, method, now);
        worst = std::max(worst, largest_joint_error(scene));
    }
    return worst;
}
