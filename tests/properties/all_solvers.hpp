/// \file all_solvers.hpp
/// Every solver of chapters 3, 4, 5 and 9 that takes an Mlcp, asked one after the other.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rigid::properties {

/// What one solver said. A problem that is not for it is refused, and then there is no answer here.
struct Answer {
    std::string solver;
    Solution solution;
    Real enough = 0;  ///< [m/s] the tolerance that it was given, where that is a velocity
};

/// Keeps the memory of those solvers that have one from problem to problem, as a program does.
class AllSolvers {
public:
    AllSolvers();
    ~AllSolvers();
    /// \throws whatever a solver throws but std::invalid_argument, which is a refusal
    std::vector<Answer> solve(const Mlcp& mlcp);

private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

}  // namespace rigid::properties
