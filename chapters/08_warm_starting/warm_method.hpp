/// \file warm_method.hpp
/// The method of this chapter: chapter 7's with another start.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/07_baumgarte/correction.hpp"
#include "chapters/08_warm_starting/warm_start.hpp"

namespace rigid {

/// As it is, it corrects by Baumgarte's bias, whose energy no start bounds. Errors corrected outside of the impulses (none,
/// split_impulse, projection) leave (8.15): no scene gains energy from a start at the best multiple.
//! [method]
struct WarmMethod {
    AllPairs contacts;
    Correction correction;
    WarmStart start;
    ImpulseSolver<2> solver;
};
//! [method]

// Compiled once, in warm_method.cpp.
extern template void step(DiscScene&, const StepSettings&, WarmMethod&,
                          StepData<2>&);

}  // namespace rigid
