/// \file wave_line.hpp
/// A string: equal masses in a row, each pulled by its two neighbours alone.
///
///     m dv_i/dt = (T/Δx) (y_{i−1} − 2 y_i + y_{i+1}),   m = ρ Δx      →      ∂²y/∂t² = c² ∂²y/∂x²,   c² = T/ρ
///
/// Leapfrog takes it by the two lines of chapter 1, (29.4); the trapezoidal rule and all between it and implicit Euler solve
/// a tridiagonal system, (29.9). What either does to a wave of the length 2π/k is known in closed form:
///
///     sin(ω h / 2) = C sin(k Δx / 2)  leapfrog,    tan(ω h / 2) = C sin(k Δx / 2)  trapezoidal,    C = c h / Δx
///
/// \cite courant1928
#pragma once

#include "common/bodies.hpp"
#include "common/elementary.hpp"

namespace rigid {

/// What is at an end of a string. A free end is a ring on a rod: half a mass that only one neighbour pulls.
enum class LineEnd {
    fixed,
    free,
    open,  ///< a ring with a damper of the string's own impedance √(Tρ)
};

/// A string whose tension and mass per length are 1: what is said of it per ρ.
struct WaveLine {
    Real c = 1;    ///< speed of waves [m/s]
    Real dx = 1;   ///< distance of neighbours [m]
    VecX y;        ///< out of rest, N + 1 numbers: also of the two ends [m]
    VecX v;        ///< velocity [m/s]; of leapfrog: half a step before y
    VecX damping;  ///< of each mass [1/s]: a sponge, see add_sponge()
    LineEnd left = LineEnd::fixed, right = LineEnd::fixed;

    /// N + 1 points at rest on a length.
    /// Throws std::invalid_argument for fewer than two intervals, or a length or speed that is not positive.
    WaveLine(Index intervals, Real length, Real speed);

    Index intervals() const { return y.size() - 1; }
    Real length() const { return dx * static_cast<Real>(intervals()); }
};

/// Throws std::invalid_argument, naming the entry, unless all is finite, there are two intervals or more, sizes fit and no
/// damping is negative.
void require_valid(const WaveLine& line);

/// C = c h / Δx.
inline Real courant_number(const WaveLine& line, Real h)
{
    return line.c * h / line.dx;
}

//! [acceleration]
/// (29.2): the acceleration of mass i by its neighbours [m/s²].
inline Real acceleration(const WaveLine& line, const VecX& y, Index i)
{
    const Real k = line.c * line.c / (line.dx * line.dx);
    if (i == 0) return 2 * k * (y[1] - y[0]);
    if (i == line.intervals()) return 2 * k * (y[i - 1] - y[i]);
    return k * ((y[i - 1] - y[i]) + (y[i + 1] - y[i]));
}
//! [acceleration]

/// Velocities of now become those of half a step ago, which leapfrog begins with: v ← v − (h/2) a.
/// Throws std::invalid_argument for a string that is not valid; steps look at its sizes and constants alone.
void start_leapfrog(WaveLine& line, Real h);

/// (29.4): one step of leapfrog. Throws std::invalid_argument for a step beyond C = 1, where it is not stable.
void leapfrog(WaveLine& line, Real h);

/// (29.8): what leapfrog keeps to rounding, per mass of a length, where no damper is [J m/kg]. It is between the last two
/// places, so it takes the step that was made last.
Real leapfrog_energy(const WaveLine& line, Real h);

/// Kinetic and potential energy of places and velocities of one time [J m/kg].
Real wave_energy(const WaveLine& line);

/// What the implicit step keeps from call to call.
struct ThetaMemory {
    VecX diagonal, right;
};

/// (29.9): forces and velocities are taken at the part θ of the step: ½ is the trapezoidal rule, 1 implicit Euler.
/// Places and velocities are of one time.
/// Throws std::invalid_argument for a θ that is not from ½ to 1, and for a step that is not positive.
void theta_step(WaveLine& line, Real h, Real theta, ThetaMemory& memory);

/// Damping that grows as the square of the way into the last points at the ends that are given, to `most` [1/s].
void add_sponge(WaveLine& line, Index points, Real most, bool at_left,
                bool at_right);

/// The angular frequency [rad/s] of a wave of wave number k [rad/m] on masses in exact time, (29.7), …
inline Real masses_frequency(Real k, Real c, Real dx)
{
    return 2 * c / dx * sin(k * dx / 2);
}

/// … under leapfrog, (29.5); NaN where it is not stable, …
inline Real leapfrog_frequency(Real k, Real c, Real dx, Real h)
{
    return 2 / h * asin(c * h / dx * sin(k * dx / 2));
}

/// … and under the trapezoidal rule, (29.10).
inline Real trapezoidal_frequency(Real k, Real c, Real dx, Real h)
{
    return 2 / h * atan(c * h / dx * sin(k * dx / 2));
}

/// The part of the amplitude of a wave that comes back from an open end under leapfrog, (29.20); 0 at C = 1.
inline Real open_end_reflection(Real k, Real c, Real dx, Real h)
{
    const Real C = c * h / dx, a = leapfrog_frequency(k, c, dx, h) * h;
    const Real in = C * sin(k * dx), out = sin(a);
    return std::abs((in - out) / (in + out));
}

}  // namespace rigid
