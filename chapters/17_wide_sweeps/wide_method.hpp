/// \file wide_method.hpp
/// The method of this chapter: chapter 13's sweeps with one stage replaced, the solver.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/14_joints/joint_method.hpp"
#include "chapters/17_wide_sweeps/wide_solver.hpp"

namespace rigid {

//! [method]
/// \tparam T, L  numbers of what kind, and how many side by side
template <class Contacts, class T = Real, int L = full_lanes<T>>
struct WideSweeps {
    WithJoints<WithFriction<Contacts>> contacts;
    Correction correction = steady_contacts();
    WarmStart start;
    WideSolver<3, T, L> solver;
};
//! [method]

// Compiled once, in wide_method.cpp.
extern template void step(JointedScene&, const StepSettings&,
                          WideSweeps<Manifolds>&, StepData<3>&);
extern template void step(JointedScene&, const StepSettings&,
                          WideSweeps<Manifolds, float>&, StepData<3>&);

}  // namespace rigid
