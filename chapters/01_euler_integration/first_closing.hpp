/// \file first_closing.hpp
/// The first place along a step where a gap closes, however soon it opens again.
///
///     g(s) = Σ b_i C(5,i) s^i (1 − s)^(5−i),   0 ≤ s ≤ 1
///
/// Along the polynomial of a step a gap that is linear in x has degree five: six values fix
/// it, and the signs of b_0 … b_5 bound the number of its zeros, (1.46c)
/// \cite lane1981. For a gap that is not linear in x, parts of the step are halved until such a
/// polynomial is close enough to it.
#pragma once

#include "common/math.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace rigid {

//! [bernstein]
/// (1.46b): b_0 … b_5 of the polynomial with the values g at s = 0, 1/5, … 1.
inline std::array<Real, 6> bernstein(const std::array<Real, 6>& g)
{
    return {g[0],
            (-154 * g[0] + 600 * g[1] - 600 * g[2] + 400 * g[3] - 150 * g[4] +
             24 * g[5]) /
                120,
            (269 * g[0] - 1450 * g[1] + 2950 * g[2] - 2300 * g[3] + 925 * g[4] -
             154 * g[5]) /
                240,
            (-154 * g[0] + 925 * g[1] - 2300 * g[2] + 2950 * g[3] - 1450 * g[4] +
             269 * g[5]) /
                240,
            (24 * g[0] - 150 * g[1] + 400 * g[2] - 600 * g[3] + 600 * g[4] -
             154 * g[5]) /
                120,
            g[5]};
}
//! [bernstein]

/// The weights of b_0 … b_5 in (1.46a) at s.
constexpr std::array<Real, 6> bernstein_weights(Real s)
{
    const Real t = 1 - s;
    return {t * t * t * t * t,      5 * s * t * t * t * t, 10 * s * s * t * t * t,
            10 * s * s * s * t * t, 5 * s * s * s * s * t, s * s * s * s * s};
}

/// A part of a step, in parts of the whole step.
struct ThetaRange {
    Real from, to;
};

//! [closing]
/// The first part of 0 ≤ θ ≤ 1 at whose beginning the gap is open (> 0), at whose end it
/// is not, and in which it closes once.
/// \param gap_at  the gap at θ
/// \throws std::invalid_argument  for a gap that is not finite
template <class GapAt>
std::optional<ThetaRange> first_closing(const GapAt& gap_at)
{
    // Parts smaller than these are taken as they look from their ends: of a gap that no
    // polynomial fits, and of two zeros that are one but for rounding.
    constexpr Real rough = 1e-6, smallest = 1e-15;
    constexpr std::array<Real, 3> between = {0.1, 0.5, 0.9};
    constexpr std::array<std::array<Real, 6>, 3> weights = {
        bernstein_weights(0.1), bernstein_weights(0.5), bernstein_weights(0.9)};
    std::array<ThetaRange, 64> left{
        {{0, 1}}};  // each halving leaves one part for later
    for (std::size_t n = 1; n > 0;) {
        const ThetaRange part = left[--n];
        const Real from = part.from, to = part.to;
        const auto gap_within = [&](Real s) {
            const Real gap = gap_at(from + s * (to - from));
            if (!std::isfinite(gap))
                throw std::invalid_argument("the gap is " + shortest(gap) +
                                            " on the way; it must be finite");
            return gap;
        };
        std::array<Real, 6> g;
        for (std::size_t i = 0; i < 6; ++i)
            g[i] = gap_within(static_cast<Real>(i) / 5);
        const std::array<Real, 6> b = bernstein(g);
        Real misfit = 0, largest = 0;
        for (std::size_t k = 0; k < between.size(); ++k) {
            Real value = 0;
            for (std::size_t i = 0; i < 6; ++i) value += weights[k][i] * b[i];
            misfit = std::max(misfit, std::abs(value - gap_within(between[k])));
        }
        for (const Real one : b) largest = std::max(largest, std::abs(one));

        // (1.46c): the changes of sign. The ends are the gap itself; of the others one
        // that may as well be zero has no sign.
        int changes = 0;
        bool is_open = g[0] > 0, clear = true;
        for (std::size_t i = 0; i < 6; ++i) {
            const bool has_sign = std::abs(b[i]) > 4 * misfit;
            clear = clear && has_sign;
            if ((has_sign || i == 5) && (b[i] > 0) != is_open) {
                is_open = !is_open;
                ++changes;
            }
        }
        const bool fits = clear || misfit <= 1e-12 * largest;
        if ((!fits && to - from > rough) || (changes > 1 && to - from > smallest)) {
            const Real middle = (from + to) / 2;
            left[n++] = {middle, to};
            left[n++] = {from, middle};
        } else if (g[0] > 0 && !(g[5] > 0)) {
            return ThetaRange{from, to};
        }
    }
    return std::nullopt;
}
//! [closing]

}  // namespace rigid
