/// \file friction_correct.hpp
/// Guess, solve, correct, until no row is wrong: the loop of Algorithm 13.1, its settings and its memory, and the sweeps
/// that lend it another beginning.
#pragma once

#include "chapters/13_friction/friction_cases.hpp"

namespace rigid {

struct FrictionSettings {
    Real tolerance = 1e-11;  ///< τ of (3.16c)
    Real enough = 0;         ///< f of (3.16c) [m/s]
    /// the same once guesses have failed, where that is more [m/s]
    Real late = 0;
    /// entries of A and its factors that a solve may look at; 0 = any number
    std::int64_t most_entries = 0;
    /// and for each pair of its rows; 0 = any number
    std::int64_t pair_entries = 0;
    /// guesses without fewer wrong rows, before another beginning is asked for
    int patience = 5;
    int retreats = 2;          ///< such beginnings: sweeps and proximal steps
    int proximal_steps = 300;  ///< of each of these
    /// so many of them without a better residual are the last; 0 = any number
    int idle_steps = 0;
    /// the last resorts are for problems of up to so many rows; 0 = none
    Index most_rows_of_rounds = 400, most_rows_of_walks = 240;
};

struct FrictionWork {
    int guesses = 0, factorisations = 0, flips = 0;
    int sweeps = 0;  ///< over all rows, of all retreats
    int proximal_steps = 0;
    int rounds = 0;            ///< times that the rounds of chapter 9 were asked
    int walks = 0;             ///< times that Lemke's algorithm was asked
    std::int64_t entries = 0;  ///< looked at; of walks and rounds, as estimated
};

/// Memory that is kept from solve to solve.
struct FrictionMemory {
    FrictionWork work;  ///< of the last solve
    FrictionProblem problem;
    FrictionGuess guess;
    FrictionLu factor;
    VecX candidate, proximal_base;
    ActiveSetMemory rounds;

    /// What was found is nothing to the next solve: only room is kept, and not that
    /// of the rounds, which are rare.
    void forget()
    {
        guess.cases.clear();
        factor.forget();
        if (!rounds.cases.empty()) rounds = {};
    }
};

inline void require_valid(const FrictionSettings& settings)
{
    if (!(settings.tolerance > 0) || !(settings.enough >= 0) ||
        !std::isfinite(settings.enough) || !(settings.late >= 0) ||
        !std::isfinite(settings.late) || settings.most_entries < 0 ||
        settings.pair_entries < 0 || settings.patience < 0 ||
        settings.retreats < 0 || settings.proximal_steps < 0 ||
        settings.idle_steps < 0)
        throw std::invalid_argument(
            "tolerance " + shortest(settings.tolerance) + ", enough " +
            shortest(settings.enough) + ", late " + shortest(settings.late) +
            ", entries " + std::to_string(settings.most_entries) +
            ", of a pair of rows " + std::to_string(settings.pair_entries) +
            ", patience " + std::to_string(settings.patience) + ", retreats " +
            std::to_string(settings.retreats) + ", proximal steps " +
            std::to_string(settings.proximal_steps) + ", idle ones " +
            std::to_string(settings.idle_steps) +
            ": the tolerance must be positive, the others not negative");
}

/// Throws std::invalid_argument unless the normal of each box only pushes.
inline void require_pushing(const Mlcp& mlcp, std::span<const FrictionBox> boxes)
{
    for (const FrictionBox& box : boxes)
        if (!(mlcp.lo[box.normal] >= 0))
            throw std::invalid_argument(
                "row " + std::to_string(box.normal) + ", which bounds row " +
                std::to_string(box.row) +
                ", has lo = " + shortest(mlcp.lo[box.normal]) +
                "; a row that bounds friction only pushes (lo at least 0)");
}

/// The bounds of a row under the present λ, (13.6).
inline std::pair<Real, Real> present_bounds(const FrictionProblem& problem,
                                            const std::vector<int>& box_of, Index i,
                                            const VecX& lambda)
{
    const int k = box_of[static_cast<std::size_t>(i)];
    if (k < 0) return {problem.mlcp->lo[i], problem.mlcp->hi[i]};
    const FrictionBox& box = problem.boxes[static_cast<std::size_t>(k)];
    const Real most = box.mu * std::max(Real{0}, lambda[box.normal]);
    return {-most, most};
}

//! [sweep]
/// Sweeps over A with the bounds of the present λ: chapter 4's, with (13.6).
inline void sweep_friction(const FrictionProblem& problem, int sweeps,
                           const std::vector<int>& box_of, VecX& lambda)
{
    const Mlcp& mlcp = *problem.mlcp;
    for (; sweeps > 0; --sweeps)
        for (Index i = 0; i < mlcp.size(); ++i) {
            Real w = mlcp.q[i], a = 0;
            for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
                w += entry.value() * lambda[entry.col()];
                if (entry.col() == i) a = entry.value();
            }
            const auto [lo, hi] = present_bounds(problem, box_of, i, lambda);
            if (a > 0) lambda[i] = std::clamp(lambda[i] - w / a, lo, hi);
        }
}
//! [sweep]

