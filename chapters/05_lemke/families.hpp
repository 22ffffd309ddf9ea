/// \file families.hpp
/// Small problems with a name: what Lemke's algorithm does on them is known, pivot by pivot.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "common/random.hpp"

#include <cmath>

namespace rigid {

/// 0 ≤ z ⟂ A z + q ≥ 0.
Mlcp plain_lcp(const MatX& A, const VecX& q);

/// U: ones on the diagonal, twos above it.
inline MatX murty_matrix(Index n)
{
    MatX U = MatX::Identity(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = i + 1; j < n; ++j) U(i, j) = 2;
    return U;
}

/// U with q_i = -(2ⁿ⁺¹ - 2ⁱ), i = 1 … n: the walk visits all 2ⁿ vertices that it can (5.20).
/// \cite murty1997, §6.2
Mlcp murty(Index n);

/// Uᵀ with q = -1: nothing but ties, and all depends on how they are broken. The answer is z = e₁.
inline Mlcp murty_transposed(Index n)
{
    return plain_lcp(murty_matrix(n).transpose(), -VecX::Ones(n));
}

/// U with q = -1: two pivots.
inline Mlcp murty_equal(Index n)
{
    return plain_lcp(murty_matrix(n), -VecX::Ones(n));
}

/// a_ii = 4i - 3, a_ij = 4 min(i, j) - 2, q = -1: symmetric positive definite, and no better. The answer is
/// z = e₁. \cite fathi1979
Mlcp fathi(Index n);

/// Two on the diagonal, -1 beside it: a column of equal discs hit by q. No entry off the diagonal is positive
/// (a Z-matrix), and then a variable that has entered never leaves.
inline Mlcp tridiagonal(const VecX& q)
{
    MatX A = 2 * MatX::Identity(q.size(), q.size());
    for (Index i = 0; i + 1 < q.size(); ++i) A(i, i + 1) = A(i + 1, i) = -1;
    return plain_lcp(A, q);
}

/// w_i = z_i + 2 z_{i+1} - 1 around a circle: every ratio test is a tie.
inline Mlcp circulant(Index n)
{
    MatX A = MatX::Identity(n, n);
    for (Index i = 0; i < n; ++i) A(i, (i + 1) % n) += 2;
    return plain_lcp(A, -VecX::Ones(n));
}

/// A = G Gᵀ/n + 0.01 I with normal entries of G, and normal q: about half of the rows are active.
Mlcp random_spd(Index n, Random& random);

}  // namespace rigid
