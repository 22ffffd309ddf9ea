/// \file descent.hpp
/// The fallback of symmetric problems: never uphill.
///
///     φ(λ) = ½ λᵀ A λ + qᵀ λ,   lo ≤ λ ≤ hi       least exactly at the answer
///
/// A few visits of all rows as in chapter 4 let go of bounds; then straight to the lowest point of the face on
/// which that ended, or as far towards it as the bounds and φ allow (9.7b). Each lowest point of a face is lower
/// than the one before, so none is met twice: this ends. \cite more1991
#pragma once

#include "chapters/09_active_sets/first_guess.hpp"

#include <algorithm>
#include <limits>

namespace rigid {

/// φ(λ), with w = (A + diag(shift)) λ + q at hand.
inline Real merit(const GuessedProblem& problem, const VecX& lambda, const VecX& w)
{
    return 0.5 * lambda.dot(w + problem.q);
}

//! [descend]
/// From guess.lambda down to the answer. Each guess is the lowest point of a face.
/// \param visits  of all rows between two faces
template <class Factor>
GuessEnd descend(const GuessedProblem& problem, Factor& factor, int visits,
                 int limit, Guess& guess, ActiveSetWork& work)
{
    const Mlcp& mlcp = *problem.mlcp;
    VecX &here = guess.here, &trial = guess.trial, &way = guess.way;
    here = guess.lambda;
    clamp_into_bounds(mlcp, here);
    while (work.guesses < limit) {
        for (int k = 0; k < visits; ++k) visit_rows(problem, here);
        velocities(problem, factor, here, guess.w);
        Real now = merit(problem, here, guess.w);
        for (bool arrived = false; !arrived && work.guesses < limit;) {
            cases_of(mlcp, here, guess.cases);
            ++work.guesses;
            ++work.descents;
            if (!factor.factor(problem, guess.cases, work))
                return GuessEnd::singular;
            solve_guess(problem, factor, guess);
            if (!guess.lambda.allFinite()) return GuessEnd::singular;
            if (guess.wrong.empty()) return GuessEnd::right;

            // The part of the way to the lowest point of the face that no bound
            // interrupts: always downhill.
            way = guess.lambda - here;
            Real free_way = 1;
            for (const Index i : guess.wrong)
                if (way[i] < 0)
                    free_way = std::min(free_way, (mlcp.lo[i] - here[i]) / way[i]);
                else if (way[i] > 0)
                    free_way = std::min(free_way, (mlcp.hi[i] - here[i]) / way[i]);
            arrived = free_way >= 1;
            // more than that, pressed into the bounds, if it is lower; a share that
            // only rounding can see is none
            constexpr Real least = std::numeric_limits<Real>::epsilon();
            for (Real share = 1;; share *= 0.5) {
                const bool last = share <= std::max(free_way, least);
                if (last) share = free_way;
                trial = here + share * way;
                clamp_into_bounds(mlcp, trial);
                velocities(problem, factor, trial, guess.w);
                const Real there = merit(problem, trial, guess.w);
                if (!last && !(there < now)) continue;
                now = there;
                break;
            }
            here = trial;
        }
    }
    guess.lambda = here;  // the lowest that it came to
    return GuessEnd::limit;
}
//! [descend]

}  // namespace rigid
