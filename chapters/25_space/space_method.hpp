/// \file space_method.hpp
/// Methods of this chapter: the stages of Part I, with 6 in place of 2.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/07_baumgarte/correction.hpp"
#include "chapters/08_warm_starting/warm_start.hpp"
#include "chapters/09_active_sets/exact_method.hpp"
#include "chapters/10_skipping_work/by_islands.hpp"
#include "chapters/25_space/cone_solver.hpp"
#include "chapters/25_space/loaded_solids.hpp"
#include "chapters/25_space/space_touching.hpp"

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

//! [touching]
/// What keeps a stack at rest: contacts stay closed by a thousandth of ℓ, and what
/// corrects them leaves no velocity.
inline Correction closed_contacts()
{
    Correction correction;
    correction.method = Stabilizer::split_impulse;
    correction.slop = 0.001;
    return correction;
}

/// Solids that touch. With chapter 6's sweeps the rows of friction are a box, with
/// ConeSolver a disc.
template <class Solver, class Contacts = TouchingSolids>
struct TouchingMethod {
    Contacts contacts;
    LoadedSolids correction = closed_contacts();
    WarmStart start;
    Solver solver;
};
using TouchingBoxes = TouchingMethod<ImpulseSolver<6>>;
using TouchingCones = TouchingMethod<ConeSolver>;

/// Islands of up to so many rows solved by Algorithm 25.2, larger ones swept: a factor
/// of bodies that all hang together grows faster than their number.
inline TouchingCones exact_cones(int rows = 1000)
{
    TouchingCones method;
    method.solver.exact_rows = rows;
    method.solver.sweeps = {50, 1e-9};
    return method;
}
//! [touching]

// Compiled once, in space_method.cpp.
extern template void step(SpaceScene&, const StepSettings&, SpaceSweeps&,
                          StepData<6>&);
extern template void step(SpaceScene&, const StepSettings&, SpaceExact&,
                          StepData<6>&);
extern template void step(SpaceScene&, const StepSettings&, SpaceIslands&,
                          StepData<6>&);
extern template void step(SpaceScene&, const StepSettings&, TouchingBoxes&,
                          StepData<6>&);
extern template void step(SpaceScene&, const StepSettings&, TouchingCones&,
                          StepData<6>&);

}  // namespace rigid
