/// \file joint_method.hpp
/// Methods of this chapter: those of chapter 13 with joints on top of their contacts.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/12_contact_manifolds/manifold_method.hpp"
#include "chapters/13_friction/friction_solver.hpp"
#include "chapters/14_joints/joint_stage.hpp"

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

/// All rows at once, by the solver of chapter 13; errors are corrected whole, apart
/// from velocities.
template <class Contacts>
struct ExactJoints {
    WithJoints<WithFriction<Contacts>> contacts;
    Correction correction = exact_correction();
    WarmStart start = last_impulses();
    CoulombSolver<FindFriction> solver;
};
//! [method]

//! [never_stop]
/// Contacts of limbs: one that is stopped alone on its way is torn off its joints, so
/// none is. Instead their rows are there before they come (12.14).
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
                          ExactJoints<AllBodies>&, StepData<3>&);
extern template void step(JointedScene&, const StepSettings&,
                          ExactJoints<Manifolds>&, StepData<3>&);

}  // namespace rigid
