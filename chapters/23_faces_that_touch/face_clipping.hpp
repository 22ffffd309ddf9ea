/// \file face_clipping.hpp
/// What of one face lies over another: a polygon, each of whose corners has a name; and the four of them that carry.
///
///     keep q where m_k·(q − p_k) ≤ 0,   m_k = (p_{k+1} − p_k) × n, for each side k of the reference face   (23.1)
///
/// A corner of the polygon is a corner of the incident face, a corner of the reference face, or where two edges cross.
/// Its name says which, so it stays the same from step to step, whichever face is the reference.
#pragma once

#include "chapters/22_distance_of_solids/solid_form.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace rigid {

/// A point where two solids touch, or nearly.
struct TouchPoint {
    Vec3 on_a = {0, 0, 0}, on_b = {0, 0, 0};  ///< of the cores [m]
    Real gap = 0;     ///< of the surfaces [m]; negative: they overlap
    int feature = 0;  ///< its name, among those of these two solids
};

/// Where two solids touch: up to four points.
struct SolidTouch {
    Vec3 normal = {0, 1, 0};  ///< unit vector from a to b
    int count = 0;
    std::array<TouchPoint, 4> points;
};

/// Names of corners and crossings of two hulls.
struct TouchNames {
    int corners_a, corners_b, edges_a, edges_b;

    TouchNames(const SolidForm& a, const SolidForm& b)
        : corners_a(static_cast<int>(a.hull.vertices.size())),
          corners_b(static_cast<int>(b.hull.vertices.size())),
          edges_a(static_cast<int>(a.edges.size())),
          edges_b(static_cast<int>(b.edges.size()))
    {
    }
    int corner(Whose whose, int i) const
    {
        return whose == Whose::b ? corners_a + i : i;
    }
    int crossing(int edge_a, int edge_b) const
    {
        return corners_a + corners_b + edge_a * edges_b + edge_b;
    }
    /// of the one point of two that touch in one point
    int single() const { return crossing(edges_a, 0); }
    int count() const { return single() + 1; }
};

/// A corner of the polygon that is clipped, and the edge from it to the next: one of the incident solid, or one of
/// the reference, along which it was cut.
struct ClipCorner {
    Vec3 at;
    int name = 0;
    int edge = 0;
    bool of_reference = false;
};

/// A plane that bounds a reference from the side: what lies beyond it is cut off.
struct ClipSide {
    Vec3 on, out;
    int edge = -1;  ///< of the reference, in this plane; −1: only a corner is
    int edge_before = -1;    ///< that of the side before
    int start = 0, end = 0;  ///< corners of the reference
};

/// Memory of the clipping.
struct ClipRoom {
    std::vector<ClipCorner> polygon, next;
    std::vector<ClipSide> sides;
    std::vector<TouchPoint> points;
};

//! [cut]
/// (23.1): cuts off what of room.polygon lies beyond one side.
/// \param slack     so far beyond it a corner is still kept, with its name [m]
/// \param crossing  int(int reference_edge, int incident_edge): a name
/// \param corner    int(int): the name of a corner of the reference
template <class Crossing, class Corner>
void cut(const ClipSide& side, Real slack, const Crossing& crossing,
         const Corner& corner, ClipRoom& room)
{
    room.next.clear();
    for (std::size_t i = 0; i < room.polygon.size(); ++i) {
        const ClipCorner& c = room.polygon[i];
        const ClipCorner& d = room.polygon[(i + 1) % room.polygon.size()];
        const Real out_c = side.out.dot(c.at - side.on),
                   out_d = side.out.dot(d.at - side.on);
        const bool leaves = out_c <= slack && out_d > slack,
                   returns = out_c > slack && out_d <= slack;
        if (out_c <= slack) room.next.push_back(c);
        if (!leaves && !returns) continue;
        ClipCorner x = c;
        x.at +=
            std::clamp(out_c / (out_c - out_d), Real{0}, Real{1}) * (d.at - c.at);
        x.name = side.edge < 0                ? corner(side.start)
                 : !c.of_reference            ? crossing(side.edge, c.edge)
                 : c.edge == side.edge_before ? corner(side.start)
                                              : corner(side.end);
        // having left, the polygon goes on along the side
        if (leaves) x.edge = side.edge, x.of_reference = true;
        room.next.push_back(x);
    }
    std::swap(room.polygon, room.next);
}
//! [cut]

/// The place of the point with the highest score above `least`; points.size() if there is none.
template <class Score>
std::size_t best_point(const std::vector<TouchPoint>& points, Real least,
                       const Score& score)
{
    std::size_t best = points.size();
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const Real s = score(points[i]); s > least) least = s, best = i;
    return best;
}

/// At most four of the points: the deepest, the farthest from it, the farthest from
/// the line through both, and the one that adds the largest triangle to these.
/// \param slack  gaps that differ by less are the same depth [m]
void choose_four(const std::vector<TouchPoint>& points, Real slack,
                 SolidTouch& touch);

/// The same in the order of their names, so that rows keep their places.
void keep_four(const std::vector<TouchPoint>& points, Real slack,
               SolidTouch& touch);

}  // namespace rigid
