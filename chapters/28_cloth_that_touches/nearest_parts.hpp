/// \file nearest_parts.hpp
/// The nearest points of a triangle and the origin, and of two edges, as weights of their corners.
#pragma once

#include "chapters/20_turning_in_space/rotation.hpp"

#include <algorithm>
#include <array>

namespace rigid {

/// The point of a triangle that is nearest to the origin: inside it, or on one of its
/// edges. Weights that are exactly zero say which.
inline std::array<Real, 3> nearest_of_triangle(const std::array<Vec3, 3>& y)
{
    const Vec3 u = y[1] - y[0], v = y[2] - y[0];
    const Real uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(),
               pu = -u.dot(y[0]), pv = -v.dot(y[0]);
    const Real G = uu * vv - uv * uv, s = vv * pu - uv * pv, t = uu * pv - uv * pu;
    if (s > 0 && t > 0 && s + t < G) return {(G - s - t) / G, s / G, t / G};
    std::array<Real, 3> best{1, 0, 0};
    Real least = infinity;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const Vec3 e = y[j] - y[i];
        const Real size = e.squaredNorm();
        const Real part =
            size > 0 ? std::clamp(-e.dot(y[i]) / size, Real{0}, Real{1}) : 0;
        const Real d = (y[i] + part * e).squaredNorm();
        if (!(d < least)) continue;
        least = d;
        best = {0, 0, 0};
        best[i] = 1 - part, best[j] = part;
    }
    return best;
}

/// Where the edges a + s u and b + t v, with s and t from 0 to 1, are nearest: (s, t).
inline std::array<Real, 2> nearest_of_edges(const Vec3& a, const Vec3& u,
                                            const Vec3& b, const Vec3& v)
{
    const Vec3 r = a - b;
    const Real uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v),
               ur = u.dot(r), vr = v.dot(r), G = uu * vv - uv * uv;
    const auto within = [](Real value) {
        return std::clamp(value, Real{0}, Real{1});
    };
    // edges side by side: any s will do, t follows it
    Real s = G > 1e-12 * uu * vv ? within((uv * vr - vv * ur) / G) : 0;
    const Real t = vv > 0 ? within((vr + s * uv) / vv) : 0;
    if (uu > 0) s = within((t * uv - ur) / uu);
    return {s, t};
}

}  // namespace rigid
