/// \file memory_rates.hpp
/// What memory does to steps that make too few sweeps, in formulas: the theory lines of this chapter's plots.
///
/// A mode of the rows whose error k sweeps multiply by γ = ρᵏ obeys, from step to step,
///
///     z³ − (1 − β + γ (1 + σ + β)) z² + γ (1 + 2σ) z − γσ = 0        (8.18)
///
/// with Baumgarte's β and the share σ of the previous impulses. All its |z| are below 1 exactly if
///
///     σ γ (1 + β) < 1                                                 (8.9)
///
/// for real γ of 0 … 1. Where rows form loops, γ may be complex: (8.14).
#pragma once

#include "common/elementary.hpp"
#include "common/math.hpp"

#include <cmath>
#include <complex>

namespace rigid {

/// The largest |z| of a matrix: by what factor its powers grow in the long run.
template <class Matrix>
Real spectral_radius(Matrix power)
{
    // The size of its 2⁶⁰th power, to the power of 2⁻⁶⁰.
    Real logarithm = 0, exponent = 1;
    for (int k = 0; k < 60; ++k) {
        Real size = power.norm();
        // the squares of its numbers overflow, or vanish
        if (!(size > 0 && std::isfinite(size))) size = power.stableNorm();
        if (!(size > 0)) return size;  // zero, or not a number
        logarithm += log(size) * exponent;
        power = ((power / size) * (power / size)).eval();
        exponent /= 2;
    }
    return exp(logarithm);
}

/// The largest |z| of (8.18): by what factor such a mode grows or shrinks in a
/// step, in the long run.
/// \param gamma  \f$\gamma = \rho^k\f$, what the sweeps of a step leave of an
///               error, 0 … 1
/// \param share  σ, of the previous impulses; 0 = cold
/// \param beta   Baumgarte's β; 0 = an error of position is left alone, or repaid
///               outside of the velocities. Then (8.18) has a factor z − 1, the
///               error that stays; the two other roots are meant
Real step_rate(Real gamma, Real share, Real beta);

//! [settles]
/// (8.14): do steps that start from all of the remembered impulses settle? b = 0,
/// and rows that stay and push or pull.
/// \param gamma  an eigenvalue of Gᵏ, what the sweeps of a step leave of an error
inline bool memory_settles(std::complex<Real> gamma)
{
    const Real size = std::abs(gamma);
    return 2 * size * std::abs(Real{1} - gamma) < 1 - size * size;
}

/// What (8.6) does to the largest error in a step, in the long run. No mode is
/// needed.
/// \param G  m×m: what the sweeps of a step leave of the error of λ
inline Real memory_rate(const MatX& G)
{
    const Index m = G.rows();
    MatX companion = MatX::Zero(2 * m, 2 * m);
    companion.topLeftCorner(m, m) = 2 * G;
    companion.topRightCorner(m, m) = -G;
    companion.bottomLeftCorner(m, m).setIdentity();
    return spectral_radius(companion);
}
//! [settles]

/// (8.9): the least number of sweeps a step with which the previous impulses and Baumgarte's β do not build each
/// other up, for rows on which one sweep multiplies the error by `rate`.
inline int least_stable_sweeps(Real rate, Real share, Real beta)
{
    const Real sweeps = log(share * (1 + beta)) / -log(rate);
    return sweeps < 0 ? 0 : static_cast<int>(std::floor(sweeps)) + 1;
}

}  // namespace rigid
