/// \file verify.hpp
/// What the solvers of this chapter do before and after: look at what they were given, and verify the answer by the
/// one rule of the book (3.16c).
#pragma once

#include "chapters/03_mlcp_formulation/verification.hpp"
#include "chapters/09_active_sets/first_guess.hpp"

#include <limits>
#include <string>
#include <vector>

namespace rigid {

struct ActiveSetSettings {
    /// of the natural residual, as a share of the numbers in a row (3.16c)
    Real tolerance = 1e-10;
    /// [m/s] so little is nothing, whatever q is; for a step it is rounded_speed()
    Real enough = 0;
    int limit = 0;  ///< of guesses; 0 = 500 + n
    /// flips of all wrong rows without progress before one row at a time
    int patience = 5;
};

inline void require_valid(const ActiveSetSettings& settings)
{
    if (!(settings.enough >= 0) || !(settings.enough < infinity))
        throw std::invalid_argument(
            "the residual that is nothing is " + shortest(settings.enough) +
            " m/s; it must be zero or positive, and finite");
    if (!(settings.tolerance > 0) || settings.limit < 0 || settings.patience < 0)
        throw std::invalid_argument(
            "tolerance " + shortest(settings.tolerance) + ", limit " +
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

/// What rounding makes of a velocity [m/s]: positions of x metres are known to ε x, and a gap or an error of a link
/// becomes a velocity by 1/h; a velocity itself is known to ε u. Four of them meet in a row.
inline Real rounded_speed(const VecX& x, const VecX& u, Real h)
{
    const auto largest = [](const VecX& v) {
        return v.size() > 0 ? v.lpNorm<Eigen::Infinity>() : 0;
    };
    return 4 * std::numeric_limits<Real>::epsilon() * (largest(x) / h + largest(u));
}

/// What the guesses aim at [m/s]. Whether they met it is for verify() of chapter 3 to say.
inline Real wanted_residual(const Mlcp& mlcp, const ActiveSetSettings& settings)
{
    const Real largest = mlcp.size() > 0 ? mlcp.q.lpNorm<Eigen::Infinity>() : 0;
    return std::max(settings.tolerance * largest, settings.enough);
}

/// Presses the guess into its bounds and holds it to chapter 3's rule, (3.16c).
inline bool verify_guess(const Mlcp& mlcp, const ActiveSetSettings& settings,
                         const VecX& lambda, Solution& solution)
{
    solution.lambda = lambda;
    clamp_into_bounds(mlcp, solution.lambda);
    const Verification found =
        verify(mlcp, solution.lambda, {settings.tolerance, settings.enough});
    solution.residual = found.residual;
    solution.status = found.solved ? Status::solved : Status::singular;
    return found.solved;
}

}  // namespace rigid
