/// \file lemke.hpp
/// Lemke's algorithm: walk from vertex to vertex, and finish.
///
///     w = A λ + q,   lo ≤ λ ≤ hi,   λ_i = lo_i or λ_i = hi_i or w_i = 0
///
/// Brought to the plain form (standard_form.hpp), walked (walk.hpp), and only called solved by chapter 3's rule.
/// Algorithm 5.1 has all of it in one place. \cite lemke1965; \cite cottle1992, §4.4; \cite murty1997, ch. 2
#pragma once

#include "chapters/05_lemke/infeasibility.hpp"
#include "chapters/05_lemke/standard_form.hpp"
#include "chapters/05_lemke/walk.hpp"
#include "common/text.hpp"

#include <string>

namespace rigid {

struct LemkeSettings {
    TieRule ties = TieRule::lexicographic;
    Tolerances tolerances;  ///< of pivots and ties
    /// of all walks together; 0 = 10,000 + 50 n: far beyond what contacts need
    int pivot_limit = 0;
    /// τ of (3.16c): of the natural residual, as a share of the numbers in a row
    Real tolerance = 1e-10;
    /// f of (3.16c) [m/s]: a residual that is nothing, whatever the numbers
    Real enough = 0;
};

void require_valid(const LemkeSettings& settings);

/// A bound so far away that it would swallow q: 1e6 times the problem's own impulses U_i/d_i² of (3.16b).
inline constexpr Real far_bound = 1e6;

/// The problem without the bounds that are far away; false if there are none.
bool without_far_bounds(const Mlcp& mlcp, Mlcp& near);

/// One walk along d_i = 1 … last, on `given`, judged on `mlcp`. Adds its pivots to
/// solution.iterations.
/// \return true if there is no need for another one
bool walk_once(const Mlcp& mlcp, const Mlcp& given, Real last, int limit,
               const LemkeSettings& settings, Solution& solution);

//! [lemke]
/// Solves an MLCP. `iterations` counts pivots, the first one (z0 enters) included.
///
/// `solved`: by the rule of chapter 3, (3.16c) and (3.16d). `infeasible`: a ray
/// that proves it (5.15). `ray termination`: a ray that proves nothing. `singular`:
/// the last vertex is no answer to that many digits. `iteration limit`: of pivots.
/// If not solved, lambda is the best of the vertices where the walks ended, the
/// status that of the last, and the residual says how wrong it is.
///
/// \throws std::invalid_argument  for a malformed problem or settings that make no
///     sense
inline Solution lemke(const Mlcp& mlcp, const LemkeSettings& settings = {})
{
    require_valid(mlcp);
    require_valid(settings);
    Solution solution;
    solution.lambda = VecX::Zero(mlcp.size()).cwiseMax(mlcp.lo).cwiseMin(mlcp.hi);
    const int limit = settings.pivot_limit > 0
                          ? settings.pivot_limit
                          : 10000 + 50 * static_cast<int>(mlcp.size());
    Mlcp near;
    if (without_far_bounds(mlcp, near) &&
        walk_once(mlcp, near, 1, limit, settings, solution))
        return solution;
    // If rounding led the first walk astray, another covering vector is another
    // way.
    if (!walk_once(mlcp, mlcp, 1, limit, settings, solution))
        walk_once(mlcp, mlcp, 2, limit, settings, solution);
    return solution;
}
//! [lemke]

}  // namespace rigid
