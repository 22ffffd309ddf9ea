/// \file sweeps.hpp
/// One visit of every row of an MLCP: solve the row for its own λ, clamp, go on.
///
///     w = A λ + q,   lo ≤ λ ≤ hi,   0 = λ − clamp(λ − w/a, lo, hi)   in every row, a = A_ii
///
/// A visit does λ_i ← clamp(λ_i − ω w_i / A_ii), (4.4) with ω = 1 and (4.18) with any ω. This is the method as the text
/// derives it; prescaled_sweeps.hpp does the same with less work per visit, and a test compares the two.
/// \cite cryer1971
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {

//! [visit]
/// One visit of row i, (4.18); for ω = 1 that is (4.4).
/// \param omega  relaxation, 0 < ω < 2
/// \return       the new λ_i [N s]
inline Real visit(const Mlcp& mlcp, Index i, const VecX& lambda, Real omega = 1)
{
    Real w = mlcp.q[i], A_ii = 0;
    for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
        // (4.3): w_i = Σ_j A_ij λ_j + q_i
        w += entry.value() * lambda[entry.col()];
        if (entry.col() == i) A_ii = entry.value();
    }
    if (!(A_ii > 0)) A_ii = 1;  // as in the natural residual
    return std::clamp(lambda[i] - omega * w / A_ii, mlcp.lo[i], mlcp.hi[i]);
}
//! [visit]

//! [gauss-seidel]
/// One Gauss-Seidel sweep, forward: each visit uses what the visits before it have
/// changed.
inline void sweep_forward(const Mlcp& mlcp, VecX& lambda, Real omega = 1)
{
    for (Index i = 0; i < mlcp.size(); ++i)
        lambda[i] = visit(mlcp, i, lambda, omega);
}
//! [gauss-seidel]

/// The same from the last row to the first.
inline void sweep_backward(const Mlcp& mlcp, VecX& lambda, Real omega = 1)
{
    for (Index i = mlcp.size(); i-- > 0;) lambda[i] = visit(mlcp, i, lambda, omega);
}

//! [jacobi]
/// One Jacobi sweep: each visit uses what all λ were before the sweep.
/// \param before  memory for a copy of λ
inline void sweep_jacobi(const Mlcp& mlcp, VecX& lambda, VecX& before,
                         Real omega = 1)
{
    before = lambda;
    for (Index i = 0; i < mlcp.size(); ++i)
        lambda[i] = visit(mlcp, i, before, omega);
}
//! [jacobi]

}  // namespace rigid
