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

#include "chapters/09_active_sets/descent.hpp"

#include <algorithm>

namespace rigid {

inline constexpr Real proximal_share = 1e-8;  ///< ε: the root of what a double can tell apart

struct ProximalMemory {
    VecX previous, candidate, direction, image;
};

//! [proof]
/// (9.15): does a direction prove that there is no answer? Let v grow no bound: v_i ≥ 0 where only hi is
/// missing, v_i ≤ 0 where only lo is, v_i = 0 where neither is. Every answer has 0 ≤ vᵀw = (Aᵀv)ᵀλ + qᵀv.
/// With Aᵀv = 0 and qᵀv < 0 that cannot be. Rounding leaves Aᵀv ≠ 0: then an answer would need a Σ|λ| that we
/// want to be absurd.
/// \param v      A is symmetric; v is cleaned of what the bounds forbid
/// \param image  room for A v
inline bool proves_infeasible(const Mlcp& mlcp, VecX& v, VecX& image)
{
    Real largest_q = 0, largest_A = 0, gain = 0, boxes = 0, largest_image = 0;
    for (Index i = 0; i < mlcp.size(); ++i) {
        if (mlcp.lo[i] > -infinity) v[i] = std::max(v[i], Real{0});
        if (mlcp.hi[i] < infinity) v[i] = std::min(v[i], Real{0});
        gain -= mlcp.q[i] * v[i];
        largest_q = std::max(largest_q, std::abs(mlcp.q[i]));
    }
    if (!(gain > 0)) return false;
    for (Index i = 0; i < mlcp.size(); ++i) {
        image[i] = 0;
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            image[i] += entry.value() * v[entry.col()];
            largest_A = std::max(largest_A, std::abs(entry.value()));
        }
        const Real bound = std::max(std::abs(mlcp.lo[i]), std::abs(mlcp.hi[i]));
        if (bound < infinity) boxes += std::abs(image[i]) * bound;
        else largest_image = std::max(largest_image, std::abs(image[i]));
    }
    return (gain - boxes) * largest_A > 1e13 * largest_image * largest_q;
}
//! [proof]

/// Corrects the guess; if that makes no progress, descends.
template <class Factor>
GuessEnd guess_or_descend(const GuessedProblem& problem, Factor& factor, int patience, int limit,
                          Guess& guess, ActiveSetWork& work)
{
    const GuessEnd end = correct_guess(problem, factor, patience, limit, false, guess, work);
    if (end != GuessEnd::limit) return end;
    return descend(problem, factor, 10, limit, guess, work);
}

enum class ProximalEnd { right, infeasible, singular, limit };

//! [outer]
/// Outer steps until the residual of the original problem is small and falls no more; guess.lambda, pressed
/// into its bounds, is the answer. Where rows depend on each other flipping all at once goes round more
/// often, so the patience with it is a quarter.
/// \param memory   memory.previous: λ⁰, zero unless it has the size of the problem
/// \param allowed  the natural residual at which an answer is good enough [m/s]
template <class Factor>
ProximalEnd proximal_steps(GuessedProblem& problem, Factor& factor, int patience, int limit, Real allowed,
                           ProximalMemory& memory, Guess& guess, ActiveSetWork& work)
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
        const GuessEnd inner = guess_or_descend(problem, factor, patience / 4, limit, guess, work);
        if (inner != GuessEnd::right)
            return inner == GuessEnd::limit ? ProximalEnd::limit : ProximalEnd::singular;
        clamp_into_bounds(mlcp, guess.lambda);
        const Real residual = natural_residual(mlcp, guess.lambda);
        if (!(residual < 0.5 * last)) {  // it falls no more: which of the two was better?
            if (residual > last) guess.lambda = memory.candidate;
            if (std::min(residual, last) <= allowed) return ProximalEnd::right;
            memory.direction = guess.lambda - memory.previous;
            memory.image.resize(mlcp.size());
            if (proves_infeasible(mlcp, memory.direction, memory.image)) return ProximalEnd::infeasible;
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
        if (residual <= 1e-4 * allowed) break;
    }
    return end;
}
//! [outer]

}  // namespace rigid
