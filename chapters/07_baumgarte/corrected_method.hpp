/// \file corrected_method.hpp
/// The method of this chapter: chapter 6's with another correction.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/07_baumgarte/correction.hpp"

namespace rigid {

//! [method]
struct CorrectedMethod {
    AllPairs contacts;
    Correction correction;
    ColdStart start;
    ImpulseSolver<2> solver;
};
//! [method]

// Compiled once, in corrected_method.cpp.
extern template void step(DiscScene&, const StepSettings&, CorrectedMethod&,
                          StepData<2>&);

}  // namespace rigid
