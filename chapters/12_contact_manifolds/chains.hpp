/// \file chains.hpp
/// A floor of many edges that is felt as one line: each edge has one side, and knows the edges beside it.
///
///     an edge    n, and at a corner that sticks out all normals from n to that of the edge beside it     (12.12)
///
/// Of a normal outside of these the edges beside it know better: the edge then answers with n alone, for as much of the
/// other shape as lies over it.
#pragma once

#include "chapters/12_contact_manifolds/manifold.hpp"

namespace rigid {

/// Adds fixed edges from each point to the next. Walk along them with the solid ground to the left: a floor from right
/// to left, an island counterclockwise.
/// \param closed  the last point is joined to the first
/// Throws std::invalid_argument for fewer than two points, and where an edge has no length.
inline void add_chain(RigidScene& scene, const std::vector<Vec2>& points,
                      bool closed = false)
{
    const std::size_t n = points.size();
    if (n < 2)
        throw std::invalid_argument("the chain has " + std::to_string(n) +
                                    " points; it needs two or more");
    RigidScene edges;  // a chain that is refused leaves nothing behind
    for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
        const Vec2 from = points[i], to = points[(i + 1) % n],
                   middle = (from + to) / 2;
        if (!(from - to).allFinite() || from == to)
            throw std::invalid_argument(
                "edge " + std::to_string(i) + " of the chain goes from (" +
                shortest(from.x()) + ", " + shortest(from.y()) + ") to (" +
                shortest(to.x()) + ", " + shortest(to.y()) +
                "); both must be finite, and they must differ");
        add_body(edges, Polygon{{from - middle, to - middle}, 0}, Mass{}, middle);
    }
    const Index first = scene.bodies.count(), count = edges.bodies.count();
    for (Index k = 0; k < count; ++k)
        add_body(scene, edges.shapes[static_cast<std::size_t>(k)], Mass{},
                 edges.bodies.position(k).head<2>());
    scene.chains.push_back({first, first + count - 1, closed});
}

/// Throws std::invalid_argument, naming the chain, unless its bodies are edges that cannot move.
inline void require_valid(const Chain& chain, std::size_t number,
                          const RigidScene& scene)
{
    const auto refuse = [number](const std::string& what) {
        throw std::invalid_argument("chain " + std::to_string(number) + " " + what);
    };
    if (chain.first < 0 || chain.last < chain.first ||
        chain.last >= scene.bodies.count())
        refuse("goes from body " + std::to_string(chain.first) + " to body " +
               std::to_string(chain.last) + " among " +
               std::to_string(scene.bodies.count()) +
               "; they must be there, in this order");
    for (Index k = chain.first; k <= chain.last; ++k)
        if (scene.shapes[static_cast<std::size_t>(k)].vertices.size() != 2 ||
            scene.bodies.can_move(k))
            refuse("has body " + std::to_string(k) +
                   " in it; its bodies must have two vertices, and no mass");
}

/// Which bodies are edges of chains, and which edges lie beside them.
struct ChainEdges {
    static constexpr int none = -1;
    std::vector<char> is_edge;       ///< of each body; empty: there are no chains
    std::vector<int> before, after;  ///< `none`: the chain ends there

    bool has(int k) const
    {
        return !is_edge.empty() && is_edge[static_cast<std::size_t>(k)] != 0;
    }
    void list(const RigidScene& scene)
    {
        is_edge.clear();
        if (scene.chains.empty()) return;
        const auto K = static_cast<std::size_t>(scene.bodies.count());
        is_edge.assign(K, 0);
        before.assign(K, none);
        after.assign(K, none);
        for (std::size_t i = 0; i < scene.chains.size(); ++i) {
            const Chain& chain = scene.chains[i];
            require_valid(chain, i, scene);
            for (Index k = chain.first; k <= chain.last; ++k) {
                const auto at = static_cast<std::size_t>(k);
                is_edge[at] = 1;
                before[at] = static_cast<int>(k - 1);
                after[at] = static_cast<int>(k + 1);
            }
            const auto ends = [&](int b, int a) {
                before[static_cast<std::size_t>(chain.first)] = b;
                after[static_cast<std::size_t>(chain.last)] = a;
            };
            if (chain.closed)
                ends(static_cast<int>(chain.last), static_cast<int>(chain.first));
            else ends(none, none);
        }
    }
};

