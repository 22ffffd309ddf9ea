// The functions of ragdoll.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/14_joints/ragdoll.hpp"

namespace rigid {

//! [ragdoll]
Index add_ragdoll(JointedScene& scene, const Vec2& at, Real friction)
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

}  // namespace rigid
