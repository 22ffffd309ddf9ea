/// \file lemke_method.hpp
/// The method of this chapter: chapter 4's with Lemke's algorithm for a solver.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/05_lemke/lemke.hpp"

namespace rigid {

struct FindByLemke {
    LemkeSettings settings;

    Solution operator()(const Mlcp& mlcp) const { return lemke(mlcp, settings); }
};

struct LemkeSolver : MatrixSolver<FindByLemke> {
    void require_valid() const { rigid::require_valid(find.settings); }
};

//! [method]
struct LemkeMethod {
    AllPairs contacts;
    WholeError correction;
    ColdStart start;
    LemkeSolver solver;
};
//! [method]

}  // namespace rigid
