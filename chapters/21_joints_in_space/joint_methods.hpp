/// \file joint_methods.hpp
/// Methods of this chapter: the stages of Part I, with 6 in place of 2.
#pragma once

#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/07_baumgarte/correction.hpp"
#include "chapters/08_warm_starting/warm_start.hpp"
#include "chapters/09_active_sets/exact_method.hpp"
#include "chapters/10_skipping_work/by_islands.hpp"
#include "chapters/21_joints_in_space/all_solids.hpp"

namespace rigid {

//! [method]
struct SpaceSweeps {
    AllSolids contacts;
    Correction correction;
    WarmStart start;
    ImpulseSolver<6> solver;
};

struct SpaceExact {
    AllSolids contacts;
    Correction correction;
    ColdStart start;
    ExactSolver solver;
};

struct SpaceIslands {
    AllSolids contacts;
    Correction correction;
    WarmStart start;
    IslandSolver<6> solver;
};
//! [method]

// Compiled once, in joint_methods.cpp.
extern template void step(JointedSolids&, const StepSettings&, SpaceSweeps&,
                          StepData<6>&);
extern template void step(JointedSolids&, const StepSettings&, SpaceExact&,
                          StepData<6>&);
extern template void step(JointedSolids&, const StepSettings&, SpaceIslands&,
                          StepData<6>&);

}  // namespace rigid
