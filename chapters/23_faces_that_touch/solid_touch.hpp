/// \file solid_touch.hpp
/// Where two convex solids touch: one function for balls, capsules, boxes and all other hulls.
///
///     1  the best face of either, and the best direction across two edges, (22.4); farther apart than the reach: none
///     2  cores apart: their nearest points, (22.1)
///     3  n: the normal of the face, unless 1 or 2 has a direction that parts them by more than `slack` more
///     4  on a face: clip the other's face over it, (23.1); along two edges that are parallel: clip these
///     5  else, or where the deepest point is not among these: one point
///     6  keep four
#pragma once

#include "chapters/22_distance_of_solids/gjk.hpp"
#include "chapters/23_faces_that_touch/touch_parts.hpp"

namespace rigid {

/// The point of b's edge that is nearest to the line of a's edge, which crosses it.
inline Vec3 crossing_point(const PlacedSolid& a, const PlacedSolid& b, int edge_a,
                           int edge_b)
{
    const Vec3 p = a.corner(a.edge(edge_a).from), q = b.corner(b.edge(edge_b).from);
    const Vec3 c = a.corner(a.edge(edge_a).to) - p,
               d = b.corner(b.edge(edge_b).to) - q;
    const Vec3 n = cross(c, cross(d, c));  // across c, in the plane of both
    const Real part = n.dot(d);
    return q +
           (part > 0 ? std::clamp(n.dot(p - q) / part, Real{0}, Real{1}) : 0) * d;
}

/// Where two solids touch. For b and a it is the same with the normal the other way
/// round, to within how.slack.
void collide(const PlacedSolid& a, const PlacedSolid& b, const TouchSettings& how,
             ClipRoom& room, SolidTouch& touch);

}  // namespace rigid
