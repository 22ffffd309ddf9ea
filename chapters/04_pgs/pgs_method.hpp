/// \file pgs_method.hpp
/// The method of this chapter: chapter 3's with sweeps for a solver.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/04_pgs/pgs.hpp"

namespace rigid {

/// pgs() with the memory that it keeps; it starts from the λ that it is given.
struct FindBySweeps {
    PgsSettings settings;
    PgsMemory memory;

    void operator()(const Mlcp& mlcp, Solution& solution)
    {
        pgs(mlcp, settings, memory, solution);
    }
};

struct PgsSolver : MatrixSolver<FindBySweeps> {
    void require_valid() const { rigid::require_valid(find.settings); }
};

//! [method]
struct PgsMethod {
    AllPairs contacts;
    WholeError correction;
    ColdStart start;
    PgsSolver solver;
};
//! [method]

}  // namespace rigid
