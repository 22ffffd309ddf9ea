/// \file guess_run.hpp
/// A guess on its way, alive: one correction per step of the program.
#pragma once

#include "chapters/09_active_sets/active_sets.hpp"
#include "chapters/09_active_sets/dantzig.hpp"
#include "common/program/program.hpp"

#include <memory>

namespace rigid {

/// A guess on its way: what the solver has after so many corrections. It is solved again each time, with that
/// many allowed: a solver depends on its arguments alone, so it comes the same way, one correction further.
struct GuessWalk {
    Mlcp problem;
    std::string method;
    std::vector<BoundState> first;
    int allowed = 1;      ///< corrections that the solver may make
    int corrections = 0;  ///< and did
    ActiveSetMemory memory;
    Solution solution;  ///< what the solver says of it
    /// what the guess led to, within its bounds or not [N s]
    VecX lambda;
    std::vector<BoundState> cases;  ///< the guess itself

    /// \param start  the previous set; empty = the solver's own first guess
    GuessWalk(Mlcp mlcp, std::string solver, std::vector<BoundState> start = {})
        : problem(std::move(mlcp)), method(std::move(solver)),
          first(std::move(start))
    {
        solve(allowed);
    }

    bool done() const { return solution.status != Status::iteration_limit; }
    //! [one_correction]
    void step()
    {
        if (!done()) solve(++allowed);
    }
    void to_the_end() { solve(0); }
    //! [one_correction]

    /// What is guessed of row i: what its present λ was solved with.
    BoundState guess(Index i) const { return cases[static_cast<std::size_t>(i)]; }
    Real w(Index i) const
    {
        Real sum = problem.q[i];
        for (SparseMatrix::InnerIterator entry(problem.A, i); entry; ++entry)
            sum += entry.value() * lambda[entry.col()];
        return sum;
    }
    /// The row contradicts its guess: an active one pulls, or one that was let go is pushed through.
    bool wrong(Index i) const
    {
        const Real tiny = 1e-9 * (1e-300 + problem.q.cwiseAbs().maxCoeff()),
                   now = lambda[i];
        const Real a = problem.A.coeff(i, i);
        if (guess(i) == BoundState::at_lo) return w(i) < -tiny;
        if (guess(i) == BoundState::at_hi) return w(i) > tiny;
        return a * (problem.lo[i] - now) > tiny || a * (now - problem.hi[i]) > tiny;
    }
    Index count(BoundState which) const
    {
        return static_cast<Index>(std::count(cases.begin(), cases.end(), which));
    }
    Index count_wrong() const
    {
        Index sum = 0;
        for (Index i = 0; i < problem.size(); ++i) sum += wrong(i);
        return sum;
    }

    static std::vector<Column> columns()
    {
        return {
            {"corrections", "", "guesses, or pivots, so far"},
            {"wrong", "", "rows that contradict the guess", Plot::linear},
            {"active", "", "rows that the guess holds at w = 0", Plot::linear},
            {"residual", "m/s", "natural residual of the present impulses",
             Plot::logarithmic},
            {"factorisations", "", "of the active rows, whole"},
            {"flips", "", "rows that changed their case, all corrections together"},
            {"rows", "", "n"},
            {"status", "",
             "0 solved, 1 still guessing, 2 … 4 ray, infeasible, singular"}};
    }
    std::vector<Real> measure() const
    {
        return {static_cast<Real>(corrections),
                static_cast<Real>(count_wrong()),
                static_cast<Real>(count(BoundState::between)),
                std::isfinite(solution.residual) ? solution.residual : 0,
                static_cast<Real>(memory.work.factorisations),
                static_cast<Real>(memory.work.flips),
                static_cast<Real>(problem.size()),
                static_cast<Real>(solution.status)};
    }
    std::string told() const
    {
        const std::string what = method == "active_sets" ? "guess" : "pivot";
        const std::string many = method == "active_sets" ? "guesses" : "pivots";
        const std::string name = std::to_string(corrections) + " " +
                                 (corrections == 1 ? what : many) + ": ";
        if (done()) return name + std::string(to_string(solution.status));
        if (memory.dependent && lambda.isZero())
            return name + "its active rows depend on each other";
        return name + std::to_string(count_wrong()) + " of " +
               std::to_string(problem.size()) + " rows are wrong";
    }

private:
    void solve(int limit)
    {
        ActiveSetSettings settings;
        settings.limit = limit;
        memory = {};
        memory.cases = first;
        if (method == "active_sets")
            active_sets(problem, settings, memory, solution);
        else if (method == "dantzig") dantzig(problem, settings, memory, solution);
        // chapter 5's walk, to compare
        else solution = lemke(problem, {{}, {}, limit, settings.tolerance});
        corrections = solution.iterations;
        lambda = method == "lemke" ? solution.lambda : memory.guess.lambda;
        // A row that is not active rests at its bound to the bit: λ shows what was guessed.
        cases.resize(static_cast<std::size_t>(problem.size()));
        for (Index i = 0; i < problem.size(); ++i)
            cases[static_cast<std::size_t>(i)] =
                lambda[i] == problem.lo[i]   ? BoundState::at_lo
                : lambda[i] == problem.hi[i] ? BoundState::at_hi
                                             : BoundState::between;
    }
};

}  // namespace rigid
