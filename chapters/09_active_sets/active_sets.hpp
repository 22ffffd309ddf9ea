/// \file active_sets.hpp
/// Exact answers by guessing which rows are active, and correcting the guess.
///
///     w = A λ + q,   lo ≤ λ ≤ hi,   λ_i = lo_i or λ_i = hi_i or w_i = 0
///
/// Guesses (block_principal_pivoting.hpp) with a sparse or a dense factor of the active rows; a proximal term where they depend
/// on each other (proximal.hpp); and only called solved after the residual was computed. What guessing cannot
/// settle is walked by Lemke's algorithm. \cite judice1994
#pragma once

#include "chapters/05_lemke/lemke.hpp"
#include "chapters/09_active_sets/dense_llt.hpp"
#include "chapters/09_active_sets/general_lu.hpp"
#include "chapters/09_active_sets/proximal.hpp"
#include "chapters/09_active_sets/sparse_ldlt.hpp"
#include "chapters/09_active_sets/verify.hpp"

#include <vector>

namespace rigid {

/// larger problems are not handed to Lemke's algorithm
inline constexpr Index most_walked_rows = 2000;

/// Memory that is kept from solve to solve, the previous guess, and what the last solve cost.
struct ActiveSetMemory {
    /// of the last answer: which rows are at a bound, and at which
    std::vector<BoundState> cases;
    ActiveSetWork work;   ///< of the last solve
    bool sparse = false;  ///< which of the two factors was used
    /// the active rows of the last answer depend on each other: begin with the term
    bool dependent = false;

    SparseLdlt sparse_factor;
    DenseLlt dense_factor;
    GuessedProblem problem;
    Guess guess;
    ProximalMemory proximal;
    std::vector<int> cursor;

