/// \file touch_parts.hpp
/// What two solids have over each other: of a face and a face, of a face and an edge, of two edges.
///
///     the reference face or edge, with n across it; the polygon of the other solid, cut at its sides (23.1)
///     gap = n·(q − p) − ρ_a − ρ_b for each corner q that is left, p under it on the reference
#pragma once

#include "chapters/22_distance_of_solids/separating_axes.hpp"
#include "chapters/23_faces_that_touch/face_clipping.hpp"

namespace rigid {

/// How far collide() looks, and what it takes for the same.
struct TouchSettings {
    Real margin = infinity;  ///< points with a gap below this [m]
    Real slack = 0;          ///< what differs by less is the same [m]
};

/// Adds a point, unless there is one of its name.
void add_point(const TouchPoint& point, ClipRoom& room);

/// Whether some point is that deep. The deepest may lie beside what was clipped.
inline bool reaches(const SolidTouch& touch, Real gap)
{
    bool some = false;
    for (int i = 0; i < touch.count; ++i)
        some = some || touch.points[static_cast<std::size_t>(i)].gap <= gap;
    return some;
}

/// The polygon to be clipped: of the faces of q at its lowest corner along n the one
/// that faces n most, or what q has instead, an edge or a corner.
void take_incident(const PlacedSolid& q, const Vec3& n, Whose q_is,
                   const TouchNames& names, ClipRoom& room);

/// Step 4 on a face: the incident polygon over the reference face.
void touch_on_face(const PlacedSolid& a, const PlacedSolid& b, const Axis& axis,
                   const TouchSettings& how, ClipRoom& room, SolidTouch& touch);

/// The edge of a solid that lies farthest along n; −1: it has none.
int edge_towards(const PlacedSolid& p, const Vec3& n);

/// Step 4 along edges: what of b's edge lies beside a's, where they are parallel.
void touch_along_edges(const PlacedSolid& a, const PlacedSolid& b, int edge_a,
                       int edge_b, const TouchSettings& how, ClipRoom& room,
                       SolidTouch& touch);

}  // namespace rigid
