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

inline void require_valid(const LemkeSettings& settings)
{
    if (!(settings.tolerance > 0) || !(settings.enough >= 0) ||
        settings.pivot_limit < 0)
        throw std::invalid_argument(
            "the tolerance is " + shortest(settings.tolerance) + ", enough " +
            shortest(settings.enough) + " and the pivot limit " +
            std::to_string(settings.pivot_limit) +
            "; the tolerance must be positive, the others not negative");
}

/// A bound so far away that it would swallow q: 1e6 times the problem's own impulses U_i/d_i² of (3.16b).
inline constexpr Real far_bound = 1e6;

/// The problem without the bounds that are far away; false if there are none.
inline bool without_far_bounds(const Mlcp& mlcp, Mlcp& near)
{
    const Index n = mlcp.size();
    VecX unit(n);
    Real given = 0;
    for (Index i = 0; i < n; ++i) {
        unit[i] = row_unit(mlcp, i, mlcp.A.coeff(i, i));
        given = std::max(given, std::abs(mlcp.q[i]) / unit[i]);
    }
    bool any = false;
    for (Index i = 0; i < n; ++i) {
        const Real far = far_bound * given / unit[i];
        const bool below = mlcp.lo[i] < -far && mlcp.lo[i] > -infinity;
        const bool above = mlcp.hi[i] > far && mlcp.hi[i] < infinity;
        if ((below || above) && !any) near = mlcp;
        if (below) near.lo[i] = -infinity;
        if (above) near.hi[i] = infinity;
        any = any || below || above;
    }
    return any;
}

//! [walk]
/// One walk along d_i = 1 … last, on `given`, judged on `mlcp`. Adds its pivots to
/// solution.iterations.
/// \return true if there is no need for another one
inline bool walk_once(const Mlcp& mlcp, const Mlcp& given, Real last, int limit,
                      const LemkeSettings& settings, Solution& solution)
{
    const StandardForm form(given);
    LemkeWalk walk(form.A, form.q, VecX::LinSpaced(form.q.size(), 1, last),
                   settings.ties, settings.tolerances);
    while (walk.place == LemkeWalk::Place::on_the_way &&
           solution.iterations + walk.pivots < limit)
        walk.step();
    solution.iterations += walk.pivots;
    const auto accepted = [&](const VecX& lambda, Status otherwise) {
        const Verification verified =
            verify(mlcp, lambda, {settings.tolerance, settings.enough});
        if (!verified.solved && !(verified.residual < solution.residual)) {
            solution.status = otherwise;
            return false;
        }
        solution.lambda = lambda;
        solution.residual = verified.residual;
        solution.status = verified.solved ? Status::solved : otherwise;
        return verified.solved;
    };
    switch (walk.place) {
    case LemkeWalk::Place::on_the_way:
        accepted(form.impulses(walk.z()), Status::iteration_limit);
        return true;
    case LemkeWalk::Place::ray:
        if (accepted(form.impulses(walk.z()), Status::ray_termination)) return true;
        if (!proves_infeasibility(mlcp, form.direction(walk.ray()))) return false;
        solution.status = Status::infeasible;
        return true;
    case LemkeWalk::Place::solution:
        break;
    }
    if (accepted(form.impulses(walk.z()), Status::singular)) return true;
    std::vector<Index> between;
    const VecX at_bounds = form.bounds_at(walk.tableau, between);
    return accepted(solve_between(mlcp, at_bounds, between), Status::singular);
}
//! [walk]

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
