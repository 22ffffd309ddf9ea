// The functions of joint_coordinates.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/21_joints_in_space/joint_coordinates.hpp"

namespace rigid {

JointFrames frames_of(const VecX& x, const SpaceJoint& joint)
{
    const auto rotation = [&x](Index k) {
        return k == world ? Quaternion{}
                          : quaternion_of(Vec3(x.segment<3>(6 * k + 3)));
    };
    const Quaternion a = rotation(joint.a), b = rotation(joint.b);
    const Quaternion qa = a * quaternion_of(joint.frame_a),
                     qb = b * quaternion_of(joint.frame_b);
    JointFrames f;
    f.Ra = rotation_matrix(a), f.Rb = rotation_matrix(b);
    f.A = rotation_matrix(qa), f.B = rotation_matrix(qb);
    f.arm_a = f.Ra * joint.at_a, f.arm_b = f.Rb * joint.at_b;
    f.way = centre_of(x, joint.b) + f.arm_b - centre_of(x, joint.a) - f.arm_a;
    f.q = Quaternion{qa.w, -qa.v} * qb;
    if (f.q.w < 0) f.q = {-f.q.w, -f.q.v};
    return f;
}

Real largest_joint_error(const JointedSolids& scene)
{
    Real largest = 0;
    for (const SpaceJoint& joint : scene.joints) {
        const JointFrames f = frames_of(scene.bodies.x, joint);
        for (int c = 0; c < coordinates; ++c)
            if (joint.locked(c))
                largest = std::max(largest,
                                   std::abs(joint_constraint(f, joint, 2 * c).C));
    }
    return largest;
}

}  // namespace rigid
