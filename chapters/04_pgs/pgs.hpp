/// \file pgs.hpp
/// Projected Gauss-Seidel: solve the MLCP one row at a time.
///
///     w = A λ + q,   lo ≤ λ ≤ hi,   λ_i = lo_i or λ_i = hi_i or w_i = 0
///
/// Sweeps (sweeps.hpp, in the form of prescaled_sweeps.hpp) until the natural residual, the one measure of error of this book, is below a
/// tolerance in m/s. Converges for symmetric positive definite A and 0 < ω < 2 \cite cryer1971; for a column
/// or a chain of N rows with end mass R the error shrinks by cos²θ a sweep, (4.14), which is why long
/// chains and heavy loads take so long.
#pragma once

#include "chapters/03_mlcp_formulation/verification.hpp"
#include "chapters/04_pgs/prescaled_sweeps.hpp"
#include "chapters/04_pgs/sweeps.hpp"
#include "common/text.hpp"

namespace rigid {

enum class Sweeps {
    jacobi,        ///< all rows at once
    gauss_seidel,  ///< one after the other; SOR for ω ≠ 1
    symmetric      ///< forward and backward in turn
};

struct PgsSettings {
    /// of the natural residual [m/s]; 0 = always make all sweeps
    Real tolerance = 1e-9;
    int max_sweeps = 10000;
    Real omega = 1;  ///< relaxation, 0 < ω < 2
    Sweeps sweeps = Sweeps::gauss_seidel;
    /// row numbers in the order of the visits; empty = as they are
    std::vector<int> order;
};

/// Memory that is kept from solve to solve, and what the last solve cost.
struct PgsMemory {
    SweepRows rows;
    /// how often the residual was computed: each costs about as much as a sweep
    int checks = 0;
};

/// A cold start: the point within the bounds that is nearest to 0.
inline void cold_start(const Mlcp& mlcp, VecX& lambda)
{
    lambda.resize(mlcp.size());
    for (Index i = 0; i < mlcp.size(); ++i)
        lambda[i] = std::clamp(Real{0}, mlcp.lo[i], mlcp.hi[i]);
}

/// True if some row has w = q whatever λ is, and only an infinite λ would make that right.
bool has_hopeless_row(const Mlcp& mlcp, const SweepRows& sweep, Real tolerance);

void require_valid(const PgsSettings& settings);

/// Sweeps from `solution.lambda` on; solution.iterations counts the sweeps.
///
/// `solved`: the natural residual was computed and met the tolerance, and rounding can't hide
/// a hundred times as much: chapter 3's rule with f = tolerance and τ = ε, (3.16c) and (3.16d). `infeasible`: a row
/// that no λ can change would need an infinite one. Else `iteration limit`, also when the numbers overflow
/// (λ is then the cold start). Does not allocate once it has seen a problem of this size.
/// \param solution  in: the λ to start from (see cold_start()); out: the answer
/// \throws std::invalid_argument  for an invalid problem, setting or start
inline void pgs(const Mlcp& mlcp, const PgsSettings& settings, PgsMemory& memory,
                Solution& solution)
{
    require_valid(mlcp);
    require_valid(settings);
    if (solution.lambda.size() != mlcp.size() || !solution.lambda.allFinite())
        throw std::invalid_argument(
            "the start has " + std::to_string(solution.lambda.size()) +
            " impulses or one that is not finite; the problem has " +
            std::to_string(mlcp.size()) + " rows");
    SweepRows& rows = memory.rows;
    prepare(mlcp, settings.omega, settings.order, rows);
    // into the bounds, which the caller may have moved
    for (Index i = 0; i < mlcp.size(); ++i)
        rows.lambda[rows.place_of[static_cast<std::size_t>(i)]] =
            std::clamp(solution.lambda[i], mlcp.lo[i], mlcp.hi[i]);

    //! [stop]
    // The residual costs as much as a sweep; the change is free, but it is not the
    // error. So keep the ratio of the two, and compute the residual again when that
    // ratio predicts that it meets the tolerance, or when half as many sweeps again
    // have been made.
    const bool hopeless = has_hopeless_row(mlcp, rows, settings.tolerance);
    const int limit = hopeless ? 0 : settings.max_sweeps;
    int sweeps = 0, next_check = 0;
    Real change = 0, residual_per_change = 1;
    memory.checks = 0;
    for (;; ++sweeps) {
        // A sweep that changed nothing is the last one: the next would change
        // nothing either.
        const bool last = sweeps >= limit || (sweeps > 0 && change <= 0);
        if (last || (settings.tolerance > 0 &&
                     (sweeps >= next_check ||
                      residual_per_change * change <= settings.tolerance))) {
            for (Index i = 0; i < mlcp.size(); ++i)
                solution.lambda[i] =
                    rows.lambda[rows.place_of[static_cast<std::size_t>(i)]];
            solution.residual = natural_residual(mlcp, solution.lambda);
            ++memory.checks;
            if (last || solution.residual <= settings.tolerance ||
                !std::isfinite(solution.residual))
                break;
            if (change > 0) residual_per_change = solution.residual / change;
            next_check = sweeps + std::max(1, sweeps / 2);
        }
        switch (settings.sweeps) {
        case Sweeps::jacobi:
            change = sweep_jacobi(rows);
            break;
        case Sweeps::gauss_seidel:
            change = sweep_forward(rows);
            break;
        case Sweeps::symmetric:
            change = sweeps % 2 == 0 ? sweep_forward(rows) : sweep_backward(rows);
            break;
        }
    }
    //! [stop]

    solution.iterations = sweeps;
    const bool met = solution.residual <= settings.tolerance &&
                     verify(mlcp, solution.lambda, {0, settings.tolerance}).solved;
    solution.status = met ? Status::solved : Status::iteration_limit;
    // the iteration grew without bound: return finite impulses
    if (!std::isfinite(solution.residual)) {
        cold_start(mlcp, solution.lambda);
        solution.residual = natural_residual(mlcp, solution.lambda);
        solution.status = Status::iteration_limit;
    }
    if (hopeless) solution.status = Status::infeasible;
}

/// The same from a cold start, with memory of its own.
inline Solution pgs(const Mlcp& mlcp, const PgsSettings& settings = {})
{
    PgsMemory memory;
    Solution solution;
    require_valid(mlcp);
    cold_start(mlcp, solution.lambda);
    pgs(mlcp, settings, memory, solution);
    return solution;
}

}  // namespace rigid
