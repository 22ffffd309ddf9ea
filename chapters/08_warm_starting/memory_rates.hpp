/// \file memory_rates.hpp
/// What memory does to steps that make too few sweeps, in formulas: the theory lines of this chapter's plots.
///
/// A mode of the rows whose error k sweeps multiply by γ = ρᵏ obeys, from step to step,
///
///     z³ − (1 − β + γ (1 + σ + β)) z² + γ (1 + 2σ) z − γσ = 0        (8.10)
///
/// with Baumgarte's β and the share σ of yesterday's impulses. All its |z| are below 1 exactly if
///
///     σ γ (1 + β) < 1                                                 (8.11)
#pragma once

#include "common/math.hpp"

#include <cmath>

namespace rigid {

//! [step_rate]
/// The largest |z| of (8.10): by what factor such a mode grows or shrinks in a step, in the long run.
/// \param gamma  \f$\gamma = \rho^k\f$, what the sweeps of a step leave of an error, 0 … 1
/// \param share  σ, of yesterday's impulses; 0 = cold
/// \param beta   Baumgarte's β; 0 = an error of position is left alone, or repaid outside of the velocities.
///               Then (8.10) has a factor z − 1, the error that stays; the two other roots are meant
inline Real step_rate(Real gamma, Real share, Real beta)
{
    Eigen::Matrix<Real, 3, 3> power;  // of the matrix whose characteristic polynomial is (8.10)
    power << 1 - beta + gamma * (1 + share + beta), -gamma * (1 + 2 * share), gamma * share,  //
        1, 0, 0,                                                                              //
        0, 1, 0;
    if (beta == 0) power.row(0) << gamma * (1 + share), -gamma * share, 0;
    // The size of its 2⁶⁰th power, to the power of 2⁻⁶⁰, is the largest |z|.
    Real logarithm = 0, exponent = 1;
    for (int k = 0; k < 60; ++k) {
        const Real size = power.norm();
        if (!(size > 0)) return 0;
        logarithm += std::log(size) * exponent;
        power = ((power / size) * (power / size)).eval();
        exponent /= 2;
    }
    return std::exp(logarithm);
}
//! [step_rate]

/// (8.11): the least number of sweeps a step with which yesterday's impulses and Baumgarte's β do not build each
/// other up, for rows on which one sweep multiplies the error by `rate`.
inline int least_stable_sweeps(Real rate, Real share, Real beta)
{
    const Real sweeps = std::log(share * (1 + beta)) / -std::log(rate);
    return sweeps < 0 ? 0 : static_cast<int>(std::floor(sweeps)) + 1;
}

}  // namespace rigid
