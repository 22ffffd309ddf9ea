/// \file first_guess.hpp
/// Where the guesses begin: with the cases of the previous step; with all rows active; or with what a few sweeps say.
#pragma once

#include "chapters/09_active_sets/block_principal_pivoting.hpp"

#include <algorithm>

namespace rigid {

/// One visit to each row (4.4).
void visit_rows(const GuessedProblem& problem, VecX& lambda);

inline void clamp_into_bounds(const Mlcp& mlcp, VecX& lambda)
{
    for (Index i = 0; i < mlcp.size(); ++i)
        lambda[i] = std::clamp(lambda[i], mlcp.lo[i], mlcp.hi[i]);
}

/// The case that each λ is in.
void cases_of(const Mlcp& mlcp, const VecX& lambda, std::vector<BoundState>& cases);

/// The previous cases, where a row can have them. Without any: every row active
/// where a factor is cheap, since piles rest on most of their contacts; else what
/// two sweeps from zero say.
/// \param cheap  whether A is sparse or small
void begin(const GuessedProblem& problem, const std::vector<BoundState>& previous,
           bool cheap, Guess& guess);

}  // namespace rigid
