/// \file proximal.hpp
/// When A is only semi-definite: a small term that makes every guess solvable, and outer steps that take it
/// back.
///
///     λᵏ⁺¹ solves   w = (A + ε D) λ + q − ε D λᵏ,     D = diag A
///
/// (9.12). What the term leaves behind is ε D (λᵏ⁺¹ − λᵏ), (9.13), so when λ stands still the term is gone. If
/// λ runs away instead, the direction it runs in can prove that there is no answer (9.15).
/// \cite rockafellar1976
#pragma once

#include "chapters/05_lemke/infeasibility.hpp"
#include "chapters/09_active_sets/descent.hpp"

#include <algorithm>

namespace rigid {

/// ε: the root of what a double can distinguish
inline constexpr Real proximal_share = 1e-8;

struct ProximalMemory {
    VecX previous, candidate;
};

//! [or_descend]
/// Corrects the guess; if that makes no progress, descends, from where the guesses
/// began or from where they led, whichever is lower.
template <class Factor>
GuessEnd guess_or_descend(const GuessedProblem& problem, Factor& factor,
                          int patience, int limit, Guess& guess,
                          ActiveSetWork& work)
{
    guess.start = guess.lambda;
    const GuessEnd end =
        correct_guess(problem, factor, patience, limit, false, guess, work);
    if (end != GuessEnd::limit || work.guesses >= limit) return end;
    const auto height = [&](VecX& lambda) {
        clamp_into_bounds(*problem.mlcp, lambda);
        velocities(problem, factor, lambda, guess.w);
        return merit(problem, lambda, guess.w);
    };
    const Real began = height(guess.start);
    // a guess that is no number is no lower
    if (!(height(guess.lambda) <= began)) guess.lambda = guess.start;
    return descend(problem, factor, 10, limit, guess, work);
}
//! [or_descend]

enum class ProximalEnd { right, infeasible, singular, limit };

//! [outer]
/// Outer steps until the residual of the original problem is small and falls no
/// more; guess.lambda, pressed into its bounds, is the answer. Where rows depend on
/// each other flipping all at once cycles more often, so the patience with it is a
/// quarter.
/// \param memory   memory.previous: λ⁰, zero unless it has the size of the problem
/// \param allowed  the natural residual that is wanted [m/s]; whether it is an
///                 answer is for verify() to say
template <class Factor>
ProximalEnd proximal_steps(GuessedProblem& problem, Factor& factor, int patience,
                           int limit, Real allowed, ProximalMemory& memory,
                           Guess& guess, ActiveSetWork& work)
{
    const Mlcp& mlcp = *problem.mlcp;
    Real share = proximal_share;
    problem.shift = share * problem.diagonal;
    problem.shifted = true;
    factor.forget();
    if (memory.previous.size() != mlcp.size()) memory.previous.setZero(mlcp.size());
    clamp_into_bounds(mlcp, memory.previous);
    Real last = infinity;
    ProximalEnd end = ProximalEnd::limit;
    memory.candidate = memory.previous;
    for (int outer = 0; outer < 50; ++outer) {
        ++work.outer_steps;
        problem.q = mlcp.q - problem.shift.cwiseProduct(memory.previous);  // (9.12)
        const GuessEnd inner =
            guess_or_descend(problem, factor, patience / 4, limit, guess, work);
        if (inner != GuessEnd::right)
            return inner == GuessEnd::limit ? ProximalEnd::limit
                                            : ProximalEnd::singular;
        clamp_into_bounds(mlcp, guess.lambda);
        const Real residual = natural_residual(mlcp, guess.lambda);
        // it falls no more: which of the two was better?
        if (!(residual < 0.5 * last)) {
            if (residual > last) guess.lambda = memory.candidate;
            if (verify(mlcp, guess.lambda, problem.acceptance).solved)
                return ProximalEnd::right;
            if (proves_infeasibility(mlcp, guess.lambda - memory.previous))
                return ProximalEnd::infeasible;
        }
        if (residual > allowed && !(residual <= 0.01 * last) &&
            share > 1e-11) {  // too slow: a smaller term is gone sooner
            share *= 0.01;
            problem.shift = share * problem.diagonal;
            factor.forget();
        }
        last = residual;
        memory.candidate = memory.previous = guess.lambda;
        end = residual <= allowed ? ProximalEnd::right : ProximalEnd::limit;
        if (residual <= 1e-4 * allowed &&
            verify(mlcp, guess.lambda, problem.acceptance).solved)
            break;
    }
    return end;
}
//! [outer]

}  // namespace rigid
