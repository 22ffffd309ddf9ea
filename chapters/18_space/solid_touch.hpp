/// \file solid_touch.hpp
/// Where two convex solids touch: one function for balls, capsules, boxes and all other hulls.
///
///     1  the best face of either, and the best direction across two edges, (18.31); farther apart than the reach: none
///     2  cores apart: their nearest points, (18.29)
///     3  n: the normal of the face, unless 1 or 2 has a direction that parts them by more than `slack` more
///     4  on a face: clip the other's face that faces it most, (18.33); along two edges that are parallel: clip these
///     5  else one point
///     6  keep four
#pragma once

#include "chapters/18_space/face_clipping.hpp"
#include "chapters/18_space/gjk.hpp"
#include "chapters/18_space/separating_axes.hpp"

namespace rigid {

/// How far collide() looks, and what it takes for the same.
struct TouchSettings {
    Real margin = infinity;  ///< points with a gap below this [m]
    Real slack = 0;          ///< what differs by less is the same [m]
};

/// The points of the clipped polygon that are near enough, on the plane through `on` across n and above it.
inline void measure_points(const Vec3& on, const Vec3& n, Whose reference,
                           Real radii, Real margin, ClipRoom& room)
{
    room.points.clear();
    for (const ClipCorner& c : room.polygon) {
        const Real height = n.dot(c.at - on), gap = height - radii;
        const auto same = [&c](const TouchPoint& p) { return p.feature == c.name; };
        if (!(gap < margin) ||
            std::any_of(room.points.begin(), room.points.end(), same))
            continue;
        const Vec3 foot = c.at - height * n;
        if (reference == Whose::b) room.points.push_back({c.at, foot, gap, c.name});
        else room.points.push_back({foot, c.at, gap, c.name});
    }
}

//! [incident]
/// The polygon to be clipped: the face of q that faces n most, or what q has
/// instead, an edge or a corner.
inline void take_incident(const PlacedSolid& q, const Vec3& n, Whose q_is,
                          const TouchNames& names, ClipRoom& room)
{
    room.polygon.clear();
    if (!q.has_faces()) {
        for (std::size_t i = 0; i < q.vertices.size(); ++i)
            room.polygon.push_back(
                {q.vertices[i], names.corner(q_is, static_cast<int>(i)), 0});
        return;
    }
    std::size_t face = 0;
    for (std::size_t f = 1; f < q.normals.size(); ++f)
        if (q.normals[f].dot(n) < q.normals[face].dot(n)) face = f;
    const std::vector<int>& corners = q.form->hull.faces[face];
    for (std::size_t k = 0; k < corners.size(); ++k)
        room.polygon.push_back({q.corner(corners[k]),
                                names.corner(q_is, corners[k]),
                                q.form->face_edges[face][k]});
}
//! [incident]

//! [on_face]
/// Step 4 on a face: the incident polygon over the reference face.
inline void touch_on_face(const PlacedSolid& a, const PlacedSolid& b,
                          const Axis& axis, const TouchSettings& how,
                          ClipRoom& room, Touch& touch)
{
    const bool of_b = axis.whose == Whose::b;
    const PlacedSolid &p = of_b ? b : a, &q = of_b ? a : b;
    const auto face = static_cast<std::size_t>(axis.face);
    const Vec3& n = p.normals[face];
    const TouchNames names(*a.form, *b.form);
    take_incident(q, n, of_b ? Whose::a : Whose::b, names, room);
    const std::vector<int>& corners = p.form->hull.faces[face];
    const std::vector<int>& edges = p.form->face_edges[face];
    const std::size_t sides = corners.size();
    for (std::size_t k = 0; k < sides; ++k) {
        const int start = corners[k], end = corners[(k + 1) % sides];
        const Vec3 way = p.corner(end) - p.corner(start);
        const ClipSide side{p.corner(start), cross(way, n) / way.norm(),
                            edges[k],        edges[(k + sides - 1) % sides],
                            start,           end};
        cut(
            side, how.slack,
            [&](int of_p, int of_q) {
                return of_b ? names.crossing(of_q, of_p)
                            : names.crossing(of_p, of_q);
            },
            [&](int i) { return names.corner(axis.whose, i); }, room);
    }
    measure_points(p.corner(corners[0]), n, axis.whose, a.radius() + b.radius(),
                   how.margin, room);
    touch.normal = axis.normal;
    keep_four(room.points, how.slack, touch);
}
//! [on_face]

/// The edge of a solid that lies farthest along n; −1: it has none.
inline int edge_towards(const PlacedSolid& p, const Vec3& n)
{
    int best = -1;
    Real highest = -infinity;
    for (std::size_t e = 0; e < p.form->edges.size(); ++e) {
        const SolidEdge& edge = p.form->edges[e];
        const Real height = n.dot(p.corner(edge.from) + p.corner(edge.to));
        if (height > highest) highest = height, best = static_cast<int>(e);
    }
    return best;
}

//! [along_edges]
/// Step 4 along edges: what of b's edge lies beside a's, where they are parallel.
/// \return  whether there is any of it
inline bool touch_along_edges(const PlacedSolid& a, const PlacedSolid& b,
                              int edge_a, int edge_b, const TouchSettings& how,
                              ClipRoom& room, Touch& touch)
{
    const SolidEdge &ea = a.edge(edge_a), &eb = b.edge(edge_b);
    const Vec3 from = a.corner(ea.from), way = a.corner(ea.to) - from;
    const Vec3 way_b = b.corner(eb.to) - b.corner(eb.from);
    // a sine of 1/20, three degrees: beyond that they cross in one point
    if (cross(way, way_b).squaredNorm() >
        0.0025 * way.squaredNorm() * way_b.squaredNorm())
        return false;
    const TouchNames names(*a.form, *b.form);
    room.polygon.clear();
    for (const int i : {eb.from, eb.to})
        room.polygon.push_back({b.corner(i), names.corner(Whose::b, i), edge_b});
    for (const int i : {ea.from, ea.to}) {
        const Vec3 out = i == ea.to ? way : Vec3(-way);
        const ClipSide side{a.corner(i), out / way.norm(), -1, -1, i, i};
        cut(
            side, how.slack, [](int, int) { return 0; },
            [&](int corner) { return names.corner(Whose::a, corner); }, room);
    }
    measure_points(from, touch.normal, Whose::a, a.radius() + b.radius(),
                   how.margin, room);
    keep_four(room.points, how.slack, touch);
    return touch.count > 0;
}
//! [along_edges]

/// The point of the line through q with the direction d that is nearest to the line through p with the direction c.
inline Vec3 nearest_on_line(const Vec3& q, const Vec3& d, const Vec3& p,
                            const Vec3& c)
{
    const Vec3 n = cross(c, cross(d, c));  // across c, in the plane of both
    return q + n.dot(p - q) / n.dot(d) * d;
}

//! [collide]
/// Where two solids touch. For b and a it is the same with the normal the other way
/// round, to within how.slack.
inline void collide(const PlacedSolid& a, const PlacedSolid& b,
                    const TouchSettings& how, ClipRoom& room, Touch& touch)
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
    // so near that the difference of two points has no direction any more
    const Real nothing = 1e-10 * (a.form->reach + b.form->reach);
    const bool apart = near.distance > nothing;
    if (apart) other = {(near.on_b - near.on_a) / near.distance, near.distance};
    else if (!has_faces && other.separation == -infinity)  // any will part them
        other = {across(a.directions.empty() ? b.directions : a.directions), 0};
    // 3, 4
    if (face.face >= 0 && face.separation + how.slack >= other.separation) {
        touch_on_face(a, b, face, how, room, touch);
        if (touch.count > 0) return;
        if (other.separation == -infinity) other = face;
    }
    const Vec3& n = touch.normal = other.normal;
    const int ea = edge_towards(a, n), eb = edge_towards(b, -n);
    if (ea >= 0 && eb >= 0 && touch_along_edges(a, b, ea, eb, how, room, touch))
        return;
    // 5
    Vec3 on_b = apart || !has_faces ? near.on_b : b.corner(b.support(-n));
    if (!apart && ea >= 0 && eb >= 0) {
        const SolidEdge &edge_a = a.edge(ea), &edge_b = b.edge(eb);
        on_b = nearest_on_line(
            b.corner(edge_b.from), b.corner(edge_b.to) - b.corner(edge_b.from),
            a.corner(edge_a.from), a.corner(edge_a.to) - a.corner(edge_a.from));
    }
    const Real gap = other.separation - radii;
    if (!(gap < how.margin)) return;
    touch.count = 1;
    touch.points[0] = {on_b - other.separation * n, on_b, gap,
                       TouchNames(*a.form, *b.form).single()};
}
//! [collide]

}  // namespace rigid
