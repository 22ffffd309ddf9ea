/// \file active_sets.hpp
/// Exact answers by guessing which rows are active, and correcting the guess.
///
///     w = A λ + q,   lo ≤ λ ≤ hi,   λ_i = lo_i or λ_i = hi_i or w_i = 0
///
/// Guesses (guess.hpp) with a sparse or a dense factor of the active rows; a proximal term where they depend
/// on each other (proximal.hpp); and only called solved after the residual was computed. What guessing cannot
/// settle is walked by Lemke's algorithm. \cite judice1994
#pragma once

#include "chapters/09_active_sets/accept.hpp"
#include "chapters/09_active_sets/dense_llt.hpp"
#include "chapters/09_active_sets/general_lu.hpp"
#include "chapters/09_active_sets/proximal.hpp"
#include "chapters/09_active_sets/sparse_ldlt.hpp"

#include <vector>

namespace rigid {

inline constexpr Index most_walked_rows = 2000;  ///< larger problems are not handed to Lemke's algorithm

/// Memory that is kept from solve to solve, yesterday's guess, and what the last solve cost.
struct ActiveSetMemory {
    std::vector<RowCase> cases;  ///< of the last answer: which rows are at a bound, and at which
    ActiveSetWork work;          ///< of the last solve
    bool sparse = false;         ///< which of the two factors was used
    bool dependent = false;      ///< active rows depended on each other: begin with the proximal term

    SparseLdlt sparse_factor;
    DenseLlt dense_factor;
    GuessedProblem problem;
    Guess guess;
    ProximalMemory proximal;
    std::vector<int> cursor;
};

inline int guess_limit(const Mlcp& mlcp, const ActiveSetSettings& settings)
{
    return settings.limit > 0 ? settings.limit : 500 + static_cast<int>(mlcp.size());
}

//! [guesses]
/// Guesses with the plain A, then, if rows depend on each other, with the proximal term. True if that settled
/// it: solved, or infeasible with a proof.
template <class Factor>
bool settle(const Mlcp& mlcp, const ActiveSetSettings& settings, Real allowed, Factor& factor,
            ActiveSetMemory& memory, Solution& solution)
{
    GuessedProblem& problem = memory.problem;
    ActiveSetWork& work = memory.work;
    const int limit = guess_limit(mlcp, settings);
    if (!memory.dependent) {
        const GuessEnd end = guess_or_descend(problem, factor, settings.patience, limit, memory.guess, work);
        if (end == GuessEnd::right && judge(mlcp, allowed, memory.guess.lambda, solution)) return true;
        if (end == GuessEnd::limit) {
            judge(mlcp, allowed, memory.guess.lambda, solution);
            solution.status = Status::iteration_limit;
            return false;
        }
    }
    memory.dependent = true;
    if (memory.cases.size() != memory.guess.cases.size()) memory.proximal.previous.resize(0);  // cold
    const ProximalEnd end = proximal_steps(problem, factor, settings.patience, limit, allowed,
                                           memory.proximal, memory.guess, work);
    if (judge(mlcp, allowed, memory.guess.lambda, solution) && end == ProximalEnd::right) return true;
    solution.status = end == ProximalEnd::infeasible ? Status::infeasible
                      : end == ProximalEnd::limit    ? Status::iteration_limit
                                                     : Status::singular;
    return end == ProximalEnd::infeasible;
}
//! [guesses]

/// Asks Lemke's algorithm (chapter 5), and takes over its answer if it has one.
inline void walk(const Mlcp& mlcp, const ActiveSetSettings& settings, ActiveSetMemory& memory,
                 Solution& solution)
{
    LemkeSettings lemke_settings;
    lemke_settings.tolerance = settings.tolerance;
    ++memory.work.walks;
    const Solution walked = lemke(mlcp, lemke_settings);
    if (walked.status != Status::solved && walked.status != Status::infeasible &&
        solution.residual <= walked.residual)
        return;  // the last guess is as good, and its status says what is wrong
    solution = walked;
    for (Index i = 0; i < mlcp.size(); ++i)
        memory.guess.cases[static_cast<std::size_t>(i)] = walked.lambda[i] <= mlcp.lo[i]   ? RowCase::at_lo
                                                          : walked.lambda[i] >= mlcp.hi[i] ? RowCase::at_hi
                                                                                           : RowCase::between;
}

//! [active_sets]
/// Solves an MLCP. `iterations` counts guesses. Begins with the cases in memory if there are as many as rows.
///
/// `solved`: as in chapter 5, the natural residual is at most tolerance·max|q| and rounding can't hide ten
/// times as much. `infeasible`: with a proof (9.15), or one by Lemke's ray. Else what went wrong, and lambda
/// is the last guess.
/// \throws std::invalid_argument  for a malformed problem or settings that make no sense
inline void active_sets(const Mlcp& mlcp, const ActiveSetSettings& settings, ActiveSetMemory& memory,
                        Solution& solution)
{
    require_valid(mlcp);
    require_valid(settings);
    const Index n = mlcp.size();
    memory.work = {};
    solution.uniqueness = Uniqueness::not_examined;
    const Real allowed = allowed_residual(mlcp, settings.tolerance, memory.guess.step);
    GuessedProblem& problem = memory.problem;
    problem.mlcp = &mlcp;
    problem.tolerance = 0.01 * allowed;
    problem.diagonal.resize(n);
    for (Index i = 0; i < n; ++i) {
        const Real a = mlcp.A.coeff(i, i);
        problem.diagonal[i] = a > 0 ? a : 1;
    }
    Guess& guess = memory.guess;
    guess.lambda.resize(n);
    guess.w.resize(n);
    guess.step.resize(n);
    problem.shifted = false;
    problem.q = mlcp.q;

    bool settled = false;
    if (!is_symmetric(mlcp.A, memory.cursor)) {
        GeneralLu factor;
        factor.look(mlcp);
        begin(problem, memory.cases, false, guess);
        const GuessEnd end = correct_guess(problem, factor, settings.patience, guess_limit(mlcp, settings),
                                           true, guess, memory.work);
        settled = judge(mlcp, allowed, guess.lambda, solution) && end == GuessEnd::right;
        if (end == GuessEnd::limit) solution.status = Status::iteration_limit;
    } else {
        memory.sparse = n > 32 && 4 * mlcp.A.nonZeros() < n * n;
        if (memory.sparse) {
            memory.sparse_factor.look(mlcp);
            memory.sparse = 6 * memory.sparse_factor.elimination.entries() < n * n;
        }
        begin(problem, memory.cases, memory.sparse || n <= 32, guess);
        if (memory.sparse) settled = settle(mlcp, settings, allowed, memory.sparse_factor, memory, solution);
        else {
            memory.dense_factor.look(mlcp);
            settled = settle(mlcp, settings, allowed, memory.dense_factor, memory, solution);
        }
    }
    if (!settled && settings.limit == 0 && n <= most_walked_rows) walk(mlcp, settings, memory, solution);
    solution.iterations = memory.work.guesses;
    memory.cases = guess.cases;
}
//! [active_sets]

/// Cold: from a guess that knows nothing.
inline Solution active_sets(const Mlcp& mlcp, const ActiveSetSettings& settings = {})
{
    ActiveSetMemory memory;
    Solution solution;
    active_sets(mlcp, settings, memory, solution);
    return solution;
}

}  // namespace rigid
