/// \file accept.hpp
/// What every exact solver does before and after: look at what it was given, and prove the answer.
///
///     solved  ⇔  natural residual ≤ tolerance · max |q|   and rounding can't hide ten times as much
#pragma once

#include "chapters/05_lemke/lemke.hpp"
#include "chapters/09_active_sets/first_guess.hpp"

#include <string>
#include <vector>

namespace rigid {

struct ActiveSetSettings {
    Real tolerance = 1e-10;  ///< of the natural residual, as a share of the largest |q|
    int limit = 0;           ///< of guesses; 0 = 500 + n
    int patience = 5;        ///< flips of all wrong rows without progress before one row at a time
};

inline void require_valid(const ActiveSetSettings& settings)
{
    if (!(settings.tolerance > 0) || settings.limit < 0 || settings.patience < 0)
        throw std::invalid_argument("tolerance " + shortest(settings.tolerance) + ", limit " +
                                    std::to_string(settings.limit) + ", patience " +
                                    std::to_string(settings.patience) +
                                    ": the tolerance must be positive, the others not negative");
}

/// True if A is symmetric but for rounding. One pass: of the entries a_ji, in the order of i, each line's next one
/// must be there.
inline bool is_symmetric(const SparseMatrix& A, std::vector<int>& next)
{
    const int* const outer = A.outerIndexPtr();
    const int* const inner = A.innerIndexPtr();
    const Real* const value = A.valuePtr();
    const auto n = static_cast<int>(A.rows());
    next.assign(outer, outer + n);
    for (int i = 0; i < n; ++i)
        for (int p = next[static_cast<std::size_t>(i)]; p < outer[i + 1]; ++p) {
            const int j = inner[p];
            if (j < i) return false;  // its partner should have been passed
            int& mirrored = next[static_cast<std::size_t>(j)];
            if (mirrored >= outer[j + 1] || inner[mirrored] != i) return false;
            const Real difference = std::abs(value[mirrored] - value[p]);
            if (difference > 1e-12 * std::abs(value[p])) return false;
            if (j > i) ++mirrored;
        }
    return true;
}

/// What rounding alone may hide when w = A λ + q is computed [m/s]: λ of 1e13 that cancel in w can look right
/// by luck. A bound that is quick to have will do where it is not above `enough`.
inline Real hidden_by_rounding(const Mlcp& mlcp, const VecX& lambda, Real enough)
{
    if (mlcp.A.nonZeros() == 0) return 0;
    constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
    const Real entry_sum = mlcp.A.coeffs().abs().maxCoeff() * lambda.lpNorm<1>();
    const Real bound = epsilon * (mlcp.q.cwiseAbs().maxCoeff() + entry_sum);
    if (bound <= enough) return bound;
    Real largest = 0;
    for (Index i = 0; i < mlcp.size(); ++i) {
        Real sum = std::abs(mlcp.q[i]);
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
            sum += std::abs(entry.value() * lambda[entry.col()]);
        if (!(sum <= largest)) largest = sum;
    }
    return epsilon * largest;
}

/// How large a residual may be [m/s]: a share of q, or of 1e-4 of what the bounds add to it.
/// \param start  room for the point of the bounds that is nearest to zero
inline Real allowed_residual(const Mlcp& mlcp, Real tolerance, VecX& start)
{
    start.setZero(mlcp.size());
    clamp_into_bounds(mlcp, start);
    const bool any = (start.array() != 0).any();
    Real largest = mlcp.size() > 0 ? mlcp.q.cwiseAbs().maxCoeff() : 0;
    for (Index i = 0; i < mlcp.size() && any; ++i) {
        Real w = mlcp.q[i];
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
            w += entry.value() * start[entry.col()];
        largest = std::max(largest, 1e-4 * std::abs(w));
    }
    return tolerance * largest;
}

/// Presses the guess into its bounds, computes the residual, and says whether it is an answer.
inline bool judge(const Mlcp& mlcp, Real allowed, const VecX& lambda, Solution& solution)
{
    solution.lambda = lambda;
    clamp_into_bounds(mlcp, solution.lambda);
    solution.residual = natural_residual(mlcp, solution.lambda);
    const bool good = solution.residual <= allowed &&
                      hidden_by_rounding(mlcp, solution.lambda, 10 * allowed) <= 10 * allowed;
    solution.status = good ? Status::solved : Status::singular;
    return good;
}

}  // namespace rigid
