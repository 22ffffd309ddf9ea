/// \file conjugate_gradients.hpp
/// The contrast: conjugate gradients, for bilateral rows only.
///
///     A λ + q = 0,   A symmetric positive (semi-)definite
///
/// Where a sweep forgets all but the last λ, each step here minimises the merit ½ λᵀAλ + qᵀλ over all
/// directions so far (4.22): n rows take at most n steps. It has no way to clamp.
/// \cite hestenes1952
#pragma once

#include "chapters/03_mlcp_formulation/verification.hpp"
#include "common/text.hpp"

namespace rigid {

/// Memory that is kept from solve to solve.
struct CgMemory {
    VecX residual, scaled, direction, image, inverse_diagonal;
};

/// y = A x, row by row, without a temporary.
void multiply(const SparseMatrix& A, const VecX& x, VecX& y);

/// Conjugate gradients with the diagonal of A as preconditioner, from `solution.lambda` on.
///
/// `solved` when the natural residual, here the largest |w_i|, met the tolerance and rounding can't hide a hundred
/// times as much, (3.16d); `singular` when a direction has no curvature but a slope (conflicting rows), or λ ran
/// away along one that has nearly none; else `iteration limit`.
/// \param tolerance  [m/s]
/// \throws std::invalid_argument  if the problem is invalid or a row has a bound
void conjugate_gradients(const Mlcp& mlcp, Real tolerance, int max_iterations,
                         CgMemory& memory, Solution& solution);

/// The same from zero, with memory of its own.
Solution conjugate_gradients(const Mlcp& mlcp, Real tolerance = 1e-9,
                             int max_iterations = 10000);

}  // namespace rigid
