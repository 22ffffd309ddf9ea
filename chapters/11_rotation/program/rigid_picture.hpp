/// \file rigid_picture.hpp
/// Pictures of bodies that turn, of their walls and joints.
#pragma once

#include "chapters/04_pgs/program/drawing.hpp"
#include "chapters/11_rotation/rigid_scene.hpp"
#include "chapters/11_rotation/rounded_outline.hpp"
#include "common/elementary.hpp"

#include <algorithm>

namespace rigid {

inline void paint_half_space(Canvas& canvas, const HalfSpace& wall)
{
    const Vec2 middle = wall.normal * wall.offset,
               along = 3 * perpendicular(wall.normal);
    const bool upright = std::abs(wall.normal.x()) > 0.5;
    canvas.segment(upright ? middle : Vec2(middle - along),
                   middle + (upright ? Vec2(0, 3) : along), paint::wall);
}

inline void paint_rigid_body(Canvas& canvas, const RigidScene& scene, Index k,
                             const Style& style)
{
    const VecX& x = scene.bodies.x;
    const Polygon& shape = scene.shapes[static_cast<std::size_t>(k)];
    std::vector<Vec2> corners;
    for (const Vec2& vertex : shape.vertices)
        corners.push_back(point_of(x, k, vertex));
    if (corners.size() == 1) {
        canvas.disc(corners[0], shape.radius, style);
        canvas.segment(corners[0], point_of(x, k, {0.9 * shape.radius, 0}),
                       {Colour::blue, 1.5, 1});
    } else if (shape.radius > 0)
        canvas.polygon(rounded_outline(corners, shape.radius), style);
    else if (corners.size() == 2)
        canvas.segment(corners[0], corners[1], {style.colour, 5, 0.8});
    else canvas.polygon(corners, style);
}
inline void paint_rigid_body(Canvas& canvas, const RigidScene& scene, Index k)
{
    paint_rigid_body(canvas, scene, k,
                     scene.bodies.can_move(k) ? paint::body : paint::fixed_body);
}

inline void paint_rigid_joints(Canvas& canvas, const RigidScene& scene)
{
    for (const PointJoint& joint : scene.joints) {
        if (joint.measure == PointJoint::Measure::angle) continue;
        const Vec2 a = point_of(scene.bodies.x, joint.a, joint.at_a),
                   b = point_of(scene.bodies.x, joint.b, joint.at_b);
        if (joint.measure == PointJoint::Measure::distance)
            canvas.segment(a, b, {Colour::purple, 2, 1});
        canvas.disc(b, 0.025, {Colour::orange, 1, 1, Paint::filled});
    }
}

/// The body that can move whose centroid is nearest to a point, for a hand that pulls it; the world if there is none.
inline Index nearest_body(const Bodies<3>& bodies, const Vec2& pointer)
{
    Real nearest = infinity;
    Index found = world;
    for (Index k = 0; k < bodies.count(); ++k) {
        const Real distance = (bodies.position(k).head<2>() - pointer).norm();
        if (bodies.can_move(k) && distance < nearest) nearest = distance, found = k;
    }
    return found;
}

}  // namespace rigid