    // Many solvers keep one: what it takes to copy it is compiled once, in active_sets.cpp.
    ActiveSetMemory();
    ActiveSetMemory(const ActiveSetMemory&);
    ActiveSetMemory(ActiveSetMemory&&) noexcept;
    ActiveSetMemory& operator=(const ActiveSetMemory&);
    ActiveSetMemory& operator=(ActiveSetMemory&&) noexcept;
    ~ActiveSetMemory();
};

inline int guess_limit(const Mlcp& mlcp, const ActiveSetSettings& settings)
{
    return settings.limit > 0 ? settings.limit
                              : 500 + static_cast<int>(mlcp.size());
}

//! [guesses]
/// Guesses with the plain A, then, if rows depend on each other, with the proximal
/// term. True if that settled it: solved, or infeasible with a proof.
template <class Factor>
bool settle(const Mlcp& mlcp, const ActiveSetSettings& settings, Factor& factor,
            ActiveSetMemory& memory, Solution& solution)
{
    GuessedProblem& problem = memory.problem;
    ActiveSetWork& work = memory.work;
    const int limit = guess_limit(mlcp, settings);
    if (!memory.dependent) {
        GuessEnd end = guess_or_descend(problem, factor, settings.patience, limit,
                                        memory.guess, work);
        bool verified = verify_guess(mlcp, settings, memory.guess.lambda, solution);
        // right to the tolerance, but not to the numbers of each row
        if (end == GuessEnd::right && !verified) {
            problem.tolerance = 0;
            end = guess_or_descend(problem, factor, settings.patience, limit,
                                   memory.guess, work);
            verified = verify_guess(mlcp, settings, memory.guess.lambda, solution);
        }
        if (verified) return true;
        if (end == GuessEnd::limit) {
            solution.status = Status::iteration_limit;
            return false;
        }
    }
    // cold
    if (memory.cases.size() != memory.guess.cases.size())
        memory.proximal.previous.resize(0);
    const ProximalEnd end = proximal_steps(problem, factor, settings.patience,
                                           limit, wanted_residual(mlcp, settings),
                                           memory.proximal, memory.guess, work);
    // else the next solve needs no term
    memory.dependent = !factor.is_independent(problem);
    if (verify_guess(mlcp, settings, memory.guess.lambda, solution)) return true;
    solution.status = end == ProximalEnd::infeasible ? Status::infeasible
                      : end == ProximalEnd::limit    ? Status::iteration_limit
                                                     : Status::singular;
    return end == ProximalEnd::infeasible;
}
//! [guesses]

// Compiled once, in active_sets.cpp.
extern template bool settle(const Mlcp&, const ActiveSetSettings&, DenseLlt&,
                            ActiveSetMemory&, Solution&);
extern template bool settle(const Mlcp&, const ActiveSetSettings&, SparseLdlt&,
                            ActiveSetMemory&, Solution&);
extern template GuessEnd correct_guess(const GuessedProblem&, GeneralLu&, int, int,
                                       bool, Guess&, ActiveSetWork&);

/// Asks Lemke's algorithm (chapter 5), and takes over its answer if it has one.
void walk(const Mlcp& mlcp, const ActiveSetSettings& settings,
          ActiveSetMemory& memory, Solution& solution);

/// What is no answer shall at least do no harm: of the last guess, where it began,
/// and the point of the bounds nearest to zero the one with the lowest φ (9.7). So an
/// impulse that comes out without an answer leaves no more energy than none at all.
void keep_lowest(const Mlcp& mlcp, const ActiveSetSettings& settings,
                 ActiveSetMemory& memory, Solution& solution);

//! [active_sets]
/// Solves an MLCP. `iterations` counts guesses. Begins with the cases in memory if
/// there are as many as rows.
///
/// `solved`: by the one rule of the book (3.16c). `infeasible`: with a proof
/// (9.15), or one by Lemke's ray. Else what went wrong, and lambda is no answer, but
/// within its bounds, and no higher than zero is where A is symmetric. Where no |q| is above settings.enough and λ = 0
/// will do, nothing is guessed and the memory stays as it is.
/// \throws std::invalid_argument  for a malformed problem or settings that make no
///     sense
inline void active_sets(const Mlcp& mlcp, const ActiveSetSettings& settings,
                        ActiveSetMemory& memory, Solution& solution)
{
    require_valid(mlcp);
    require_valid(settings);
    if (!mlcp.A.isCompressed()) {  // what follows reads the arrays of A
        Mlcp compressed = mlcp;
        compressed.A.makeCompressed();
        active_sets(compressed, settings, memory, solution);
        memory.problem.mlcp = &mlcp;
        return;
    }
    const Index n = mlcp.size();
    memory.work = {};
    solution.uniqueness = Uniqueness::not_examined;
    // nothing drives the rows: does λ = 0 do?
    if (n > 0 && mlcp.q.lpNorm<Eigen::Infinity>() <= settings.enough) {
        memory.guess.lambda.setZero(n);
        solution.iterations = 0;
        if (verify_guess(mlcp, settings, memory.guess.lambda, solution)) return;
    }
    const auto known = static_cast<Index>(memory.cases.size());
    // that was another problem
    if (known > 0 && known != n) memory.dependent = false;
    GuessedProblem& problem = memory.problem;
    Guess& guess = memory.guess;
    set_up(mlcp, {settings.tolerance, settings.enough}, problem);

    bool settled = false;
    const bool symmetric = is_symmetric(mlcp.A, memory.cursor);
    if (!symmetric) {
        GeneralLu factor;
        factor.load(mlcp);
        begin(problem, memory.cases, false, guess);
        const GuessEnd end =
            correct_guess(problem, factor, settings.patience,
                          guess_limit(mlcp, settings), true, guess, memory.work);
        settled = verify_guess(mlcp, settings, guess.lambda, solution);
        if (!settled && end == GuessEnd::limit)
            solution.status = Status::iteration_limit;
    } else {
        memory.sparse = n > 32 && 4 * mlcp.A.nonZeros() < n * n;
        if (memory.sparse) {
            memory.sparse_factor.analyse_pattern(mlcp);
            memory.sparse = 6 * memory.sparse_factor.elimination.entries() < n * n;
        }
        begin(problem, memory.cases, memory.sparse || n <= 32, guess);
        if (memory.sparse)
            settled =
                settle(mlcp, settings, memory.sparse_factor, memory, solution);
        else {
            memory.dense_factor.load(mlcp);
            settled = settle(mlcp, settings, memory.dense_factor, memory, solution);
        }
    }
    if (!settled && settings.limit == 0 && n <= most_walked_rows)
        walk(mlcp, settings, memory, solution);
    if (symmetric && (solution.status == Status::iteration_limit ||
                      solution.status == Status::singular))
        keep_lowest(mlcp, settings, memory, solution);
    solution.iterations = memory.work.guesses;
    memory.cases = guess.cases;
}
//! [active_sets]

/// Cold: from a guess without a memory.
inline Solution active_sets(const Mlcp& mlcp,
                            const ActiveSetSettings& settings = {})
{
    ActiveSetMemory memory;
    Solution solution;
    active_sets(mlcp, settings, memory, solution);
    return solution;
}

}  // namespace rigid
