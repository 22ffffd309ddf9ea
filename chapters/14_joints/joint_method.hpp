/// \file joint_method.hpp
/// Methods of this chapter: the stages of Parts I and II, and the trees for a solver.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/12_contact_manifolds/manifold_method.hpp"
#include "chapters/13_friction/friction_solver.hpp"
#include "chapters/14_joints/geometric_stiffness.hpp"
#include "chapters/14_joints/joint_stage.hpp"
#include "chapters/14_joints/tree_solver.hpp"

namespace rigid {

//! [method]
/// \tparam Contacts  AllBodies, or Manifolds where bodies touch each other
template <class Contacts>
struct JointSweeps {
    WithJoints<WithFriction<Contacts>> contacts;
    Correction correction;
    WarmStart start;
    ImpulseSolver<3> solver;
};

template <class Contacts>
struct JointTrees {
    WithJoints<WithFriction<Contacts>> contacts =
        with_inerters<WithFriction<Contacts>>();
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

//! [never_stop]
/// Contacts of limbs: one that is stopped alone on its way is torn off its joints, so
/// none is. Instead their rows are there before they come (12.6c).
inline void never_stop(Manifolds& contacts)
{
    contacts.fast.stop = false;
    contacts.ahead = 1;
}
//! [never_stop]

// Compiled once, in joint_method.cpp.
extern template void step(JointedScene&, const StepSettings&,
                          JointSweeps<AllBodies>&, StepData<3>&);
extern template void step(JointedScene&, const StepSettings&,
                          JointSweeps<Manifolds>&, StepData<3>&);
extern template void step(JointedScene&, const StepSettings&,
                          JointTrees<AllBodies>&, StepData<3>&);
extern template void step(JointedScene&, const StepSettings&,
                          JointTrees<Manifolds>&, StepData<3>&);
extern template void step(JointedScene&, const StepSettings&, SkippingJoints&,
                          StepData<3>&);
extern template void step(JointedScene&, const StepSettings&,
                          JointRattle<Manifolds>&, StepData<3>&);

}  // namespace rigid
