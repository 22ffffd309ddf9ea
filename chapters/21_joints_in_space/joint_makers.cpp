// The functions of joint_makers.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/21_joints_in_space/joint_makers.hpp"

namespace rigid {

//! [joint_at]
SpaceJoint joint_at(const JointedSolids& scene, Index a, Index b, const Vec3& point,
                    const Vec3& axis)
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

}  // namespace rigid
