/// \file bar_linkages.hpp
/// Mechanisms of bars: an engine, parallel cranks, a trebuchet, and a leg that walks, with what is known of them in closed form.
#pragma once

#include "chapters/11_rotation/mechanisms.hpp"
#include "chapters/14_joints/placed_joints.hpp"
#include "common/elementary.hpp"

#include <array>

namespace rigid {

/// Adds a thin rod between two places.
inline Index add_bar(JointedScene& scene, const Vec2& from, const Vec2& to,
                     Real mass)
{
    const Vec2 d = to - from;
    return add_body(scene, capsule(d.norm(), 0), thin_rod(d.norm(), mass),
                    (from + to) / 2, atan2(d.y(), d.x()));
}

/// Pins two bodies together at a place of the world.
inline std::size_t pin(JointedScene& scene, Index a, Index b, const Vec2& place)
{
    return add_joint(scene, joint_at(scene, JointKind::revolute, a, b, place));
}

/// Cranks of 1 m, side by side on pivots 2 m apart, and a bar across their ends. With two it is the four-bar linkage that
/// passes through a line twice a turn; with three a row and a half too many hold it at all times.
/// \param angle  of the cranks [rad]; 0: all bars lie in line
/// \param spin   of the cranks [rad/s]
JointedScene cranks_scene(int cranks, Real angle, Real spin);

/// A crank, a rod and a piston in a cylinder along x; the crank is turned by a motor.
/// \param speed   of the crank [rad/s]
/// \param torque  of its motor, at most [N m]
JointedScene engine_scene(Real speed, Real torque);

/// A beam of 4 m and 1 m on an axle 2.6 m high, a box on a pin at its short end, a stone of 10 kg on a sling at its long one:
/// bodies 0, 1 and 2, and joint 2 is the sling. No floor.
/// \param weight  of the box [kg]
/// \param sling   rope, or distance: then it is never slack
JointedScene trebuchet_scene(Real weight, JointKind sling);

//! [jansen]
/// Where the points of Jansen's leg are for an angle of its crank: crank end, top, back, knee, heel, foot. \cite jansen2007
struct JansenLeg {
    static constexpr Real scale = 0.01;  ///< of his numbers [m]
    Vec2 pivot{-38 * scale, -7.8 * scale};
    std::array<Vec2, 6> p;

    explicit JansenLeg(Real angle)
    {
        p[0] = 15 * scale * Vec2(cos(angle), sin(angle));
        p[1] = meet(p[0], 50, pivot, 41.5);    // above
        p[2] = meet(p[1], 55.8, pivot, 40.1);  // to the left
        p[3] = meet(pivot, 39.3, p[0], 61.9);  // below
        p[4] = meet(p[2], 39.4, p[3], 36.7);
        p[5] = meet(p[4], 65.7, p[3], 49);
    }

    /// The point at the distance r from a and s from b that lies to the left of the way from b to a, or to the right
    /// of that from a to b.
    static Vec2 meet(const Vec2& a, Real r, const Vec2& b, Real s)
    {
        r *= scale, s *= scale;
        const Vec2 d = b - a;
        const Real l = d.norm(), along = (r * r - s * s + l * l) / (2 * l);
        return a + along / l * d -
               std::sqrt(r * r - along * along) / l * perpendicular(d);
    }
};
//! [jansen]

/// Hangs the bars and triangles of a leg on a body and on a crank: 2 kg for a metre of bar, triangles as three bars.
/// \param place  where in the world a point of the leg is: a motion, or a mirror image
/// \return       the number of the triangle with the foot; its five companions are those before it
template <class Place>
Index hang_jansen_leg(JointedScene& scene, Index on, Index crank,
                      const JansenLeg& leg, const Place& place)
{
    std::array<Vec2, 6> p;
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = place(leg.p[i]);
    const Vec2 pivot = place(leg.pivot);
    const auto bar = [&](const Vec2& a, const Vec2& b) {
        return add_bar(scene, a, b, 2 * (b - a).norm());
    };
    const auto triangle = [&](std::array<Vec2, 3> c) {
        Mass mass;
        for (std::size_t i = 0; i < 3; ++i) {
            const Real m = 2 * (c[(i + 1) % 3] - c[i]).norm();
            mass.mass += m;
            mass.centroid += m * (c[i] + c[(i + 1) % 3]) / 2;
        }
        mass.centroid /= mass.mass;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2 e = c[(i + 1) % 3] - c[i];
            const Real l = e.norm();
            mass.inertia +=
                2 * l * (l * l / 12 + (c[i] + e / 2 - mass.centroid).squaredNorm());
        }
        const Vec2 along = (c[1] - c[0]).normalized();
        if (cross2(c[1] - c[0], c[2] - c[0]) < 0) std::swap(c[1], c[2]);
        Polygon shape;  // in its own axes
        for (const Vec2& corner : c) {
            const Vec2 r = corner - mass.centroid;
            shape.vertices.push_back({along.dot(r), cross2(along, r)});
        }
        const Vec2 middle = mass.centroid;
        mass.centroid = {0, 0};
        return add_body(scene, shape, mass, middle, atan2(along.y(), along.x()));
    };
    const Index j = bar(p[0], p[1]), k = bar(p[0], p[3]),
                upper = triangle({pivot, p[1], p[2]}), c = bar(pivot, p[3]),
                f = bar(p[2], p[4]), lower = triangle({p[3], p[4], p[5]});
    pin(scene, crank, j, p[0]);
    pin(scene, crank, k, p[0]);
    pin(scene, on, upper, pivot);
    pin(scene, j, upper, p[1]);
    pin(scene, on, c, pivot);
    pin(scene, k, c, p[3]);
    pin(scene, c, lower, p[3]);
    pin(scene, upper, f, p[2]);
    pin(scene, f, lower, p[4]);
    return lower;
}

/// Adds a leg of seven bodies on the world, its crank at the origin. Returns the number of the crank; that of the triangle
/// with the foot is six more.
Index add_jansen_leg(JointedScene& scene, Real angle, const Drive& motor = {});

/// x of the piston for the angle of the crank, (11.15) with these lengths: r cos θ + √(l² − r² sin² θ).
inline Real piston_by_hand(Real theta) { return slider_by_hand(theta); }

}  // namespace rigid
