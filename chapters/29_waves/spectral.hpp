/// \file spectral.hpp
/// A string as a sum of sines, each of which is one mass on a spring: what it does in any time is known.
///
///     y_i = (2/N) Σ_k a_k sin(π i k / N),   a_k = Σ_i y_i sin(π i k / N)
///     a ← a cos ωt + (b/ω) sin ωt,   b ← b cos ωt − a ω sin ωt           (29.19), b of the velocities
///
/// The sums are taken by the fast Fourier transform in N log N operations.
#pragma once

#include "chapters/29_waves/wave_line.hpp"

#include <complex>
#include <vector>

namespace rigid {

/// Sums of sines over N intervals whose ends are zero.
class SineTransform {
public:
    /// Throws std::invalid_argument unless N is a power of two, two or more.
    explicit SineTransform(Index intervals);

    /// a_k = Σ_i y_i sin(π i k / N), in place; twice gives N/2 times what was there. N + 1 numbers, the ends become zero.
    /// Throws std::invalid_argument for another number of them.
    void apply(VecX& values);

    Index intervals() const { return N_; }

private:
    Index N_;
    std::vector<std::complex<Real>> roots_, work_;  ///< of 2N
};

/// What spectral steps of one length keep: a rotation for each sine.
class SpectralStep {
public:
    enum class Of {
        equation,  ///< ω = c k: exact for the wave equation
        masses,    ///< ω = (2c/Δx) sin(kΔx/2): exact for the masses
    };
    /// Throws std::invalid_argument for a step that is not positive, ends that are not fixed, damping, or a number of
    /// intervals that is no power of two.
    SpectralStep(const WaveLine& line, Real h, Of of);

    /// h later; places and velocities are of one time. Throws std::invalid_argument for a string of other intervals, speed,
    /// ends or damping than it was made for.
    void step(WaveLine& line);

private:
    SineTransform transform_;
    Real c_, dx_;  ///< of the string
    VecX cosine_, sine_, omega_;
};

}  // namespace rigid
