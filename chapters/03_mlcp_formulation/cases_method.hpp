/// \file cases_method.hpp
/// The method of this chapter: every stage in its plainest form, and the exact answer by cases.
#pragma once

#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/03_mlcp_formulation/step.hpp"

namespace rigid {

struct FindByCases {
    EnumerationSettings settings;

    Solution operator()(const Mlcp& mlcp) const { return schur(mlcp, settings); }
};

//! [method]
struct CasesMethod {
    AllPairs contacts;
    WholeError correction;
    ColdStart start;
    MatrixSolver<FindByCases> solver;
};
//! [method]

}  // namespace rigid
