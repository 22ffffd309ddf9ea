/// \file solid_touch.hpp
/// Where two convex solids touch: one function for balls, capsules, boxes and all other hulls.
///
///     1  the best face of either, and the best direction across two edges, (18.31); farther apart than the reach: none
///     2  cores apart: their nearest points, (18.29)
///     3  n: the normal of the face, unless 1 or 2 has a direction that parts them by more than `slack` more
///     4  on a face: clip the other's face over it, (18.33); along two edges that are parallel: clip these
///     5  else, or where the deepest point is not among these: one point
///     6  keep four
#pragma once

#include "chapters/18_space/gjk.hpp"
#include "chapters/18_space/touch_parts.hpp"

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

//! [collide]
/// Where two solids touch. For b and a it is the same with the normal the other way
/// round, to within how.slack.
inline void collide(const PlacedSolid& a, const PlacedSolid& b,
                    const TouchSettings& how, ClipRoom& room, SolidTouch& touch)
{
    touch.count = 0;
    const Real radii = a.radius() + b.radius(), reach = radii + how.margin;
    // 1
    const Axis face = best_face(a, b, how.slack);
    if (face.separation >= reach) return;
    Axis other = best_across_edges(a, b);
    if (other.separation >= reach) return;
    // 2: faces and edges of what has none don't say whether it is apart
    Nearest near;
    const bool has_faces = a.has_faces() || b.has_faces();
    if (!has_faces || std::max(face.separation, other.separation) > 0)
        near = nearest_points(a, b);
    if (near.distance >= reach) return;
    // the difference of two points that are nearer than this has no direction
    const bool apart = near.distance > 1e-7 * (a.form->reach + b.form->reach);
    if (apart) other = {(near.on_b - near.on_a).normalized(), near.distance};
    else if (!has_faces && other.separation == -infinity)  // any will part them
        other = {across(a.directions.empty() ? b.directions : a.directions), 0};
    const Real deepest =
        std::max(face.separation, other.separation) - radii + how.slack;
    // 3, 4
    if (face.face >= 0 && face.separation + how.slack >= other.separation) {
        touch_on_face(a, b, face, how, room, touch);
        if (reaches(touch, deepest)) return;
        if (!(other.separation + how.slack >= face.separation)) other = face;
    }
    const Vec3& n = touch.normal = other.normal;
    const int ea = edge_towards(a, n), eb = edge_towards(b, -n);
    const bool along_edges = other.face < 0 && ea >= 0 && eb >= 0;
    touch.count = 0;
    if (along_edges) touch_along_edges(a, b, ea, eb, how, room, touch);
    if (reaches(touch, deepest)) return;
    // 5
    Vec3 on_b = apart || !has_faces ? near.on_b : b.corner(b.support(-n));
    if (other.face >= 0 && other.whose == Whose::b)
        on_b = a.corner(a.support(n)) + other.separation * n;
    else if (along_edges && !apart) on_b = crossing_point(a, b, ea, eb);
    const Real gap = other.separation - radii;
    touch.count = gap < how.margin ? 1 : 0;
    touch.points[0] = {on_b - other.separation * n, on_b, gap,
                       TouchNames(*a.form, *b.form).single()};
}
//! [collide]

}  // namespace rigid
