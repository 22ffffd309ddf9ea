/// \file soft_method.hpp
/// Methods of this chapter: the same stages, with springs for errors, with positions before velocities, with bodies in place
/// of rows.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/14_joints/joint_method.hpp"
#include "chapters/16_soft_constraints/block_descent.hpp"
#include "chapters/16_soft_constraints/soft_correction.hpp"
#include "chapters/16_soft_constraints/xpbd.hpp"

namespace rigid {

//! [method]
/// \tparam Contacts  AllBodies, or Manifolds where bodies touch each other
template <class Contacts>
struct SoftSweeps {
    WithJoints<WithFriction<Contacts>> contacts;
    SoftCorrection correction;
    WarmStart start;
    ImpulseSolver<3> solver;
};

template <class Contacts>
struct PositionSweeps {
    WithJoints<WithFriction<Contacts>> contacts;
    Xpbd correction;
    ColdStart start;
    FreeVelocities solver;
};

template <class Contacts>
struct BodyDescent {
    WithJoints<WithFriction<Contacts>> contacts;
    BlockDescent correction;
    WarmStart start = last_impulses();
    FreeVelocities solver;
};

/// The same soft rows, solved exactly.
template <class Contacts>
struct SoftExact {
    WithJoints<WithFriction<Contacts>> contacts;
    SoftCorrection correction;
    WarmStart start = last_impulses();
    CoulombSolver<FindFriction> solver;
};
//! [method]

// Compiled once, in soft_method.cpp.
extern template void step(JointedScene&, const StepSettings&,
                          SoftSweeps<Manifolds>&, StepData<3>&);
extern template void step(JointedScene&, const StepSettings&,
                          PositionSweeps<Manifolds>&, StepData<3>&);
extern template void step(JointedScene&, const StepSettings&,
                          BodyDescent<Manifolds>&, StepData<3>&);

}  // namespace rigid
