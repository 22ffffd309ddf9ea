/// \file peer_shapes.hpp
/// What another engine is told of a body: a ball, a box or a capsule along x, about its centroid and in its principal axes.
#pragma once

#include "chapters/25_world_in_space/space_scene.hpp"

namespace rigid {

struct SimpleSolid {
    enum Kind { ball, capsule, box } kind = box;
    Vec3 size = {0, 0, 0};  ///< edges of a box; the first: length of a capsule [m]
    Real radius = 0;        ///< [m]
};

/// Throws std::invalid_argument for another solid.
inline SimpleSolid simple_solid(const std::vector<Hull>& shape)
{
    if (shape.size() == 1) {
        const Hull& hull = shape[0];
        Vec3 low = hull.vertices[0], high = low, sum(0, 0, 0);
        for (const Vec3& p : hull.vertices)
            low = low.cwiseMin(p), high = high.cwiseMax(p), sum += p;
        const SimpleSolid solid{hull.vertices.size() == 1   ? SimpleSolid::ball
                                : hull.vertices.size() == 2 ? SimpleSolid::capsule
                                                            : SimpleSolid::box,
                                high - low, hull.radius};
        const bool in_axes =
            sum.norm() < 1e-9 && (solid.kind != SimpleSolid::capsule ||
                                  solid.size.tail<2>().norm() < 1e-9);
        if (in_axes &&
            (solid.kind != SimpleSolid::box || hull.vertices.size() == 8))
            return solid;
    }
    throw std::invalid_argument(
        "a body that other engines take is a ball, a box or a "
        "capsule along its first axis");
}

}  // namespace rigid
