/// \file rounded_outline.hpp
/// A polygon with a radius as a polygon without one, whose corners lie on its rim.
#pragma once

#include "common/elementary.hpp"
#include "common/math.hpp"

#include <vector>

namespace rigid {

/// The outline of a polygon with a radius: its edges moved out, and arcs of a radius at its vertices, of eight chords; a
/// disc has 32.
inline std::vector<Vec2> rounded_outline(const std::vector<Vec2>& corners,
                                         Real radius)
{
    std::vector<Vec2> outline;
    const std::size_t n = corners.size();
    for (int k = 0; n == 1 && k < 32; ++k)
        outline.push_back(
            corners[0] + radius * Vec2(cos(2 * pi * k / 32), sin(2 * pi * k / 32)));
    if (n == 1) return outline;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 in = corners[i] - corners[(i + n - 1) % n],
                   out = corners[(i + 1) % n] - corners[i];
        const Vec2 from = -perpendicular(in).normalized();
        Real turn = atan2(cross2(in, out), in.dot(out));
        if (turn <= 0) turn += 2 * pi;  // at the end of a capsule
        for (int k = 0; k <= 8; ++k) {
            const Real angle = turn * k / 8;
            outline.push_back(
                corners[i] +
                radius * (cos(angle) * from + sin(angle) * perpendicular(from)));
        }
    }
    return outline;
}

}  // namespace rigid
