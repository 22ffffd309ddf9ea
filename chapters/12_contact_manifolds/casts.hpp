/// \file casts.hpp
/// Questions to a scene: what is at a point, and what does a ray meet first?
///
/// A point is a disc without a radius, so collide() answers the first. A ray enters a polygon with a radius through an edge
/// that is moved out by the radius, or through a circle about a vertex:
///
///     edge    n·(o + s d − v) = ρ,  n·d < 0,  its ends on both sides of the ray      circle  ‖o + s d − v‖ = ρ, the smaller s
///
/// The circle's distance from the ray is β = (o − v) × d/‖d‖, and √(ρ² − β²) before its middle the ray enters. A difference of
/// the squares of long ways would not be as good: with o a thousand kilometres away it is off by a millimetre. All of these circles and edges are inside the shape or on its outline, so the smallest s is where the ray enters.
#pragma once

#include "chapters/12_contact_manifolds/box_tree.hpp"
#include "chapters/12_contact_manifolds/manifold.hpp"

namespace rigid {

/// The points o + s d, 0 ≤ s ≤ 1.
struct Ray {
    Vec2 from = {0, 0};  ///< o [m]
    Vec2 way = {1, 0};   ///< d [m]
};

struct RayHit {
    bool hit = false;
    Real part = 1;         ///< s
    Vec2 normal = {0, 0};  ///< outward; zero if the ray starts inside
    int body = -1;
};

/// The distance of a point from a shape [m]; negative inside, minus the least way out.
inline Real distance_to(const Placed& shape, const Vec2& point)
{
    const Placed dot{{&point, 1}, {}, 0};
    return collide(shape, dot).points[0].gap;
}

//! [cast]
/// Where a ray enters a shape; at once if it starts inside.
inline RayHit cast(const Ray& ray, const Placed& shape)
{
    RayHit first;
    if (distance_to(shape, ray.from) <= 0) {
        first.hit = true, first.part = 0;
        return first;
    }
    const auto enter = [&](Real s, const Vec2& normal) {
        if (s >= 0 && s <= first.part && (!first.hit || s < first.part))
            first.hit = true, first.part = s, first.normal = normal;
    };
    const Real rho = shape.radius, d2 = ray.way.squaredNorm(),
               length = std::sqrt(d2);
    const Vec2 along = length > 0 ? Vec2(ray.way / length) : Vec2(0, 0);
    for (int i = 0; i < shape.edges(); ++i) {
        const Vec2 &n = shape.normal(i), &v = shape.vertex(i);
        const Real closing = -n.dot(ray.way);
        if (!(closing > 0)) continue;
        // a corner is on one side of the ray for both of its edges: a ray through
        // it meets one of them, whatever rounding says
        const auto side = [&](const Vec2& corner) {
            return cross2(ray.way, Vec2(corner + rho * n - ray.from));
        };
        if (side(v) * side(shape.vertex(shape.next(i))) > 0) continue;
        enter((n.dot(ray.from - v) - rho) / closing, n);
    }
    for (int i = 0; i < shape.size() && rho > 0; ++i) {
        // ‖r + s d‖ = ρ with r = o − v
        const Vec2 r = ray.from - shape.vertex(i);
        const Real half = r.dot(ray.way), beta = cross2(along, r);
        if (!(std::abs(beta) <= rho) || !(half < 0)) continue;
        const Real before = std::sqrt((rho - beta) * (rho + beta));
        enter(-half / d2 - before / length,
              Vec2((beta * perpendicular(along) - before * along) / rho));
    }
    return first;
}
//! [cast]

/// Whether the ray, as far as s = `part`, meets a box.
inline bool meets(const Ray& ray, Real part, const Box& box)
{
    Real from = 0, to = part;
    for (Index i = 0; i < 2; ++i) {
        const Real a = box.low[i] - ray.from[i], b = box.high[i] - ray.from[i];
        if (ray.way[i] == 0) {
            if (a > 0 || b < 0) return false;
            continue;
        }
        const Real s = a / ray.way[i], t = b / ray.way[i];
        from = std::max(from, std::min(s, t));
        to = std::min(to, std::max(s, t));
    }
    return from <= to * (1 + 1e-12) + 1e-300;
}

//! [first_hit]
/// What a ray meets first in a scene whose boxes are in a tree. Of two at the same
/// place the lower number.
inline RayHit first_hit(const Ray& ray, const BoxTree& tree,
                        const PlacedShapes& placed)
{
    RayHit first;
    tree.search([&](const Box& box) { return meets(ray, first.part, box); },
                [&](int k) {
                    RayHit hit = cast(ray, placed.of(k));
                    hit.body = k;
                    if (hit.hit && (!first.hit || hit.part < first.part ||
                                    (hit.part == first.part && k < first.body)))
                        first = hit;
                });
    return first;
}

/// Calls visit(k) for each body that contains the point.
template <class Visit>
void bodies_at(const Vec2& point, const BoxTree& tree, const PlacedShapes& placed,
               const Visit& visit)
{
    tree.overlapping({point, point}, [&](int k) {
        if (distance_to(placed.of(k), point) <= 0) visit(k);
    });
}
//! [first_hit]

}  // namespace rigid
