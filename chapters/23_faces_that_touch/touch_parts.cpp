// The functions of touch_parts.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/23_faces_that_touch/touch_parts.hpp"

namespace rigid {

void add_point(const TouchPoint& point, ClipRoom& room)
{
    const auto same = [&point](const TouchPoint& p) {
        return p.feature == point.feature;
    };
    if (std::none_of(room.points.begin(), room.points.end(), same))
        room.points.push_back(point);
}

//! [incident]
void take_incident(const PlacedSolid& q, const Vec3& n, Whose q_is,
                   const TouchNames& names, ClipRoom& room)
{
    room.polygon.clear();
    if (!q.has_faces()) {
        for (std::size_t i = 0; i < q.vertices.size(); ++i)
            room.polygon.push_back(
                {q.vertices[i], names.corner(q_is, static_cast<int>(i)), 0});
        return;
    }
    const int lowest = q.support(-n);
    std::size_t face = q.normals.size();
    for (std::size_t f = 0; f < q.normals.size(); ++f) {
        const std::vector<int>& corners = q.form->hull.faces[f];
        if (std::find(corners.begin(), corners.end(), lowest) != corners.end() &&
            (face == q.normals.size() ||
             q.normals[f].dot(n) < q.normals[face].dot(n)))
            face = f;
    }
    const std::vector<int>& corners = q.form->hull.faces[face];
    for (std::size_t k = 0; k < corners.size(); ++k)
        room.polygon.push_back({q.corner(corners[k]),
                                names.corner(q_is, corners[k]),
                                q.form->face_edges[face][k]});
}
//! [incident]

//! [on_face]
void touch_on_face(const PlacedSolid& a, const PlacedSolid& b, const Axis& axis,
                   const TouchSettings& how, ClipRoom& room, SolidTouch& touch)
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
    room.points.clear();
    const Real radii = a.radius() + b.radius();
    for (const ClipCorner& c : room.polygon) {
        const Real height = n.dot(c.at - p.corner(corners[0]));
        if (!(height - radii < how.margin)) continue;
        const Vec3 foot = c.at - height * n;
        add_point({of_b ? c.at : foot, of_b ? foot : c.at, height - radii, c.name},
                  room);
    }
    touch.normal = axis.normal;
    keep_four(room.points, how.slack, touch);
}
//! [on_face]

int edge_towards(const PlacedSolid& p, const Vec3& n)
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
void touch_along_edges(const PlacedSolid& a, const PlacedSolid& b, int edge_a,
                       int edge_b, const TouchSettings& how, ClipRoom& room,
                       SolidTouch& touch)
{
    const SolidEdge &ea = a.edge(edge_a), &eb = b.edge(edge_b);
    const Vec3 from = a.corner(ea.from), way = a.corner(ea.to) - from;
    const Vec3 way_b = b.corner(eb.to) - b.corner(eb.from);
    const Vec3& n = touch.normal;
    // a sine of 1/20, three degrees: beyond that they cross in one point, or the
    // nearest points are ends
    const Real length2 = way.squaredNorm(), few = 0.0025;
    if (cross(way, way_b).squaredNorm() > few * length2 * way_b.squaredNorm() ||
        n.dot(way) * n.dot(way) > few * length2)
        return;
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
    room.points.clear();
    const Real radii = a.radius() + b.radius();
    for (const ClipCorner& c : room.polygon) {
        const Vec3 beside = from + way.dot(c.at - from) / length2 * way;
        const Real height = n.dot(c.at - beside);
        if (height - radii < how.margin)
            add_point({c.at - height * n, c.at, height - radii, c.name}, room);
    }
    keep_four(room.points, how.slack, touch);
}
//! [along_edges]

}  // namespace rigid
