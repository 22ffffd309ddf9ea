/// \file shapes_by_force.hpp
/// The signed distance of two convex polygons with radii by their Minkowski difference, and random pairs of them.
///
/// The difference B − A is the hull of all w_j − v_i. Its distance from the origin is that of the polygons; inside, minus
/// the distance to its outline. Nothing of the book is used but Polygon.
#pragma once

#include "chapters/11_rotation/polygon.hpp"
#include "common/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rigid::by_force {

struct Pair {
    Polygon a, b;
    Vec<3> at_a, at_b;
};

inline Polygon random_shape(Random& random)
{
    Polygon shape;
    const auto corners = 1 + random.index(8);
    const Real first = random.uniform(0, 2 * pi), size = random.uniform(0.2, 1),
               flat = random.uniform(0.05, 1);
    for (Index i = 0; i < corners; ++i) {  // on an ellipse, counterclockwise: convex
        const Real angle =
            first + 2 * pi * (static_cast<Real>(i) + random.uniform(0, 0.7)) / static_cast<Real>(corners);
        shape.vertices.push_back({size * std::cos(angle), size * flat * std::sin(angle)});
    }
    shape.radius = random.uniform() < 0.5 ? 0 : random.uniform(0, 0.3);
    return shape;
}

inline Pair random_pair(Random& random)
{
    Pair pair;
    pair.a = random_shape(random);
    pair.b = random_shape(random);
    for (Vec<3>* const at : {&pair.at_a, &pair.at_b})
        for (Index i = 0; i < 3; ++i) (*at)[i] = random.uniform(-1, 1) * (i == 2 ? 4 : 1);
    // One in four lies square to the other: parallel faces are the rule among boxes.
    if (random.uniform() < 0.25) pair.at_b[2] = pair.at_a[2] + pi / 2 * static_cast<Real>(random.index(4));
    return pair;
}

inline Vec2 place(const Vec2& r, const Vec<3>& at)
{
    return {at[0] + std::cos(at[2]) * r.x() - std::sin(at[2]) * r.y(),
            at[1] + std::sin(at[2]) * r.x() + std::cos(at[2]) * r.y()};
}

inline Real distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& p)
{
    const Vec2 e = b - a, d = p - a;
    const Real t = e.squaredNorm() > 0 ? std::clamp(d.dot(e) / e.squaredNorm(), Real{0}, Real{1}) : 0;
    return (d - t * e).norm();
}

/// The hull of points, counterclockwise, by Andrew's chains.
inline std::vector<Vec2> hull_of(std::vector<Vec2> points)
{
    std::sort(points.begin(), points.end(),
              [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    std::vector<Vec2> hull;
    for (const bool upper : {false, true}) {
        const std::size_t begin = hull.size();
        for (const Vec2& p : points) {
            while (hull.size() >= begin + 2 &&
                   cross2(hull.back() - hull[hull.size() - 2], p - hull[hull.size() - 2]) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
        static_cast<void>(upper);
    }
    if (hull.empty()) hull.push_back(points.front());
    return hull;
}

/// Distance of the surfaces; negative = the least way that parts them.
inline Real distance(const Pair& pair)
{
    std::vector<Vec2> differences;
    for (const Vec2& v : pair.a.vertices)
        for (const Vec2& w : pair.b.vertices)
            differences.push_back(place(w, pair.at_b) - place(v, pair.at_a));
    const std::vector<Vec2> hull = hull_of(differences);
    const std::size_t n = hull.size();
    bool inside = n > 2;
    Real nearest = infinity;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 &a = hull[i], &b = hull[(i + 1) % n];
        nearest = std::min(nearest, distance_to_segment(a, b, {0, 0}));
        inside = inside && cross2(b - a, -a) >= 0;
    }
    return (inside ? -nearest : nearest) - pair.a.radius - pair.b.radius;
}

}  // namespace rigid::by_force
