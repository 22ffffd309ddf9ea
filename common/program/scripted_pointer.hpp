/// \file scripted_pointer.hpp
/// The hand that steers a scene when there is no reader: a smooth path all over the picture.
///
///     pointer(t) = centre + 0.9 half_size · Σ_k a_k sin(2π f_k t + φ_k),   a = (0.55, 0.30, 0.15)
///
/// Frequencies and phases come from the seed. The frequencies (about one turn in 9, 5 and 3 seconds)
/// are spread by random factors, so that their ratios are no small fractions and the path does not
/// repeat itself. The amplitudes sum to one: it never leaves the inner nine tenths of the picture.
#pragma once

#include "common/canvas.hpp"
#include "common/elementary.hpp"
#include "common/random.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace rigid {

/// Depends on the seed and the time alone: the same run on every start.
class ScriptedPointer {
public:
    ScriptedPointer(std::uint64_t seed, const View& view) : view_(view)
    {
        Random random(seed);
        for (auto& axis : waves_)
            for (std::size_t k = 0; k < axis.size(); ++k)
                axis[k] = {amplitudes[k], random.uniform(0.85, 1.15) / periods[k], random.uniform(0, 2 * pi)};
    }

    /// Where it is at the time t [s], in world coordinates [m].
    Vec2 at(Real t) const
    {
        Vec2 p = view_.centre;
        for (Index axis = 0; axis < 2; ++axis)
            for (const Wave& wave : waves_[static_cast<std::size_t>(axis)])
                p[axis] += 0.9 * view_.half_size[axis] * wave.amplitude *
                           sin(2 * pi * wave.frequency * t + wave.phase);
        return p;
    }

private:
    struct Wave {
        Real amplitude = 0, frequency = 0, phase = 0;  ///< 1, Hz, rad
    };
    static constexpr std::array<Real, 3> amplitudes = {0.55, 0.30, 0.15};
    static constexpr std::array<Real, 3> periods = {9, 5, 3};  ///< [s]
    View view_;
    std::array<std::array<Wave, 3>, 2> waves_;
};

}  // namespace rigid
