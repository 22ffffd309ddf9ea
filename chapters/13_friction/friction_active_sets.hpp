/// \file friction_active_sets.hpp
/// Exact friction: guess which contacts are open, stick or slide, solve once, correct the guess.
///
/// Algorithm 13.2 of the text. Warm: the first guess is what the λ to start from points at, so last step's answer needs
/// no guess at all where nothing has changed. What guessing cannot settle goes to sweeps and comes back, then to chapter 9's
/// rounds, then to Lemke's algorithm on Stewart's and Trinkle's problem; and what is still not an answer is not called one.
#pragma once

#include "chapters/13_friction/friction_correct.hpp"
#include "chapters/13_friction/stewart_trinkle_rows.hpp"

namespace rigid {

/// (13.25): guesses that a large ε holds near the last λ, then with smaller ones.
/// Begins with the best λ so far.
bool proximal_friction(FrictionMemory& memory, const FrictionSettings& settings,
                       Solution& solution);

/// What is left when guesses have failed: rounds, and a walk.
bool last_resorts(FrictionMemory& memory, const FrictionSettings& settings,
                  Solution& solution);

/// What guesses alone cannot settle: sweeps and guesses, proximal steps, last resorts.
/// \param settings  with what is enough from now on
void retreat(FrictionMemory& memory, const FrictionSettings& settings,
             Solution& solution);

//! [solve]
/// Solves the Coulomb problem of these rows, Algorithm 13.2.
/// \param mlcp      A, q, bounds of ordinary rows; those of friction rows become the
///                  answer's
/// \param boxes     which rows others bound
/// \param solution  in: the λ to start from (another length: zero); out: `solved`
///                  by (3.16c) with the bounds of λ itself, else `iteration limit`
///                  and the best λ that was found. iterations counts guesses
/// \throws std::invalid_argument  for a malformed problem, box or setting
inline void friction_active_sets(Mlcp& mlcp, std::span<const FrictionBox> boxes,
                                 const FrictionSettings& settings,
                                 FrictionMemory& memory, Solution& solution)
{
    require_valid(mlcp, boxes);
    for (const FrictionBox& box : boxes) mlcp.lo[box.row] = mlcp.hi[box.row] = 0;
    require_valid(mlcp);
    require_pushing(mlcp, boxes);
    require_valid(settings);
    const Index n = mlcp.size();
    FrictionProblem& problem = memory.problem;
    FrictionGuess& guess = memory.guess;
    memory.work = {};
    problem.mlcp = &mlcp;
    problem.boxes = boxes;
    if (solution.lambda.size() != n || !solution.lambda.allFinite())
        solution.lambda.setZero(n);
    guess.lambda = solution.lambda;
    solution.status = Status::iteration_limit;
    solution.residual = infinity;
    solution.uniqueness = Uniqueness::not_examined;
    solution.iterations = 0;
    const Acceptance acceptance{settings.tolerance, settings.enough};
    // last step's answer may be this step's
    if (accept_coulomb(mlcp, boxes, acceptance, guess.lambda, solution)) return;

    guess.w.resize(n);
    guess.step.resize(n);
    set_up(mlcp, acceptance, problem.scale);
    set_share(problem, 0);
    memory.factor.factorisations = 0;
    memory.factor.changed = guess.looked = 0;
    memory.factor.analyse(mlcp.A, boxes);
    begin_guesses(problem, guess, memory.factor.is_of_these_rows());
    if (!guess_friction(memory, settings, solution)) {
        FrictionSettings later = settings;
        later.enough = std::max(settings.enough, settings.late);
        retreat(memory, later, solution);
    }
    memory.work.entries = entries_of(memory);
    memory.work.factorisations = memory.factor.factorisations;
    solution.iterations = memory.work.guesses;
}
//! [solve]

}  // namespace rigid
