/// \file friction_correct.hpp
/// Guess, solve, correct, until no row is wrong: the loop of Algorithm 13.2, its settings and its memory, and the sweeps
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

void require_valid(const FrictionSettings& settings);

/// Throws std::invalid_argument unless the normal of each box only pushes.
void require_pushing(const Mlcp& mlcp, std::span<const FrictionBox> boxes);

/// The bounds of a row under the present λ, (13.6).
std::pair<Real, Real> present_bounds(const FrictionProblem& problem,
                                     const std::vector<int>& box_of, Index i,
                                     const VecX& lambda);

/// Sweeps over A with the bounds of the present λ: chapter 4's, with (13.6).
void sweep_friction(const FrictionProblem& problem, int sweeps,
                    const std::vector<int>& box_of, VecX& lambda);

/// The same, and w follows each change of a λ, as A is symmetric: a row that changes
/// none costs nothing. Most that are open, or out of reach, stay as they are.
/// \param small  the sweeps end when none changes a row by more than this [m/s]
/// \param guess  its lambda is swept; box_of is that of these rows
/// \return       how many were made
int sweep_changes(const FrictionProblem& problem, int sweeps, Real small,
                  FrictionGuess& guess);

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

/// Guesses from guess.lambda on, until no row is wrong, or patience ends.
bool correct_friction(FrictionMemory& memory, const FrictionSettings& settings);

/// The same on the problem itself, and whether it ends at an answer.
bool guess_friction(FrictionMemory& memory, const FrictionSettings& settings,
                    Solution& solution);

}  // namespace rigid
