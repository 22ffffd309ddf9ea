/// \file block_principal_pivoting.hpp
/// Guess which rows are active, solve for them, and correct the guess.
///
///     A_FF λ_F = −(q_F + A_FB λ_B)     F the active rows, between their bounds; B the others, at a bound
///
/// (9.2). All wrong rows change their case at once (9.5); if that makes no progress for a while, one row at a
/// time, the first that is wrong (9.6), which ends for every P-matrix. \cite murty1997; \cite judice1994
#pragma once

#include "chapters/03_mlcp_formulation/cases.hpp"
#include "chapters/03_mlcp_formulation/verification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace rigid {

/// What a solve cost.
struct ActiveSetWork {
    int factorisations = 0;  ///< of the active rows, from the beginning
    /// solves by an older factorisation and a border of the rows that changed
    int updates = 0;
    int guesses = 0;       ///< sets that were tried
    int flips = 0;         ///< rows that changed their case
    int single_flips = 0;  ///< of these, one at a time
    /// guesses that were lowest points of faces (descent.hpp)
    int descents = 0;
    int outer_steps = 0;  ///< proximal steps; 0 = A needed none
    int walks = 0;        ///< times that Lemke's algorithm had to be called
    Index entries = 0;    ///< entries of the last factor
};

/// The problem as the guesses see it: A + diag(shift), and a q of its own.
struct GuessedProblem {
    const Mlcp* mlcp = nullptr;
    VecX q;                ///< that of the problem, or of a proximal step (9.12)
    VecX shift;            ///< ε A_ii of the proximal step, or zero
    bool shifted = false;  ///< whether shift is used
    VecX diagonal;         ///< A_ii; 1 where it is not positive
    /// √A_ii: rows of heavy and of light bodies are compared by w_i / √A_ii
    VecX unit;
    /// a row whose w is wrong by less than this in its unit is right,
    Real tolerance = 0;
    Real ceiling = 0;       ///< if that is not more than this [m/s],
    Real enough = 0;        ///< and so is one that is wrong by less than this [m/s]
    Acceptance acceptance;  ///< what the answer will be held to (3.16c)
};

/// The problem itself, without a term.
void set_up(const Mlcp& mlcp, const Acceptance& acceptance,
            GuessedProblem& problem);

/// Which rows are active, the λ that follows, and its w.
struct Guess {
    std::vector<BoundState> cases;
    VecX lambda, w, step;
    VecX here, trial, way;     ///< room for the descent
    VecX start;                ///< where the last guesses began
    std::vector<Index> wrong;  ///< rows whose case does not fit what came out
};

enum class GuessEnd { right, singular, limit };

//! [correct]
/// (9.4): the case that a row should have, by what its own case led to.
inline BoundState corrected(const GuessedProblem& problem, Index i, BoundState now,
                            Real lambda, Real w, Real tolerance)
{
    const Mlcp& mlcp = *problem.mlcp;
    const Real allowed = tolerance / problem.diagonal[i];
    switch (now) {
    case BoundState::between:
        if (lambda < mlcp.lo[i] - allowed) return BoundState::at_lo;
        if (lambda > mlcp.hi[i] + allowed) return BoundState::at_hi;
        return now;
    case BoundState::at_lo:
        return w < -tolerance && mlcp.lo[i] < mlcp.hi[i] ? BoundState::between
                                                         : now;
    case BoundState::at_hi:
        return w > tolerance && mlcp.lo[i] < mlcp.hi[i] ? BoundState::between : now;
    }
    return now;
}
//! [correct]

/// w = (A + diag(shift)) λ + q.
template <class Factor>
void velocities(const GuessedProblem& problem, const Factor& factor,
                const VecX& lambda, VecX& w)
{
    factor.multiply(*problem.mlcp, lambda, w);
    w += problem.q;
    if (problem.shifted) w += problem.shift.cwiseProduct(lambda);
}

