/// \file coulomb_residual.hpp
/// The Coulomb problem of some rows, the one measure of its error, and when a λ is an answer.
///
///     w = A λ + q,   λ_i in [lo_i, hi_i] of an ordinary row, in [−μ λ_n, μ λ_n] of a friction row,
///     w ≥ 0 where λ is its lower bound, w ≤ 0 where it is the upper one, w = 0 between
///
/// (13.4). It is chapter 3's MLCP with one change: some bounds are not given but come out of the answer. So its residual is
/// chapter 3's, with the bounds that this very λ sets (13.5).
#pragma once

#include "chapters/09_active_sets/friction_boxes.hpp"

namespace rigid {

/// Which of these rows another one bounds, and with what μ.
template <int Dof>
void boxes_of(const std::vector<Row<Dof>>& rows, std::vector<FrictionBox>& boxes)
{
    boxes.clear();
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].bounded_by >= 0)
            boxes.push_back(
                {static_cast<Index>(i), rows[i].bounded_by, rows[i].friction});
}

//! [residual]
/// (13.5): the natural residual of the Coulomb problem [m/s].
/// \param mlcp  A, q, and the bounds of ordinary rows; those of friction rows
///              become the ones that λ sets
inline Real coulomb_residual(Mlcp& mlcp, std::span<const FrictionBox> boxes,
                             const VecX& lambda)
{
    bound_by(boxes, lambda, mlcp);
    return natural_residual(mlcp, lambda);
}

/// Presses λ into its bounds, those of friction rows last, and holds it to chapter
/// 3's rule (3.16c) with the bounds that it then sets. `solved` is said nowhere
/// else in this chapter.
/// \param mlcp      bounds as above
/// \param lambda    the candidate
/// \param solution  becomes λ with its residual if that is smaller than what it has
///                  (what is no number is never smaller)
/// \return          whether it is an answer
inline bool accept_coulomb(Mlcp& mlcp, std::span<const FrictionBox> boxes,
                           const Acceptance& acceptance, VecX& lambda,
                           Solution& solution)
{
    for (const FrictionBox& box : boxes)
        mlcp.lo[box.row] = -infinity, mlcp.hi[box.row] = infinity;
    clamp_into_bounds(mlcp, lambda);
    bound_by(boxes, lambda, mlcp);
    clamp_into_bounds(mlcp, lambda);
    const Verification found = verify(mlcp, lambda, acceptance);
    if (found.solved || found.residual < solution.residual) {
        solution.lambda = lambda;
        solution.residual = found.residual;
    }
    if (found.solved) solution.status = Status::solved;
    return found.solved;
}
//! [residual]

}  // namespace rigid
