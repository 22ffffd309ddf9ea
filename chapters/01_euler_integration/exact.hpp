/// \file exact.hpp
/// What is known exactly of the systems of this chapter: the truth that errors are measured
/// against.
#pragma once

#include "chapters/01_euler_integration/systems.hpp"
#include "common/elementary.hpp"
#include "common/text.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace rigid {

/// The state of a spring at time t, started from s at time 0.
inline State<1> exact_spring(const Spring& spring, const State<1>& s, Real t)
{
    const Real c = cos(spring.omega * t);
    const Real n = sin(spring.omega * t);
    return {c * s.x + n / spring.omega * s.u, c * s.u - spring.omega * n * s.x};
}

/// The arithmetic-geometric mean of 1 and b = cos α, and the numbers met on the way to it,
/// which the Jacobi functions of modulus k = sin α are made of. \cite abramowitz1964, §17.6
/// and §16.4
struct GeometricMean {
    std::array<Real, 12> a{}, c{};
    int last = 0;

    explicit GeometricMean(Real alpha)
    {
        a[0] = 1;
        c[0] = sin(alpha);
        Real b = cos(alpha);
        while (c[static_cast<std::size_t>(last)] > 1e-16 && last < 11) {
            const Real mean = a[static_cast<std::size_t>(last)];
            ++last;
            a[static_cast<std::size_t>(last)] = (mean + b) / 2;
            c[static_cast<std::size_t>(last)] = (mean - b) / 2;
            b = std::sqrt(mean * b);
        }
    }
    Real mean() const { return a[static_cast<std::size_t>(last)]; }
};

/// Period of a pendulum let go at rest from the angle theta0 [s]: 4 √(L/g) K(sin²(θ₀/2)).
inline Real pendulum_period(const Pendulum& pendulum, Real theta0)
{
    return 2 * pi * std::sqrt(pendulum.length / pendulum.g) /
           GeometricMean(theta0 / 2).mean();
}

/// The state at time t of a pendulum let go at rest from the angle theta0, 0 < theta0 < π:
///
///     sin(θ/2) = k cn(ω₀t) / dn(ω₀t),   k = sin(θ₀/2),   ω₀ = √(g/L)
inline State<1> exact_pendulum(const Pendulum& pendulum, Real theta0, Real t)
{
    const Real k = sin(theta0 / 2);
    const Real omega0 = std::sqrt(pendulum.g / pendulum.length);
    const GeometricMean steps(theta0 / 2);
    Real phase = std::ldexp(steps.mean() * omega0 * t, steps.last);
    for (int n = steps.last; n > 0; --n) {
        const auto i = static_cast<std::size_t>(n);
        phase = (phase + asin(steps.c[i] / steps.a[i] * sin(phase))) / 2;
    }
    const Real sn = sin(phase);
    const Real dn = std::sqrt(1 - k * k * sn * sn);
    const Real theta = 2 * asin(k * cos(phase) / dn);
    // From the derivative of cn/dn, −k'² sn/dn², and cos(θ/2) = k'/dn, with k' = cos(θ₀/2).
    return {Vec<1>(theta), Vec<1>(-2 * omega0 * k * cos(theta0 / 2) * sn / dn)};
}

/// A Kepler orbit at its point nearest to the sun, with semi-major axis 1 m.
/// \param e  eccentricity, 0 ≤ e < 1
inline State<2> kepler_perihelion(const Kepler& kepler, Real e)
{
    if (!(e >= 0 && e < 1))
        throw std::invalid_argument("the eccentricity is " + shortest(e) +
                                    "; it must be at least 0 and less than 1");
    return {Vec2(1 - e, 0), Vec2(0, std::sqrt(kepler.GM * (1 + e) / (1 - e)))};
}

/// The state a time t after that point. Newton's method solves Kepler's equation
///
///     E − e sin E = t √GM
inline State<2> exact_kepler(const Kepler& kepler, Real e, Real t)
{
    const Real n = std::sqrt(kepler.GM);  // mean motion for the semi-major axis 1 m
    const Real M = std::remainder(n * t, 2 * pi);
    // for this start Newton's method converges from one side
    Real E = M + (M < 0 ? -e : e);
    for (int i = 0; i < 100; ++i) {
        const Real change = (E - e * sin(E) - M) / (1 - e * cos(E));
        E -= change;
        if (std::abs(change) < 1e-15) break;
    }
    const Real minor = std::sqrt(1 - e * e);
    const Real E_dot = n / (1 - e * cos(E));
    return {Vec2(cos(E) - e, minor * sin(E)),
            Vec2(-sin(E) * E_dot, minor * cos(E) * E_dot)};
}

/// Time until a body thrown straight up at speed u0 ≥ 0 from height y0 ≥ 0 hits the ground
/// [s]. Without drag the root of a quadratic; with drag, from dy = u du / (−g ∓ k u²) up
/// and down:
///
///     t_up = atan(u₀ √(k/g)) / √(gk),   top = y₀ + ln(1 + k u₀²/g) / 2k,
///     t_down = acosh(exp(k top)) / √(gk)
inline Real exact_impact(const Projectile& projectile, Real y0, Real u0)
{
    const Real g = -projectile.gravity.y();
    const Real k = projectile.drag;
    if (k == 0) return (u0 + std::sqrt(u0 * u0 + 2 * g * y0)) / g;
    const Real rate = std::sqrt(g * k);
    const Real top = y0 + log1p(k * u0 * u0 / g) / (2 * k);
    // acosh(exp z) = log(exp z + √(exp 2z − 1)), written so that small z keep their digits.
    const Real grown = expm1(k * top);
    return (atan(u0 * std::sqrt(k / g)) +
            log1p(grown + std::sqrt(grown * (grown + 2)))) /
           rate;
}

}  // namespace rigid
