/// \file exact_solvers.hpp
/// The book's exact solvers by name, each compiled once: their matrix templates take a compiler's time.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <cstdint>
#include <functional>

namespace rigid::results {

Solution solve_direct(const Mlcp& mlcp);  ///< chapter 3: all rows bilateral, sparse LDLᵀ
Solution solve_by_cases(
    const Mlcp& mlcp);  ///< chapter 3: eliminates the bilateral rows, stops at the first set that fits
Solution solve_by_lemke(const Mlcp& mlcp);  ///< chapter 5

/// Chapter 9, with memory of its own: returns factorisations, updated ones included.
using ActiveSets = std::function<std::int64_t(const Mlcp&, Solution&)>;
ActiveSets new_active_sets();

}  // namespace rigid::results
