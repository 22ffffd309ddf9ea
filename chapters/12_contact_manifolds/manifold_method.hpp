/// \file manifold_method.hpp
/// Methods of this chapter: chapter 11's with manifolds for its contacts stage.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/11_rotation/rigid_method.hpp"
#include "chapters/12_contact_manifolds/manifold_stage.hpp"

namespace rigid {

//! [method]
struct ManifoldSweeps {
    Manifolds contacts;
    Correction correction;
    WarmStart start;
    ImpulseSolver<3> solver;
};

struct ManifoldExact {
    Manifolds contacts;
    Correction correction;
    ColdStart start;
    ExactSolver solver;
};
//! [method]

// Compiled once, in manifold_method.cpp.
extern template void step(RigidScene&, const StepSettings&, ManifoldSweeps&,
                          StepData<3>&);
extern template void step(RigidScene&, const StepSettings&, ManifoldExact&,
                          StepData<3>&);

}  // namespace rigid
