/// \file ragdoll.hpp
/// A doll of ten limbs: nine revolute joints with limits, and friction that keeps them from swinging forever.
#pragma once

#include "chapters/14_joints/placed_joints.hpp"

namespace rigid {

//! [ragdoll]
/// Adds a doll of about 1.7 m and 70 kg that stands upright.
/// \param at        its hip [m]
/// \param friction  torque that a joint resists with [N m]
/// \return          the number of its first body; it has ten
inline Index add_ragdoll(JointedScene& scene, const Vec2& at, Real friction = 2)
{
    const Index first = scene.bodies.count();
    const auto limb = [&](const Polygon& shape, Real kilograms, const Vec2& middle,
                          Real angle) {
        Mass mass = mass_of(shape, 1);
        mass.inertia *= kilograms / mass.mass;
        mass.mass = kilograms;
        return add_body(scene, shape, mass, at + middle, angle);
    };
    const auto join = [&](Index a, Index b, const Vec2& place, Real lower,
                          Real upper) {
        RigidJoint joint = joint_at(scene, JointKind::revolute, a, b, at + place);
        joint.lower = lower, joint.upper = upper;
        joint.motor.force = friction;  // a motor of speed zero is friction
        add_joint(scene, joint);
    };
    const Index body = limb(box(0.22, 0.55, 0.03), 35, {0, 0.3}, 0);
    const Index head = limb(disc(0.12), 5, {0, 0.76}, 0);
    join(body, head, {0, 0.63}, -0.6, 0.6);
    for (int side = 0; side < 2; ++side) {
        const Index upper = limb(capsule(0.22, 0.05), 2.5, {0, 0.38}, pi / 2),
                    lower = limb(capsule(0.22, 0.04), 1.5, {0, 0.1}, pi / 2);
        join(body, upper, {0, 0.52}, -2, 3);
        join(upper, lower, {0, 0.24}, 0, 2.4);
        const Index thigh = limb(capsule(0.32, 0.08), 8, {0, -0.2}, pi / 2),
                    shin = limb(capsule(0.34, 0.05), 3, {0, -0.62}, pi / 2);
        join(body, thigh, {0, 0}, -0.5, 1.8);
        join(thigh, shin, {0, -0.41}, -2.3, 0);
    }
    return first;
}
//! [ragdoll]

/// What of a doll would overlap by how it is made: it does not collide with itself.
/// \param forbid  void(Index a, Index b)
template <class Forbid>
void forbid_itself(Index first, const Forbid& forbid)
{
    for (Index a = first; a < first + 10; ++a)
        for (Index b = a + 1; b < first + 10; ++b) forbid(a, b);
}

/// Steps of a staircase that goes down to the right, as bodies that cannot move, and a floor.
inline void add_stairs(JointedScene& scene, int steps)
{
    for (int i = 0; i < steps; ++i)
        add_body(scene, box(0.6, 0.3), Mass{}, {0.6 * i, 0.3 * (steps - i) - 0.15});
    scene.walls.push_back({{0, 1}, 0});
}

}  // namespace rigid
