/// \file tree_method.hpp
/// Methods of this chapter: the stages of Parts I and II, and the trees for a solver.
#pragma once

#include "chapters/14_joints/joint_method.hpp"
#include "chapters/15_trees/geometric_stiffness.hpp"
#include "chapters/15_trees/loaded_lines.hpp"
#include "chapters/15_trees/tree_solver.hpp"

namespace rigid {

//! [method]
/// \tparam Contacts  AllBodies, or Manifolds where bodies touch each other
template <class Contacts>
struct JointTrees {
    WithLoadedLines<WithFriction<Contacts>> contacts;
    LoadedJoints correction;
    WarmStart start = last_impulses();
    TreeSolver solver;
};

template <class Contacts>
struct JointRattle {
    WithJoints<WithFriction<Contacts>> contacts;
    Rattle correction;
    WarmStart start = last_impulses();
    TreeSolver solver;
};

/// What rests, sleeps.
using SkippingJoints = JointTrees<AwakeManifolds>;
//! [method]

// Compiled once, in tree_method.cpp.
extern template void step(JointedScene&, const StepSettings&,
                          JointTrees<AllBodies>&, StepData<3>&);
extern template void step(JointedScene&, const StepSettings&,
                          JointTrees<Manifolds>&, StepData<3>&);
extern template void step(JointedScene&, const StepSettings&, SkippingJoints&,
                          StepData<3>&);
extern template void step(JointedScene&, const StepSettings&,
                          JointRattle<Manifolds>&, StepData<3>&);

}  // namespace rigid
