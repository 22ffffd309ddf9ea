/// \file friction_boxes.hpp
/// Friction rows whose bounds follow another row: −μ λ_n ≤ λ_f ≤ μ λ_n.
///
/// The bounds are part of the guess. Fix them, solve, read the new λ_n, and again (9.20); when the cases stand
/// still, one linear system with λ_f = ±μ λ_n put in for the rows that slide gives all of them at once (9.21).
/// Only called solved if the natural residual with the bounds of the answer itself is small. A is symmetric,
/// but the whole problem is not an MLCP: it may have several answers or none.
#pragma once

#include "chapters/09_active_sets/active_sets.hpp"

#include <span>
#include <vector>

namespace rigid {

/// Row `row` is bounded by ±mu times the λ of row `normal`.
struct FrictionBox {
    Index row = 0, normal = 0;
    Real mu = 0;
};

//! [bounds]
/// The bounds that the λ of the normal rows leave to the others.
inline void bound_by(std::span<const FrictionBox> boxes, const VecX& lambda,
                     Mlcp& mlcp)
{
    for (const FrictionBox& box : boxes) {
        mlcp.hi[box.row] = box.mu * std::max(lambda[box.normal], Real{0});
        mlcp.lo[box.row] = -mlcp.hi[box.row];
    }
}
//! [bounds]

/// A λ that is at its bound by the guess is that bound to the last digit, and no λ is outside.
void to_bounds(const Mlcp& mlcp, const std::vector<BoundState>& cases,
               VecX& lambda);

/// (9.21): the λ of a guess in which the rows that slide follow their normal rows.
bool solve_tied(const Mlcp& mlcp, std::span<const FrictionBox> boxes,
                const std::vector<BoundState>& cases, VecX& lambda);

/// Throws std::invalid_argument unless each row has its bounds and each box names two rows that there are, with μ ≥ 0.
void require_valid(const Mlcp& mlcp, std::span<const FrictionBox> boxes);

/// Solves a problem with friction boxes; the bounds that mlcp gives for their rows
/// are not looked at. `iterations` counts the guesses of all rounds.
/// \param boxes  of rows that exist, each row at most once, mu ≥ 0
/// \throws std::invalid_argument  for a malformed problem, box or setting
void active_sets(const Mlcp& mlcp, std::span<const FrictionBox> boxes,
                 const ActiveSetSettings& settings, ActiveSetMemory& memory,
                 Solution& solution);

inline Solution active_sets(const Mlcp& mlcp, std::span<const FrictionBox> boxes,
                            const ActiveSetSettings& settings = {})
{
    ActiveSetMemory memory;
    Solution solution;
    active_sets(mlcp, boxes, settings, memory, solution);
    return solution;
}

}  // namespace rigid
