/// \file infeasibility.hpp
/// The proof that a problem has no answer, checked on the problem as it was given.
///
///     0 ≤ yᵀw = (Aᵀy)ᵀλ + qᵀy   for every answer;   Aᵀy = 0 and qᵀy < 0: there is none
///
/// (5.15). A walk finds the direction y on a tableau that has been rounded many times, after bilateral rows
/// were eliminated. None of that may count as a proof, so nothing of it is used here but y itself.
#pragma once

#include "chapters/03_mlcp_formulation/verification.hpp"

#include <algorithm>
#include <limits>

namespace rigid {

//! [proof]
/// (5.15) with bounds and rounding: does y prove that there is no answer that
/// doubles could hold? An answer would need Σ x_j / Λ_j > 1e13, where Λ_j is the
/// size of the problem's own impulses: the bounds of row j, and U_j/d_j² of
/// (3.16b).
///
/// The bounds say which w have a sign: w_i ≥ 0 where only lo is finite, w_i ≤ 0
/// where only hi is, w_i = 0 where neither is; v_i gets the same sign, or 0. With
/// x_j the way from a finite bound, or λ_j itself,
///
///     0 ≤ yᵀw ≤ qᵀy + Σ_j (Aᵀy)_j bound_j + Σ_j δ_j x_j
///
/// and δ_j is what is left of (Aᵀy)_j in the direction in which λ_j is free,
/// rounding included. It must be rounding: what is larger is no zero.
/// \param y  one number for each row; cleaned of what the bounds forbid
inline bool proves_infeasibility(const Mlcp& mlcp, VecX y)
{
    const Index n = mlcp.size();
    constexpr Real epsilon = std::numeric_limits<Real>::epsilon(), absurd = 1e13;
    // Aᵀy, |A|ᵀ|y|
    VecX image = VecX::Zero(n), sizes = VecX::Zero(n), terms = VecX::Constant(n, 2);
    VecX unit(n);
    Real gain = 0, size = 0, given = 0, open = 0;
    if (y.size() != n || !y.allFinite()) return false;
    for (Index i = 0; i < n; ++i) {
        if (mlcp.lo[i] > -infinity) y[i] = std::max(y[i], Real{0});
        if (mlcp.hi[i] < infinity) y[i] = std::min(y[i], Real{0});
        gain -= mlcp.q[i] * y[i];
        size += std::abs(mlcp.q[i] * y[i]);
        Real diagonal = 0, N = std::abs(mlcp.q[i]);
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            const Index j = entry.col();
            image[j] += entry.value() * y[i];
            sizes[j] += std::abs(entry.value() * y[i]);
            terms[j] += 1;
            if (mlcp.lo[j] > 0) N += std::abs(entry.value() * mlcp.lo[j]);
            if (mlcp.hi[j] < 0) N += std::abs(entry.value() * mlcp.hi[j]);
            if (j == i) diagonal = entry.value();
        }
        unit[i] = row_unit(mlcp, i, diagonal);
        given = std::max(given, N / unit[i]);
    }
    for (Index j = 0; j < n; ++j) {
        const bool below = mlcp.lo[j] > -infinity, above = mlcp.hi[j] < infinity;
        const Real hidden = epsilon / 2 * terms[j] * sizes[j];
        const Real most = image[j] + hidden, least = image[j] - hidden;
        const Real from = below && above
                              ? std::max(std::abs(mlcp.lo[j]), std::abs(mlcp.hi[j]))
                          : below ? std::abs(mlcp.lo[j])
                          : above ? std::abs(mlcp.hi[j])
                                  : 0;
        size += sizes[j] * from;
        if (below && above) {
            gain -= std::max(std::max(most * mlcp.lo[j], least * mlcp.lo[j]),
                             std::max(most * mlcp.hi[j], least * mlcp.hi[j]));
            continue;
        }
        if (below || above) {
            const Real bound = below ? mlcp.lo[j] : mlcp.hi[j];
            gain -= std::max(most * bound, least * bound);
        }
        const Real up = above ? 0 : std::max(most, Real{0}),
                   down = below ? 0 : std::max(-least, Real{0});
        const Real delta = std::max(up, down);
        if (delta > 8 * hidden) return false;
        open = std::max(open, delta * (given / unit[j] + from));
    }
    // (given = 0: nothing drives the bodies, and λ = 0 is an answer.)
    return given > 0 && std::isfinite(size) &&
           gain > epsilon * static_cast<Real>(n + 4) * size + absurd * open;
}
//! [proof]

}  // namespace rigid
