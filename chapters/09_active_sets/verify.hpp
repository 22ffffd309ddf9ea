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

void require_valid(const ActiveSetSettings& settings);

/// True if A is symmetric but for rounding. One pass: of the entries a_ji, in the order of i, each line's next one
/// must be there.
bool is_symmetric(const SparseMatrix& A, std::vector<int>& next);

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
bool verify_guess(const Mlcp& mlcp, const ActiveSetSettings& settings,
                  const VecX& lambda, Solution& solution);

}  // namespace rigid