//! [may_push]
/// (12.12): whether an edge may push along m: m lies between its normal and that of
/// an edge beside it, at a corner that sticks out.
/// \param n              outward normal of the edge
/// \param before, after  those of the edges beside it; where there is none, the way
///                       out of the chain
inline bool may_push(const Vec2& n, const Vec2& before, const Vec2& after,
                     const Vec2& m)
{
    constexpr Real rounding = 1e-12;
    const auto between = [&m](const Vec2& from, const Vec2& to) {
        return cross2(from, to) > 0 && cross2(from, m) >= -rounding &&
               cross2(m, to) >= -rounding && m.dot(from + to) > 0;
    };
    return between(before, n) || between(n, after);
}
//! [may_push]

//! [over_edge]
/// The points of a shape over an edge, along its own normal; none, if no part
/// of the edge of the shape that faces it lies over it.
/// \param of_b  b is the edge of the chain, not a
inline Manifold points_over_edge(const Placed& a, const Placed& b, bool of_b,
                                 const ManifoldSettings& how)
{
    const Placed &p = of_b ? b : a, &q = of_b ? a : b;
    const Vec2& n = p.normal(0);
    int support = 0;
    const Real reach = a.radius + b.radius + how.margin;
    if (!(separation_of(p, 0, q, support) < reach)) return {};
    const EdgeEnds edge = ends_of(p, 0),
                   facing = ends_of(q, incident_edge(q, support, n));
    EdgeEnds ea = of_b ? facing : edge, eb = of_b ? edge : facing;
    Manifold m;
    m.normal = of_b ? Vec2(-n) : n;
    m.face = of_b ? a.edges() : 0;
    m.normal_of = of_b ? NormalOf::b : NormalOf::a;
    measure_along(perpendicular(m.normal), ea, eb);
    const auto low = [](const EdgeEnds& e) {
        return std::min(e.along[0], e.along[1]);
    };
    const auto high = [](const EdgeEnds& e) {
        return std::max(e.along[0], e.along[1]);
    };
    const Real rounding = 1e-12 * (high(of_b ? eb : ea) - low(of_b ? eb : ea));
    if (std::max(low(ea), low(eb)) > std::min(high(ea), high(eb)) + rounding)
        return {};
    clip(a, b, ea, eb, how.margin, how.second, how.stay, how.before, m);
    return m;
}
//! [over_edge]

/// Whether a point is behind an edge, by more than rounding: what has no radius lies on it with its centroid.
inline bool is_behind(const Placed& edge, const Vec2& point)
{
    const Vec2 out = point - edge.vertex(0), e = edge.vertex(1) - edge.vertex(0);
    return edge.normal(0).dot(out) < -1e-9 * e.norm();
}

//! [collide_with_edge]
/// The manifold of a shape and an edge of a chain. None, if the shape's centroid is
/// behind the edge.
/// \param before, after  normals beside the edge, as above
/// \param centroid       of the shape
inline Manifold collide_with_edge(const Placed& a, const Placed& b, bool of_b,
                                  const Vec2& before, const Vec2& after,
                                  const Vec2& centroid, const ManifoldSettings& how)
{
    const Placed& edge = of_b ? b : a;
    const Vec2& n = edge.normal(0);
    if (is_behind(edge, centroid)) return {};
    const Manifold m = collide(a, b, how);
    if (m.count == 0) return m;
    const Vec2 push = of_b ? Vec2(-m.normal) : m.normal;
    return may_push(n, before, after, push) ? m : points_over_edge(a, b, of_b, how);
}
//! [collide_with_edge]

/// The manifold of two bodies of which one is an edge of a chain.
inline Manifold collide_in_chain(const PlacedShapes& placed,
                                 const ChainEdges& edges, int a, int b,
                                 const ManifoldSettings& how)
{
    const bool of_b = edges.has(b);
    const int k = of_b ? b : a;
    const Placed edge = placed.of(k);
    const auto at = static_cast<std::size_t>(k);
    const Vec2 t = (edge.vertex(1) - edge.vertex(0)).normalized();
    const auto normal_of_edge = [&](int beside, const Vec2& out) {
        return beside == ChainEdges::none ? out : placed.of(beside).normal(0);
    };
    return collide_with_edge(
        placed.of(a), placed.of(b), of_b, normal_of_edge(edges.before[at], -t),
        normal_of_edge(edges.after[at], t),
        placed.middle[static_cast<std::size_t>(of_b ? a : b)], how);
}

}  // namespace rigid
