/// \file joint_run.hpp
/// What the tests of joints share: steps of a scene, with how far its joints came apart meanwhile, and the biases of rows.
#pragma once

#include "chapters/14_joints/joint_method.hpp"

#include <algorithm>
#include <vector>

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

/// \return  b of each row [m/s, rad/s]
inline rigid::VecX biases_of(const std::vector<rigid::Row<3>>& rows)
{
    rigid::VecX b(static_cast<rigid::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) b[static_cast<rigid::Index>(i)] = rows[i].bias;
    return b;
}
