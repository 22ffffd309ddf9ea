/// \file joint_makers.hpp
/// The joints by their names: each is a point, an axis, and which coordinates are locked.
#pragma once

#include "chapters/18_space/joint_coordinates.hpp"

namespace rigid {

/// The rotation vector that takes the x axis to the direction of `axis`, by the shortest way.
inline Vec3 frame_along(const Vec3& axis)
{
    const Vec3 n = axis / axis.norm();
    // half way from x to n, as a quaternion: (1 + x·n, x × n)
    const Quaternion q{1 + n.x(), {0, -n.z(), n.y()}};
    return q.w > 1e-8 ? rotation_vector(q) : Vec3(0, pi, 0);
}

//! [joint_at]
/// A joint whose frames lie in one place now: at a point of the world, x along an
/// axis. All of its coordinates are free.
/// Throws std::invalid_argument for bodies that are not there, an axis without
/// direction, a point that is not finite.
inline SpaceJoint joint_at(const SpaceScene& scene, Index a, Index b,
                           const Vec3& point, const Vec3& axis = {1, 0, 0})
{
    const Index count = scene.bodies.count();
    if (a < world || a >= count || b < 0 || b >= count || a == b)
        throw std::invalid_argument(
            "a joint joins bodies " + std::to_string(a) + " and " +
            std::to_string(b) + " among " + std::to_string(count) +
            "; they must be two, and only a may be the world (-1)");
    if (!point.allFinite() || !axis.allFinite() || !(axis.norm() > 0))
        throw std::invalid_argument(
            "the joint of bodies " + std::to_string(a) + " and " +
            std::to_string(b) +
            " has a point that is not finite, or an axis without direction");
    const VecX& x = scene.bodies.x;
    SpaceJoint joint;
    joint.a = a, joint.b = b;
    const Quaternion frame = quaternion_of(frame_along(axis));
    const auto seen_from = [&](Index k, Vec3& at, Vec3& theta) {
        const Quaternion q = k == world
                                 ? Quaternion{}
                                 : quaternion_of(Vec3(x.segment<3>(6 * k + 3)));
        at = rotation_matrix(q).transpose() * (point - centre_of(x, k));
        theta = rotation_vector(Quaternion{q.w, -q.v} * frame);
    };
    seen_from(a, joint.at_a, joint.frame_a);
    seen_from(b, joint.at_b, joint.frame_b);
    return joint;
}
//! [joint_at]

//! [makers]
/// Two points in one place; every rotation is free.
inline SpaceJoint ball_joint(const SpaceScene& scene, Index a, Index b,
                             const Vec3& point, const Vec3& axis = {1, 0, 0})
{
    SpaceJoint joint = joint_at(scene, a, b, point, axis);
    joint.lock({along_x, along_y, along_z});
    return joint;
}
/// One axis: the twist about it is free.
inline SpaceJoint hinge(const SpaceScene& scene, Index a, Index b,
                        const Vec3& point, const Vec3& axis)
{
    SpaceJoint joint = ball_joint(scene, a, b, point, axis);
    joint.lock({swing_y, swing_z});
    return joint;
}
/// The way along an axis is free, and nothing else.
inline SpaceJoint slider(const SpaceScene& scene, Index a, Index b,
                         const Vec3& point, const Vec3& axis)
{
    SpaceJoint joint = joint_at(scene, a, b, point, axis);
    joint.lock({along_y, along_z, twist, swing_y, swing_z});
    return joint;
}
/// A shaft that bends in any direction and hands its spin on as it is.
inline SpaceJoint constant_velocity(const SpaceScene& scene, Index a, Index b,
                                    const Vec3& point, const Vec3& axis)
{
    SpaceJoint joint = ball_joint(scene, a, b, point, axis);
    joint.lock({twist});
    return joint;
}
/// Hooke's joint: a cross that turns about z of A and about y of B. It hands a spin
/// on unevenly, (18.27b).
inline SpaceJoint universal(const SpaceScene& scene, Index a, Index b,
                            const Vec3& point, const Vec3& axis)
{
    SpaceJoint joint = ball_joint(scene, a, b, point, axis);
    joint.lock({pins});
    return joint;
}
inline SpaceJoint fixed_joint(const SpaceScene& scene, Index a, Index b,
                              const Vec3& point)
{
    SpaceJoint joint = hinge(scene, a, b, point, {1, 0, 0});
    joint.lock({twist});
    return joint;
}
//! [makers]

}  // namespace rigid
