/// \file exact_tumbling.hpp
/// The closed form of a free body's spin, to measure the steps against.
///
///     I₁ < I₂ < I₃, ω₂ = 0 at t = 0, L² > 2 E I₂:   ω = (A cn τ, B sn τ, D dn τ)        (20.24)
///
/// with the Jacobi functions of chapter 1's arithmetic-geometric mean. Where L² < 2 E I₂ the first axis and the third
/// change places. \cite landau1976, §37
#pragma once

#include "chapters/01_euler_integration/exact.hpp"
#include "chapters/20_turning_in_space/rotation.hpp"
#include "common/elementary.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rigid {

/// sn, cn and dn of a finite u for the modulus k, 0 ≤ k ≤ 1; otherwise
/// std::invalid_argument. \cite abramowitz1964, §16.4; k = 1 is their limit.
Vec3 jacobi_functions(Real u, Real k);

//! [exact]
/// What the energy and the length of the angular momentum say of a free spin; the
/// middle axis is the second.
struct SpinForm {
    bool swapped;       ///< L² < 2 E I₂: the third axis stands for the first
    Real I1, I2, I3;    ///< [kg m²]
    Real upper, lower;  ///< 2 E I₃ − L², L² − 2 E I₁
    Real k, rate;       ///< modulus, and dτ/dt [1/s]
    Real k_rest;        ///< √(1 − k²), 0 where L² = 2 E I₂ but for rounding
};

/// \param inertia  I₁ < I₂ < I₃ [kg m²]
/// \param omega    [rad/s]; the moments and its length from 1e-50 to 1e50, otherwise
///                 std::invalid_argument
SpinForm spin_form(const Vec3& inertia, const Vec3& omega);

/// (20.24): ω at the time t in the body's axes, of a body that starts with
/// ω = (ω₁, 0, ω₃), both positive, t finite; otherwise std::invalid_argument.
inline Vec3 exact_spin(const Vec3& inertia, Real omega1, Real omega3, Real t)
{
    if (!(omega1 > 0 && omega3 > 0))
        throw std::invalid_argument("a spin starts with " + shortest(omega1) +
                                    " and " + shortest(omega3) +
                                    " rad/s about its outer axes; both must be "
                                    "positive");
    const SpinForm s = spin_form(inertia, {omega1, 0, omega3});
    const Vec3 f = jacobi_functions(s.rate * t, s.k);
    Vec3 omega(std::sqrt(s.upper / (s.I1 * (s.I3 - s.I1))) * f[1],
               std::sqrt(s.upper / (s.I2 * (s.I3 - s.I2))) * f[0],
               std::sqrt(s.lower / (s.I3 * (s.I3 - s.I1))) * f[2]);
    if (s.swapped) std::swap(omega[0], omega[2]);
    return omega;
}

/// The time after which ω is what it was, 4 K(k) / rate [s]; half of it from one
/// flip to the next. Infinite where L² = 2 E I₂, but for rounding: such a spin goes to
/// the middle axis and stays.
Real spin_period(const Vec3& inertia, const Vec3& omega);
//! [exact]

}  // namespace rigid
