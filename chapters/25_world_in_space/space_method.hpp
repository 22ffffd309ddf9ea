/// \file space_method.hpp
/// Methods of this chapter: solids that touch anything, their discs swept side by side.
#pragma once

#include "chapters/21_joints_in_space/joint_methods.hpp"
#include "chapters/25_world_in_space/level_cones.hpp"
#include "chapters/25_world_in_space/space_touching.hpp"

namespace rigid {

//! [touching]
using TouchingBoxes = TouchingMethod<ImpulseSolver<6>, TouchingSolids>;
using TouchingCones = TouchingMethod<LevelCones, TouchingSolids>;

/// Islands of up to so many rows solved by Algorithm 24.2, larger ones swept.
inline TouchingCones exact_cones(int rows = 1000)
{
    return solved_exactly<TouchingCones>(rows);
}
//! [touching]

// Compiled once, in space_method.cpp.
extern template void step(SpaceScene&, const StepSettings&, SpaceSweeps&,
                          StepData<6>&);
extern template void step(SpaceScene&, const StepSettings&, SpaceExact&,
                          StepData<6>&);
extern template void step(SpaceScene&, const StepSettings&, SpaceIslands&,
                          StepData<6>&);
extern template void step(SpaceScene&, const StepSettings&, TouchingBoxes&,
                          StepData<6>&);
extern template void step(SpaceScene&, const StepSettings&, TouchingCones&,
                          StepData<6>&);

}  // namespace rigid