/// The largest w of the active rows in their units, which should be zero.
Real active_residual(const GuessedProblem& problem, const Guess& guess);

/// One correction of the active λ by what is left of their w: A_FF Δ = −w_F.
template <class Factor>
void improve(const GuessedProblem& problem, const Factor& factor, Guess& guess)
{
    for (Index i = 0; i < guess.w.size(); ++i)
        guess.step[i] =
            guess.cases[static_cast<std::size_t>(i)] == BoundState::between
                ? -guess.w[i]
                : 0;
    factor.solve(guess.step);
    guess.lambda += guess.step;
    velocities(problem, factor, guess.lambda, guess.w);
}

/// The rows that are wrong, into guess.wrong. What rounding alone can do to a w does not count.
/// \param hidden  what is left of the active rows' w, in their units: a row that is wrong by less may yet be right
void find_wrong(const GuessedProblem& problem, Real hidden, Guess& guess);

//! [solve]
/// (9.2): λ and w of the guess, and which rows they show to be wrong. The factor
/// must be that of guess.cases.
template <class Factor>
void solve_guess(const GuessedProblem& problem, const Factor& factor, Guess& guess)
{
    const Mlcp& mlcp = *problem.mlcp;
    bool zero = true;
    for (Index i = 0; i < mlcp.size(); ++i) {
        const BoundState here = guess.cases[static_cast<std::size_t>(i)];
        guess.lambda[i] = here == BoundState::at_lo   ? mlcp.lo[i]
                          : here == BoundState::at_hi ? mlcp.hi[i]
                                                      : 0;
        zero = zero && guess.lambda[i] == 0;
    }
    if (zero) guess.w = problem.q;
    else velocities(problem, factor, guess.lambda, guess.w);
    improve(problem, factor, guess);
    Real left = active_residual(problem, guess);
    if (left > 1e4 * problem.tolerance) {
        improve(problem, factor, guess);
        left = active_residual(problem, guess);
    }
    find_wrong(problem, left, guess);
    // nothing large is wrong: look closer
    if (guess.wrong.empty() && left > 0.01 * problem.tolerance) {
        improve(problem, factor, guess);
        find_wrong(problem, 0, guess);
    }
}
//! [solve]

//! [loop]
/// Corrects the guess until nothing is wrong. `singular`: the active rows of some
/// guess depend on each other.
/// \param patience  flips of all wrong rows without fewer of them, before one row
///                  at a time
/// \param limit     of work.guesses
/// \param singly    whether that comes then, (9.6); if not, this ends in `limit`
template <class Factor>
GuessEnd correct_guess(const GuessedProblem& problem, Factor& factor, int patience,
                       int limit, bool singly, Guess& guess, ActiveSetWork& work)
{
    std::size_t fewest = guess.cases.size() + 1;
    int chances = patience;
    while (work.guesses < limit) {
        ++work.guesses;
        if (!factor.factor(problem, guess.cases, work)) return GuessEnd::singular;
        solve_guess(problem, factor, guess);
        if (!guess.lambda.allFinite()) return GuessEnd::singular;
        if (guess.wrong.empty()) return GuessEnd::right;

        bool all = true;
        if (guess.wrong.size() < fewest) {
            fewest = guess.wrong.size();
            chances = patience;
        } else if (chances > 0) --chances;
        else if (singly) all = false;
        else break;
        const std::size_t count = all ? guess.wrong.size() : 1;
        // (9.5), or the first alone (9.6)
        for (std::size_t k = 0; k < count; ++k) {
            const Index i = guess.wrong[k];
            BoundState& here = guess.cases[static_cast<std::size_t>(i)];
            here = corrected(
                problem, i, here, guess.lambda[i], guess.w[i],
                std::min(problem.tolerance * problem.unit[i], problem.ceiling));
        }
        work.flips += static_cast<int>(count);
        if (!all) ++work.single_flips;
    }
    return GuessEnd::limit;
}
//! [loop]

}  // namespace rigid
