/// \file active_sets.hpp
/// Exact answers by guessing which rows are active, and correcting the guess.
///
///     w = A λ + q,   lo ≤ λ ≤ hi,   λ_i = lo_i or λ_i = hi_i or w_i = 0
///
/// (Provisional: the signatures are final, the inside is not.)
#pragma once

#include "chapters/03_mlcp_formulation/cases.hpp"
#include "chapters/05_lemke/lemke.hpp"

#include <span>
#include <vector>

namespace rigid {

struct ActiveSetSettings {
    Real tolerance = 1e-10;  ///< of the natural residual, as a share of the largest |q|
    int limit = 0;           ///< of factorisations; 0 = 1000 + n
    int patience = 5;        ///< flips of all wrong rows without progress before one row at a time
};

/// Memory that is kept from solve to solve, yesterday's guess, and what the last solve cost.
struct ActiveSetMemory {
    std::vector<RowCase> cases;  ///< yesterday's answer: which rows are at a bound, and at which

    int factorisations = 0;  ///< of the active rows, anew
    int updates = 0;         ///< solves with an older factorisation and a border of changed rows
    int flips = 0;           ///< rows that changed their case
    int single_flips = 0;    ///< of these, one at a time
    int outer_steps = 0;     ///< proximal steps; 0 = A needed none
    int walks = 0;           ///< times that Lemke's algorithm had to be asked
    Index entries = 0;       ///< entries of L in the last factorisation
    bool sparse = false;     ///< which of the two factorisations was used
};

/// Warm: starts from the guess in memory if it has the size of the problem.
inline void active_sets(const Mlcp& mlcp, const ActiveSetSettings& settings, ActiveSetMemory& memory,
                        Solution& solution)
{
    solution = lemke(mlcp, {{}, {}, settings.limit, settings.tolerance});
    memory.walks = 1;
    memory.cases.assign(static_cast<std::size_t>(mlcp.size()), RowCase::at_lo);
}

/// Cold.
inline Solution active_sets(const Mlcp& mlcp, const ActiveSetSettings& settings = {})
{
    ActiveSetMemory memory;
    Solution solution;
    active_sets(mlcp, settings, memory, solution);
    return solution;
}

/// One index at a time, with memory for the counters (pivots in solution.iterations).
inline Solution dantzig(const Mlcp& mlcp, const ActiveSetSettings& settings = {})
{
    return lemke(mlcp, {{}, {}, settings.limit, settings.tolerance});
}

/// Row `row` is bounded by ±mu times the λ of row `normal`.
struct FrictionBox {
    Index row = 0, normal = 0;
    Real mu = 0;
};

void active_sets(const Mlcp& mlcp, std::span<const FrictionBox> boxes, const ActiveSetSettings& settings,
                 ActiveSetMemory& memory, Solution& solution);
inline Solution active_sets(const Mlcp& mlcp, std::span<const FrictionBox>,
                            const ActiveSetSettings& settings = {})
{
    return active_sets(mlcp, settings);
}

}  // namespace rigid
