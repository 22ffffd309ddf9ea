/// \file joint_makers.hpp
/// The joints by their names: each is a point, an axis, and which coordinates are locked.
#pragma once

#include "chapters/21_joints_in_space/joint_coordinates.hpp"

namespace rigid {

/// The rotation vector that takes the x axis to the direction of `axis`, by the shortest way.
inline Vec3 frame_along(const Vec3& axis)
{
    const Vec3 n = axis / axis.norm();
    // half way from x to n, as a quaternion: (1 + x·n, x × n)
    Quaternion q{1 + n.x(), {0, -n.z(), n.y()}};
    if (q.w > 1e-8) return rotation_vector(q);
    // nearly turned about, rounding is all of 1 + x·n, which is |x × n|²/(1 − x·n)
    q.w = q.v.squaredNorm() / (1 - n.x());
    return q.v.norm() > 1e-15 ? rotation_vector(q) : Vec3(0, pi, 0);
}

/// A joint whose frames lie in one place now: at a point of the world, x along an
/// axis. All of its coordinates are free.
/// Throws std::invalid_argument for bodies that are not there, an axis without
/// direction, a point that is not finite.
SpaceJoint joint_at(const JointedSolids& scene, Index a, Index b, const Vec3& point,
                    const Vec3& axis = {1, 0, 0});

//! [makers]
/// Two points in one place; every rotation is free.
inline SpaceJoint ball_joint(const JointedSolids& scene, Index a, Index b,
                             const Vec3& point, const Vec3& axis = {1, 0, 0})
{
    SpaceJoint joint = joint_at(scene, a, b, point, axis);
    joint.lock({along_x, along_y, along_z});
    return joint;
}
/// One axis: the twist about it is free.
inline SpaceJoint hinge(const JointedSolids& scene, Index a, Index b,
                        const Vec3& point, const Vec3& axis)
{
    SpaceJoint joint = ball_joint(scene, a, b, point, axis);
    joint.lock({swing_y, swing_z});
    return joint;
}
/// The way along an axis is free, and nothing else.
inline SpaceJoint slider(const JointedSolids& scene, Index a, Index b,
                         const Vec3& point, const Vec3& axis)
{
    SpaceJoint joint = joint_at(scene, a, b, point, axis);
    joint.lock({along_y, along_z, twist, swing_y, swing_z});
    return joint;
}
/// A shaft that bends in any direction and hands its spin on as it is.
inline SpaceJoint constant_velocity(const JointedSolids& scene, Index a, Index b,
                                    const Vec3& point, const Vec3& axis)
{
    SpaceJoint joint = ball_joint(scene, a, b, point, axis);
    joint.lock({twist});
    return joint;
}
/// Hooke's joint: a cross that turns about z of A and about y of B. It hands a spin
/// on unevenly, (21.7b).
inline SpaceJoint universal(const JointedSolids& scene, Index a, Index b,
                            const Vec3& point, const Vec3& axis)
{
    SpaceJoint joint = ball_joint(scene, a, b, point, axis);
    joint.lock({pins});
    return joint;
}
inline SpaceJoint fixed_joint(const JointedSolids& scene, Index a, Index b,
                              const Vec3& point)
{
    SpaceJoint joint = hinge(scene, a, b, point, {1, 0, 0});
    joint.lock({twist});
    return joint;
}
//! [makers]

}  // namespace rigid
