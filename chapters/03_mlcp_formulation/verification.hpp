/// \file verification.hpp
/// When is a λ an answer? The one rule by which every solver of this book says `solved`.
///
///     S_i = |q_i| + Σ_j |A_ij λ_j|             the numbers that are added up in row i              (3.16a)
///     U_i = min(max_j N_j, d_i max_j N_j/d_j)  what the problem alone makes of them, d_i = √A_ii   (3.16b)
///     r_i ≤ max(f, τ min(S_i, U_i), ε U_i)                                                         (3.16c)
///     r_i ≤ 10 max(f, τ U_i, 64 ε U_i) for every w_i within ½ (k_i + 1) ε S_i of the computed one  (3.16d)
///
/// N_i is S_i at the point of the bounds that is nearest to zero: no λ has a smaller S_i.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {

/// How small a residual has to be.
struct Acceptance {
    Real tolerance = 1e-10;  ///< τ, as a share of the numbers in the row
    Real enough = 0;         ///< f [m/s]: so little is nothing; 0 where nobody knows the speeds
};

/// The natural residual of a λ, and whether it makes λ an answer.
struct Verification {
    Real residual = infinity;  ///< (3.15) [m/s]
    bool solved = false;       ///< by (3.16c) and (3.16d)
};

/// d_i: row i has the unit d_i √J. √A_ii, and in a row without a diagonal what its neighbours make of it.
inline Real row_unit(const Mlcp& mlcp, Index i, Real diagonal)
{
    if (diagonal > 0) return std::sqrt(diagonal);
    Real unit = 0, largest = 0;
    for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
        const Real neighbour = entry.col() == i ? 0 : mlcp.A.coeff(entry.col(), entry.col());
        if (neighbour > 0) unit = std::max(unit, std::abs(entry.value()) / std::sqrt(neighbour));
        largest = std::max(largest, std::abs(entry.value()));
    }
    return unit > 0 ? unit : largest > 0 ? std::sqrt(largest) : 1;
}

/// r_i of (3.15). A row without a diagonal has nothing to compare λ with: it stands at a bound or has w = 0.
inline Real strict_residual_row(Real diagonal, Real lambda, Real w, Real lo, Real hi)
{
    if (diagonal > 0 || !std::isfinite(lambda)) return natural_residual_row(diagonal, lambda, w, lo, hi);
    const Real pulls = lambda >= hi ? 0 : std::max(-w, Real{0});   // it would grow
    const Real pushes = lambda <= lo ? 0 : std::max(w, Real{0});  // it would shrink
    return std::max(pulls, pushes);
}

//! [verify]
/// Holds λ to (3.16c) and (3.16d), in one pass over A. `solved` needs lo ≤ λ ≤ hi to the last digit.
/// Does not allocate.
inline Verification verify(const Mlcp& mlcp, const VecX& lambda, const Acceptance& acceptance = {})
{
    constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
    const Real tau = std::max(acceptance.tolerance, epsilon), enough = acceptance.enough;
    Real residual = 0;
    Real speed = 0, energy = 0;                      // max N_j, max N_j / d_j: what U_i is made of
    Real least_speed = 0, least_energy = 0;          // and how large they have to be for these residuals
    bool possible = true, small = true;              // small: beside S_i, where U_i = 0
    for (Index i = 0; i < mlcp.size(); ++i) {
        const Real lo = mlcp.lo[i], hi = mlcp.hi[i];
        Real w = mlcp.q[i], S = std::abs(w), N = S, diagonal = 0, terms = 1;
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry, ++terms) {
            const Index j = entry.col();
            const Real term = entry.value() * lambda[j];
            w += term;
            S += std::abs(term);
            if (mlcp.lo[j] > 0) N += std::abs(entry.value() * mlcp.lo[j]);
            if (mlcp.hi[j] < 0) N += std::abs(entry.value() * mlcp.hi[j]);
            if (j == i) diagonal = entry.value();
        }
        const Real natural = natural_residual_row(diagonal, lambda[i], w, lo, hi);
        if (!(natural <= residual)) residual = natural;  // also takes over a NaN
        if (std::isnan(residual)) return {residual, false};
        possible = possible && std::isfinite(S) && lambda[i] >= lo && lambda[i] <= hi;
        const Real unit = row_unit(mlcp, i, diagonal);
        if (terms > 1) {
            speed = std::max(speed, N);
            energy = std::max(energy, N / unit);
        }
        if (!(lo < hi)) continue;  // nothing to choose: any w will do

        const Real hidden = epsilon / 2 * terms * S;
        const Real r = strict_residual_row(diagonal, lambda[i], w, lo, hi);
        const Real worst = std::max(strict_residual_row(diagonal, lambda[i], w - hidden, lo, hi),
                                    strict_residual_row(diagonal, lambda[i], w + hidden, lo, hi));
        const bool in_its_row = r <= tau * S;
        Real least = 0;  // U_i
        if (r > enough) least = r / (in_its_row ? tau : epsilon);
        if (worst > 10 * enough) least = std::max(least, worst / (10 * std::max(tau, 64 * epsilon)));
        if (diagonal > 0) least_speed = std::max(least_speed, least);
        least_energy = std::max(least_energy, least / unit);
        small = small && (in_its_row || r <= enough);
    }
    const bool within = energy > 0 ? least_speed <= speed && least_energy <= energy : small;
    return {residual, possible && within && std::isfinite(energy)};
}
//! [verify]

}  // namespace rigid
