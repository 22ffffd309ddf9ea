/// \file infeasibility.hpp
/// The proof that a problem has no answer, checked on the problem as it was given.
///
///     0 ≤ vᵀw = (Aᵀv)ᵀλ + qᵀv   for every answer;   Aᵀv = 0 and qᵀv < 0: there is none
///
/// (5.15). A walk finds the direction v on a tableau that has been rounded many times, after bilateral rows
/// were eliminated. None of that may count as a proof, so nothing of it is used here but v itself.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <algorithm>
#include <limits>

namespace rigid {

//! [proof]
/// (5.15): does a direction prove that there is no answer? The bounds say which w have a sign: w_i ≥ 0 where
/// only lo is finite, w_i ≤ 0 where only hi is, w_i = 0 where neither is; v_i gets the same sign, or 0.
///
/// Rounding leaves Aᵀv ≤ δ where it should be zero. Then an answer would need Σ|λ| ≥ −qᵀv/δ, and we want
/// that to be absurd. δ counts what rounding may hide in the sums of Aᵀv, too.
/// \param v  one number for each row; cleaned of what the bounds forbid
inline bool proves_infeasibility(const Mlcp& mlcp, VecX v)
{
    const Index n = mlcp.size();
    constexpr Real epsilon = std::numeric_limits<Real>::epsilon(), absurd = 1e13;
    VecX image = VecX::Zero(n), sizes = VecX::Zero(n), terms = VecX::Constant(n, 2);  // Aᵀv, |A|ᵀ|v|
    Real largest_A = 0, largest_q = 0, gain = 0;
    for (Index i = 0; i < n; ++i) {
        if (mlcp.lo[i] > -infinity) v[i] = std::max(v[i], Real{0});
        if (mlcp.hi[i] < infinity) v[i] = std::min(v[i], Real{0});
        gain -= mlcp.q[i] * v[i] + epsilon * static_cast<Real>(n) * std::abs(mlcp.q[i] * v[i]);
        largest_q = std::max(largest_q, std::abs(mlcp.q[i]));
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            image[entry.col()] += entry.value() * v[i];
            sizes[entry.col()] += std::abs(entry.value() * v[i]);
            terms[entry.col()] += 1;
            largest_A = std::max(largest_A, std::abs(entry.value()));
        }
    }
    Real delta = 0;
    for (Index j = 0; j < n; ++j) {  // what λ_j can add: little where it is bounded, δ each unit where not
        const Real hidden = epsilon * terms[j] * sizes[j];
        const Real most = image[j] + hidden, least = image[j] - hidden;
        const auto at = [&](Real bound) { return std::max(most * bound, least * bound); };
        const bool below = mlcp.lo[j] > -infinity, above = mlcp.hi[j] < infinity;
        if (below && above) gain -= std::max(at(mlcp.lo[j]), at(mlcp.hi[j]));
        else if (below || above) gain -= at(below ? mlcp.lo[j] : mlcp.hi[j]);
        if (!above) delta = std::max(delta, most);
        if (!below) delta = std::max(delta, -least);
    }
    return gain > 0 && gain * largest_A > absurd * delta * largest_q;
}
//! [proof]

}  // namespace rigid
