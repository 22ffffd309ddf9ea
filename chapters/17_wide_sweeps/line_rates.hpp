/// \file line_rates.hpp
/// What another order of the visits does to sweeps on a line of equal bodies, in closed form.
///
///     A = tridiagonal (−1, 2, −1),   e_i ← ½ (e_{i−1} + e_{i+1}) at a visit
///
///     given      e_i = c^i sin iθ                       each sweep: e ← c² e,    c = cos θ, θ = kπ/(N+1)
///     coloured   e_i = sin iθ (odd), c sin iθ (even)    each sweep: e ← c² e
///
/// (17.6) to (17.9). \cite young1954
#pragma once

#include "common/elementary.hpp"
#include "common/math.hpp"

#include <cmath>

namespace rigid {

//! [modes]
/// Mode k of sweeps over N rows in a line: errors that a sweep only makes smaller.
struct LineModes {
    int N;
    Real theta, c;

    LineModes(int rows, int k) : N(rows), theta(k * pi / (rows + 1)), c(cos(theta))
    {
    }
    Real rate() const { return c * c; }  ///< (17.6)
    Real best_momentum() const           ///< (17.13)
    {
        return (1 - sin(theta)) / (1 + sin(theta));
    }

    VecX given() const  ///< (17.6)
    {
        return VecX::NullaryExpr(N, [&](Index i) {
            const auto n = static_cast<Real>(i + 1);
            return pow(c, n) * sin(n * theta);
        });
    }
    VecX coloured() const  ///< (17.7)
    {
        return VecX::NullaryExpr(N, [&](Index i) {
            const Real s = sin(static_cast<Real>(i + 1) * theta);
            return i % 2 == 0 ? s : c * s;
        });
    }
    /// (17.8): the largest residual of given(): (1 − c²) max c^{i−1} sin (i+1)θ.
    Real residual_given() const
    {
        Real most = 0;
        for (int i = 1; i < N; ++i)
            most = std::max(most, pow(c, i - 1) * std::abs(sin((i + 1) * theta)));
        return (1 - c * c) * most;
    }
    /// (17.9): of coloured(): 2 (1 − c²) max sin iθ over the first colour.
    Real residual_coloured() const
    {
        Real most = 0;
        for (int i = 1; i <= N; i += 2)
            most = std::max(most, std::abs(sin(i * theta)));
        return 2 * (1 - c * c) * most;
    }
};
//! [modes]

/// One sweep over the errors of a line: rows as they come, or every second one and then the others.
VecX line_sweep(VecX e, bool coloured);

/// A e.
inline VecX line_residual(const VecX& e)
{
    const Index N = e.size();
    return VecX::NullaryExpr(N, [&](Index i) {
        return 2 * e[i] - (i > 0 ? e[i - 1] : 0) - (i + 1 < N ? e[i + 1] : 0);
    });
}

}  // namespace rigid
