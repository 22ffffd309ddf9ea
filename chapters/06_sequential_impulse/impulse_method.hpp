/// \file impulse_method.hpp
/// The method of this chapter: chapter 4's without the matrix. A position error is left alone.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/06_sequential_impulse/restitution.hpp"

namespace rigid {

//! [method]
struct ImpulseMethod {
    AllPairs contacts;
    LeaveErrors correction;
    ColdStart start;
    ImpulseSolver<2> solver;
};
//! [method]

// Compiled once, in impulse_method.cpp.
extern template void step(DiscScene&, const StepSettings&, ImpulseMethod&,
                          StepData<2>&);

}  // namespace rigid
