/// \file clipping.hpp
/// Two edges that face each other, and what of them lies face to face: at most two points, each with a name.
///
///     t = n⊥,   interval = [t·edge of a] ∩ [t·edge of b],   gap(τ) = n·(p_b(τ) − p_a(τ)) − ρ_a − ρ_b            (12.3)
///
/// An end of the interval is where the edge of a or that of b ends. The vertex that ends it is the name of the point.
#pragma once

#include "chapters/12_contact_manifolds/placed_shape.hpp"
#include "common/contact.hpp"

#include <algorithm>
#include <array>

namespace rigid {

struct ManifoldPoint {
    Vec2 point = {0, 0};  ///< in the middle between the two surfaces [m]
    Real gap = 0;         ///< [m], negative = penetration
    /// its name: vertex k of a, or vertex k − (number of a's vertices) of b
    int feature = 0;
};

/// Where two shapes touch, or nearly: 0, 1 or 2 points.
struct Manifold {
    Vec2 normal = {0, 1};  ///< unit vector from a to b
    int count = 0;
    std::array<ManifoldPoint, 2> points;  ///< features ascending
    int face =
        -1;  ///< reference face: edge of a, or that of b behind them; −1: none
    NormalOf normal_of = NormalOf::fixed;

    /// The least gap of its points [m]; infinity if there are none.
    Real deepest() const
    {
        Real gap = infinity;
        for (int i = 0; i < count; ++i)
            gap = std::min(gap, points[static_cast<std::size_t>(i)].gap);
        return gap;
    }
    bool has(int feature) const
    {
        return (count > 0 && points[0].feature == feature) ||
               (count > 1 && points[1].feature == feature);
    }
};

/// An edge by its two vertices; of a disc both are its centre.
struct EdgeEnds {
    std::array<int, 2> vertex{};
    std::array<Vec2, 2> at;
    std::array<Real, 2> along{};  ///< t·at [m]
};

inline EdgeEnds ends_of(const Placed& shape, int first)
{
    const int second = shape.next(first);
    return {{first, second}, {shape.vertex(first), shape.vertex(second)}, {}};
}

/// Both edges measured along t, from the beginning of a's.
inline void measure_along(const Vec2& t, EdgeEnds& ea, EdgeEnds& eb)
{
    const Vec2 origin = ea.at[0];
    for (std::size_t i = 0; i < 2; ++i) {
        ea.along[i] = t.dot(ea.at[i] - origin);
        eb.along[i] = t.dot(eb.at[i] - origin);
    }
}

//! [point_on]
/// The point of an edge at the coordinate τ, which an end of it meets to the bit.
inline Vec2 point_on(const EdgeEnds& edge, Real tau)
{
    const auto& s = edge.along;
    if (tau == s[0] || s[0] == s[1]) return edge.at[0];
    if (tau == s[1]) return edge.at[1];
    const Real part = (tau - s[0]) / (s[1] - s[0]);
    return edge.at[0] + part * (edge.at[1] - edge.at[0]);
}
//! [point_on]

/// An edge along the normal, to rounding, has one place and two ends: the one that is nearer to the other shape counts.
/// \param n  towards the other shape
inline EdgeEnds nearer_end_first(EdgeEnds edge, const Vec2& n)
{
    const Real rise = n.dot(edge.at[1] - edge.at[0]);
    if (!(std::abs(edge.along[1] - edge.along[0]) <= 1e-7 * std::abs(rise)))
        return edge;
    if (rise > 0) {
        std::swap(edge.at[0], edge.at[1]);
        std::swap(edge.vertex[0], edge.vertex[1]);
        std::swap(edge.along[0], edge.along[1]);
    }
    edge.along[1] = edge.along[0];
    return edge;
}

/// A manifold none of whose points is near is none.
inline void drop_far(Real margin, Manifold& m)
{
    const auto near = [&](const ManifoldPoint& point) {
        return point.gap < margin;
    };
    if (std::none_of(m.points.begin(), m.points.begin() + m.count, near))
        m.count = 0;
}

//! [clip]
/// The ends of what both edges have in common along t, as points of the manifold.
/// \param of_a, of_b  with their coordinates
/// \param margin  a point whose gap is not below it is left out [m] …
/// \param second  … unless the other's is below it, and its own below this [m]
/// \param stay    as long as both edges end within this of each other, a name
///                stays what it was [m]
/// \param before  names to stay with; may be null
inline void clip(const Placed& a, const Placed& b, const EdgeEnds& of_a,
                 const EdgeEnds& of_b, Real margin, Real second, Real stay,
                 const Manifold* before, Manifold& m)
{
    const EdgeEnds ea = nearer_end_first(of_a, m.normal),
                   eb = nearer_end_first(of_b, -m.normal);
    const Real radii = a.radius + b.radius;
    const auto rises = [](const EdgeEnds& e) { return e.along[0] <= e.along[1]; };
    const std::size_t low_a = rises(ea) ? 0 : 1, low_b = rises(eb) ? 0 : 1;
    Real previous = 0;
    for (const bool high : {false, true}) {
        const std::size_t i = high ? 1 - low_a : low_a,
                          j = high ? 1 - low_b : low_b;
        const Real end_a = ea.along[i], end_b = eb.along[j];
        // the end of the shorter one
        bool by_a = high ? end_a < end_b : end_a > end_b;
        const Real tau = by_a ? end_a : end_b;
        if (high && !(tau > previous)) break;  // one point, not two
        previous = tau;

        const Vec2 pa = point_on(ea, tau), pb = point_on(eb, tau);
        const Real gap = m.normal.dot(pb - pa) - radii;
        if (!(gap < std::max(margin, second))) continue;
        const int name_a = ea.vertex[i], name_b = a.size() + eb.vertex[j];
        if (before != nullptr && std::abs(end_a - end_b) <= stay &&
            before->has(name_a) != before->has(name_b))
            by_a = before->has(name_a);
        m.points[static_cast<std::size_t>(m.count++)] = {
            (pa + pb + (a.radius - b.radius) * m.normal) / 2, gap,
            by_a ? name_a : name_b};
    }
    drop_far(margin, m);
    if (m.count == 2 && m.points[1].feature < m.points[0].feature)
        std::swap(m.points[0], m.points[1]);
}
//! [clip]

}  // namespace rigid
