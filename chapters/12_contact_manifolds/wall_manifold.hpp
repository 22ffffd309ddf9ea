/// \file wall_manifold.hpp
/// A convex shape on a half-space: its deepest vertex, and the deeper of the two beside it.
#pragma once

#include "chapters/12_contact_manifolds/clipping.hpp"
#include "common/shapes.hpp"

namespace rigid {

//! [wall]
/// Along the outline of a convex shape the height over a wall falls to its lowest
/// vertex and rises behind it, so the second lowest is beside the lowest. But of a
/// thin shape that lies the two ends are what it stands on, not the two corners of
/// one end (where a distance is asked for, with an infinite margin, the two
/// lowest).
/// \param margin  a vertex whose gap is not below it is left out [m] …
/// \param second  … unless the other's is below it, and its own below this [m]
/// \return        normal out of the wall; features are numbers of vertices
inline Manifold collide(const HalfSpace& wall, const Placed& shape, Real margin,
                        Real second = 0)
{
    Manifold m;
    m.normal = wall.normal;
    const auto height = [&](int i) {
        return wall.normal.dot(shape.vertex(i)) - wall.offset - shape.radius;
    };
    int lowest = 0;
    for (int i = 1; i < shape.size(); ++i)
        if (height(i) < height(lowest)) lowest = i;
    const int before = shape.before(lowest), next = shape.next(lowest);
    int other = height(before) < height(next) ? before : next;
    const int far = other == before ? next : before;
    const auto side2 = [&](int i) {
        return (shape.vertex(i) - shape.vertex(lowest)).squaredNorm();
    };
    const bool stands_on = height(far) < std::max(margin, second);
    if (margin < infinity && stands_on && 64 * side2(other) < side2(far))
        other = far;
    const auto add = [&](int i) {
        const Real gap = height(i);
        if (gap < std::max(margin, second))
            m.points[static_cast<std::size_t>(m.count++)] = {
                shape.vertex(i) - (shape.radius + gap / 2) * wall.normal, gap, i};
    };
    add(std::min(lowest, other));
    if (other != lowest) add(std::max(lowest, other));
    drop_far(margin, m);
    return m;
}
//! [wall]

}  // namespace rigid