//! [sweep_changes]
/// The same, and w follows each change of a λ, as A is symmetric: a row that changes
/// none costs nothing. Most that are open, or out of reach, stay as they are.
/// \param small  the sweeps end when none changes a row by more than this [m/s]
/// \param guess  its lambda is swept; box_of is that of these rows
/// \return       how many were made
inline int sweep_changes(const FrictionProblem& problem, int sweeps, Real small,
                         FrictionGuess& guess)
{
    const Mlcp& mlcp = *problem.mlcp;
    guess.step = mlcp.A.diagonal();
    guess.w.resize(mlcp.size());
    velocities(problem, guess);
    int made = 0;
    for (bool changed = true; made < sweeps && changed; ++made) {
        changed = false;
        for (Index i = 0; i < mlcp.size(); ++i) {
            const Real a = guess.step[i];
            if (!(a > 0)) continue;
            const auto [lo, hi] =
                present_bounds(problem, guess.box_of, i, guess.lambda);
            const Real here = guess.lambda[i],
                       next = std::clamp(here - guess.w[i] / a, lo, hi);
            if (next == here) continue;
            changed = changed || std::abs(next - here) * a > small;
            guess.lambda[i] = next;
            for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
                guess.w[entry.col()] += entry.value() * (next - here);
        }
    }
    return made;
}
//! [sweep_changes]

//! [spent]
/// Entries of A and its factors that a solve has looked at.
inline std::int64_t entries_of(const FrictionMemory& memory)
{
    const Mlcp& mlcp = *memory.problem.mlcp;
    return memory.work.entries + memory.factor.changed +
           memory.guess.looked * mlcp.A.nonZeros();
}
/// The most that a solve of n rows may look at.
inline std::int64_t price_of(const FrictionSettings& settings, Index n)
{
    const auto any = std::numeric_limits<std::int64_t>::max();
    return std::min(settings.most_entries > 0 ? settings.most_entries : any,
                    settings.pair_entries > 0 ? settings.pair_entries * n * n
                                              : any);
}
/// Whether, with so many more, it costs more than it may.
inline bool is_spent(const FrictionMemory& memory, const FrictionSettings& settings,
                     std::int64_t more = 0)
{
    return entries_of(memory) >
           price_of(settings, memory.problem.mlcp->size()) - more;
}
//! [spent]

//! [guesses]
/// Guesses from guess.lambda on, until no row is wrong, or patience ends.
inline bool correct_friction(FrictionMemory& memory,
                             const FrictionSettings& settings)
{
    FrictionProblem& problem = memory.problem;
    FrictionGuess& guess = memory.guess;
    guess.base = guess.lambda;
    velocities(problem, guess);
    first_cases(problem, guess);
    std::size_t fewest = guess.cases.size() + 1;
    for (int chances = settings.patience; chances >= 0;) {
        if (is_spent(memory, settings)) return false;
        ++memory.work.guesses;
        // a guess that was wrong leaves nothing behind but its cases
        guess.lambda = guess.base;
        arrange(problem, guess);
        memory.factor.factor(guess.active, guess.tie, problem.scale.shift);
        const Real left = solve_guess(problem, memory.factor, guess);
        if (!guess.lambda.allFinite()) return false;
        find_wrong(problem, left, guess);
        if (guess.wrong.empty()) return true;
        if (guess.wrong.size() < fewest) {
            fewest = guess.wrong.size();
            chances = settings.patience;
        } else --chances;
        memory.work.flips += static_cast<int>(guess.wrong.size());
        flip(problem, guess);
    }
    return false;
}

/// The same on the problem itself, and whether it ends at an answer.
inline bool guess_friction(FrictionMemory& memory, const FrictionSettings& settings,
                           Solution& solution)
{
    if (!correct_friction(memory, settings)) return false;
    memory.candidate = memory.guess.lambda;
    return accept_coulomb(*memory.problem.mlcp, memory.problem.boxes,
                          {settings.tolerance, settings.enough}, memory.candidate,
                          solution);
}
//! [guesses]

}  // namespace rigid
