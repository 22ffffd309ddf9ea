/// \file manifold.hpp
/// Where two convex shapes touch: one function for discs, capsules, boxes and all others.
///
///     1  the reference face: the largest separation (12.1) of the faces of both
///     2  the incident edge: of the two at the other shape's support vertex, the one that faces it more
///     3  two corners that are nearest to each other: n = (w − v)/‖w − v‖, else n = normal of the face      (12.2)
///     4  clip the two edges along n⊥ (12.3): at most two points, named by the vertex that ends the interval
///
/// The gap of the deepest point is the distance of the shapes; where the polygons overlap, minus the least way that parts them.
#pragma once

#include "chapters/12_contact_manifolds/clipping.hpp"
#include "chapters/12_contact_manifolds/separation.hpp"

namespace rigid {

/// What collide() may remember, and how far it looks.
struct ManifoldSettings {
    Real margin = infinity;  ///< points with a gap below this [m]
    /// what was stays until something else is better by more than this [m]
    Real stay = 0;
    const Manifold* before = nullptr;  ///< of these two shapes a step ago
    /// a point below the margin brings the other one, if its gap is below this [m]
    Real second = 0;
};

//! [incident]
/// Step 2: the edge of q at its vertex `support` that faces the normal n more.
inline int incident_edge(const Placed& q, int support, const Vec2& n)
{
    if (q.edges() == 0) return support;
    const int before = q.before(support);
    return n.dot(q.normal(before)) < n.dot(q.normal(support)) ? before : support;
}
//! [incident]

//! [corners]
/// Step 3: whether the nearest points are two corners: an end v of the reference
/// edge and an end w of the incident edge, which then become the first of theirs.
/// \param n           outward normal of the reference edge
/// \param separation  s of its face
inline bool nearest_are_corners(EdgeEnds& reference, EdgeEnds& incident,
                                const Vec2& n, Real separation)
{
    const Vec2 t = perpendicular(n), origin = reference.at[0];
    const Real length = t.dot(reference.at[1] - origin);
    const auto over = [&](std::size_t i) { return t.dot(incident.at[i] - origin); };
    const auto height = [&](std::size_t i) {
        return n.dot(incident.at[i] - origin);
    };
    const auto distance = [&](std::size_t i, std::size_t j) {
        return (incident.at[j] - reference.at[i]).squaredNorm();
    };
    const Real y0 = over(0), y1 = over(1);
    const bool left = std::max(y0, y1)<0, right = std::min(y0, y1)> length;
    std::size_t v = left ? 0 : 1, w = height(0) <= height(1) ? 0 : 1;
    if (left || right) {  // the edges lie beside each other
        const Real beside = left ? -std::max(y0, y1) : std::min(y0, y1) - length;
        // of polygons that overlap they do so by rounding alone
        if (beside <= -separation) return false;
        w = distance(v, 0) <= distance(v, 1) ? 0 : 1;
        // corners in one place have no direction
        if (distance(v, w) <= 1e-24 * length * length) return false;
    } else {  // over each other: only if the foot of v is not on the incident edge
        const Real y = w == 0 ? y0 : y1;
        v = y < 0 ? 0 : 1;
        if (!(separation > 0) || (y >= 0 && y <= length) ||
            !((reference.at[v] - incident.at[w])
                  .dot(incident.at[1 - w] - incident.at[w]) < 0))
            return false;
    }
    const auto put_first = [](EdgeEnds& edge, std::size_t i) {
        if (i == 0) return;
        std::swap(edge.at[0], edge.at[1]);
        std::swap(edge.vertex[0], edge.vertex[1]);
    };
    put_first(reference, v);
    put_first(incident, w);
    return true;
}
//! [corners]

//! [stay]
/// Where the polygons overlap, the reference face of the step before stays unless
/// another is better by more than how.stay: as long as it has the other's support
/// under it.
inline void stay_with_face(const Placed& a, const Placed& b,
                           const ManifoldSettings& how, Face& face)
{
    if (how.before == nullptr || how.before->face < 0 || face.separation > 0)
        return;
    Face old;
    old.of_b = how.before->face >= a.edges();
    old.edge = old.of_b ? how.before->face - a.edges() : how.before->face;
    const Placed &p = old.of_b ? b : a, &q = old.of_b ? a : b;
    if (old.edge >= p.edges()) return;
    old.separation = separation_of(p, old.edge, q, old.support);
    const Vec2 t = perpendicular(p.normal(old.edge));
    const Real y = t.dot(q.vertex(old.support) - p.vertex(old.edge));
    const bool under =
        y >= 0 && y <= t.dot(p.vertex(p.next(old.edge)) - p.vertex(old.edge));
    if (under && old.separation >= face.separation - how.stay) face = old;
}
//! [stay]

//! [in_line]
constexpr Real in_line = 1 - 1e-12;  ///< n·n of two edges in line, at least

/// Edges in line are equally good as faces, to rounding: of these the one that has
/// the other's support over it.
inline void find_under_support(const Placed& p, const Placed& q, Face& face)
{
    for (int i = 0; i < p.edges(); ++i) {
        const Vec2 n = p.normal(face.edge), t = perpendicular(n),
                   from = p.vertex(face.edge);
        const Real y = t.dot(q.vertex(face.support) - from),
                   length = t.dot(p.vertex(p.next(face.edge)) - from);
        if (y >= 0 && y <= length) return;
        Face beside = face;
        beside.edge = y < 0 ? p.before(face.edge) : p.next(face.edge);
        if (!(n.dot(p.normal(beside.edge)) > in_line)) return;
        beside.separation = separation_of(p, beside.edge, q, beside.support);
        if (beside.separation < face.separation - 1e-10 * length) return;
        face = beside;
    }
}

/// And of edges of q in line with the incident one the one that is over the
/// reference face of p, if the support is no lower than what lies between.
inline int incident_over(const Placed& p, const Face& face, const Placed& q,
                         int incident)
{
    const Vec2 n = p.normal(face.edge), t = perpendicular(n),
               from = p.vertex(face.edge);
    const Real length = t.dot(p.vertex(p.next(face.edge)) - from);
    for (int i = 0; i < q.edges(); ++i) {
        const int next = q.next(incident);
        const Real y0 = t.dot(q.vertex(incident) - from),
                   y1 = t.dot(q.vertex(next) - from);
        const bool left = std::max(y0, y1) < 0;
        if (!left && !(std::min(y0, y1) > length)) break;
        const bool back = left == (y0 > y1);
        const Vec2 up = q.vertex(back ? incident : next) - q.vertex(face.support);
        const int beside = back ? q.before(incident) : next;
        if (!(q.normal(incident).dot(q.normal(beside)) > in_line) ||
            n.dot(up) > 1e-9 * std::abs(y1 - y0))
            break;
        incident = beside;
    }
    return incident;
}
//! [in_line]

//! [collide]
/// The manifold of two shapes. The same points for b and a, with the normal the
/// other way round, unless two faces are equally good: then the first named decides.
/// \param how  how far it looks, and what it prefers
inline Manifold collide(const Placed& a, const Placed& b,
                        const ManifoldSettings& how = {})
{
    Manifold m;
    // 1: the reference face
    const Real reach = a.radius + b.radius + how.margin;
    Face face = reference_face(a, b, reach);
    if (face.separation >= reach) return m;
    EdgeEnds ea = ends_of(a, 0), eb = ends_of(b, 0);
    bool corners = face.edge < 0;  // two discs
    if (corners) m.normal_of = NormalOf::centres;
    else {
        stay_with_face(a, b, how, face);
        const Placed &p = face.of_b ? b : a, &q = face.of_b ? a : b;
        find_under_support(p, q, face);
        m.face = face.of_b ? a.edges() + face.edge : face.edge;
        const Vec2 n = p.normal(face.edge);
        // 2: the incident edge
        const int facing =
            incident_over(p, face, q, incident_edge(q, face.support, n));
        EdgeEnds reference = ends_of(p, face.edge), incident = ends_of(q, facing);
        // 3: the normal
        corners = nearest_are_corners(reference, incident, n, face.separation);
        ea = face.of_b ? incident : reference;
        eb = face.of_b ? reference : incident;
        m.normal = face.of_b ? Vec2(-n) : n;
        if (!corners) m.normal_of = face.of_b ? NormalOf::b : NormalOf::a;
    }
    if (corners) {
        const Vec2 d = eb.at[0] - ea.at[0];
        const Real distance = d.norm();
        if (!(distance < reach)) return Manifold{};
        // two centres in one point have no direction; any will part them
        m.normal = direction_of(d, distance, {0, 1});
    }
    // 4: the points
    measure_along(perpendicular(m.normal), ea, eb);
    if (corners) {  // one over the other, whatever rounding says
        eb.along[1] -= eb.along[0];
        eb.along[0] = 0;
    }
    clip(a, b, ea, eb, how.margin, how.second, how.stay, how.before, m);
    return m;
}
//! [collide]

}  // namespace rigid
