/// \file casts.hpp
/// Questions to a scene: what is at a point, and what does a ray meet first?
///
/// A point is a disc without a radius, so collide() answers the first. A ray enters a polygon with a radius through an edge
/// that is moved out by the radius, or through a circle about a vertex:
///
///     edge    n·(o + s d − v) = ρ,  n·d < 0,  its ends on both sides of the ray      circle  ‖o + s d − v‖ = ρ, the smaller s
///
/// The circle's distance from the ray is β = (o − v) × d/‖d‖, and √(ρ² − β²) before its middle the ray enters. A difference of
/// the squares of long ways would not be as good: with o a thousand kilometres away it is off by tenths of a millimetre.
/// All of these circles and edges are inside the shape or on its outline, so the smallest s is where the ray enters.
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
/// A point that is not finite is infinitely far away.
inline Real distance_to(const Placed& shape, const Vec2& point)
{
    const Placed dot{{&point, 1}, {}, 0};
    return collide(shape, dot).deepest();
}

/// Where a ray enters a shape; at once if it starts inside.
/// \throws std::invalid_argument  for a ray that is not finite, or goes beyond 1e75 m
RayHit cast(const Ray& ray, const Placed& shape);

/// Whether the ray, as far as s = `part`, meets a box.
bool meets(const Ray& ray, Real part, const Box& box);

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
