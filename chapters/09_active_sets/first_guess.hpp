/// \file first_guess.hpp
/// Where the guesses begin: with the cases of the previous step; with all rows active; or with what a few sweeps say.
#pragma once

#include "chapters/09_active_sets/block_principal_pivoting.hpp"

#include <algorithm>

namespace rigid {

/// One visit to each row (4.4).
inline void visit_rows(const GuessedProblem& problem, VecX& lambda)
{
    const Mlcp& mlcp = *problem.mlcp;
    for (Index i = 0; i < mlcp.size(); ++i) {
        Real w = problem.q[i], a = 0;
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            w += entry.value() * lambda[entry.col()];
            if (entry.col() == i) a = entry.value();
        }
        if (problem.shifted) {
            w += problem.shift[i] * lambda[i];
            a += problem.shift[i];
        }
        if (a > 0)
            lambda[i] = std::clamp(lambda[i] - w / a, mlcp.lo[i], mlcp.hi[i]);
    }
}

inline void clamp_into_bounds(const Mlcp& mlcp, VecX& lambda)
{
    for (Index i = 0; i < mlcp.size(); ++i)
        lambda[i] = std::clamp(lambda[i], mlcp.lo[i], mlcp.hi[i]);
}

/// The case that each λ is in.
inline void cases_of(const Mlcp& mlcp, const VecX& lambda,
                     std::vector<BoundState>& cases)
{
    for (Index i = 0; i < mlcp.size(); ++i)
        cases[static_cast<std::size_t>(i)] =
            lambda[i] <= mlcp.lo[i]   ? BoundState::at_lo
            : lambda[i] >= mlcp.hi[i] ? BoundState::at_hi
                                      : BoundState::between;
}

//! [begin]
/// The previous cases, where a row can have them. Without any: every row active
/// where a factor is cheap, since piles rest on most of their contacts; else what
/// two sweeps from zero say.
/// \param cheap  whether A is sparse or small
inline void begin(const GuessedProblem& problem,
                  const std::vector<BoundState>& previous, bool cheap, Guess& guess)
{
    const Mlcp& mlcp = *problem.mlcp;
    const auto n = static_cast<std::size_t>(mlcp.size());
    const bool known = previous.size() == n;
    guess.cases.resize(n);
    guess.wrong.clear();
    guess.w = problem.q;
    guess.step.resize(mlcp.size());
    // if no guess can be solved, this is what is left: it must be a number
    guess.lambda.setZero(mlcp.size());
    clamp_into_bounds(mlcp, guess.lambda);
    if (!known && !cheap) {
        visit_rows(problem, guess.lambda);
        visit_rows(problem, guess.lambda);
        cases_of(mlcp, guess.lambda, guess.cases);
    }
    for (std::size_t k = 0; k < n; ++k) {
        const auto i = static_cast<Index>(k);
        const BoundState wish = known   ? previous[k]
                                : cheap ? BoundState::between
                                        : guess.cases[k];
        const bool possible =
            (wish != BoundState::at_lo || mlcp.lo[i] > -infinity) &&
            (wish != BoundState::at_hi || mlcp.hi[i] < infinity);
        guess.cases[k] = mlcp.lo[i] == mlcp.hi[i] ? BoundState::at_lo
                         : possible               ? wish
                                                  : BoundState::between;
    }
}
//! [begin]

}  // namespace rigid
