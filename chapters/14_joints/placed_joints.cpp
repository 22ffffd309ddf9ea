// The functions of placed_joints.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/14_joints/placed_joints.hpp"

namespace rigid {

//! [place]
std::size_t add_joint(JointedScene& scene, const RigidJoint& joint)
{
    require_valid(joint, scene.placed.size(), scene.bodies);
    PlacedJoint placed;
    placed.joint = joint;
    placed.first = static_cast<int>(scene.joints.size());
    add_frame_rows(joint, scene.joints);
    add_drive_rows(joint, scene.joints);
    placed.count = static_cast<int>(scene.joints.size()) - placed.first;
    scene.owner.resize(static_cast<std::size_t>(placed.first), -1);
    scene.owner.resize(scene.joints.size(), static_cast<int>(scene.placed.size()));
    scene.placed.push_back(placed);
    return scene.placed.size() - 1;
}
//! [place]

void remove_last_joint(JointedScene& scene)
{
    if (scene.placed.empty())
        throw std::invalid_argument("there is no joint that could be removed");
    const auto first = static_cast<std::size_t>(scene.placed.back().first);
    scene.joints.resize(first);
    scene.owner.resize(first);
    scene.placed.pop_back();
}

Vec2 local_point(const RigidScene& scene, Index k, const Vec2& place)
{
    if (k == world) return place;
    if (k < world || k >= scene.bodies.count())
        throw std::invalid_argument("there is no body " + std::to_string(k) +
                                    " among " +
                                    std::to_string(scene.bodies.count()));
    const Vec2 d = place - scene.bodies.position(k).head<2>();
    const Real c = cos(scene.bodies.x[3 * k + 2]),
               s = sin(scene.bodies.x[3 * k + 2]);
    return {c * d.x() + s * d.y(), c * d.y() - s * d.x()};
}

RigidJoint joint_at(const RigidScene& scene, JointKind kind, Index a, Index b,
                    const Vec2& place)
{
    RigidJoint joint;
    joint.kind = kind;
    joint.a = a, joint.b = b;
    joint.at_a = local_point(scene, a, place);
    joint.at_b = local_point(scene, b, place);
    const auto angle = [&](Index k) {
        return k == world ? 0 : scene.bodies.x[3 * k + 2];
    };
    joint.angle = angle(b) - angle(a);
    return joint;
}

void change_joint(JointedScene& scene, std::size_t number, const RigidJoint& joint)
{
    PlacedJoint& placed = scene.placed.at(number);
    require_valid(joint, number, scene.bodies);
    std::vector<PointJoint> rows;
    add_frame_rows(joint, rows);
    add_drive_rows(joint, rows);
    if (static_cast<int>(rows.size()) != placed.count ||
        joint.kind != placed.joint.kind || joint.a != placed.joint.a ||
        joint.b != placed.joint.b)
        throw std::invalid_argument(
            "joint " + std::to_string(number) + " has " +
            std::to_string(placed.count) + " rows and would have " +
            std::to_string(rows.size()) +
            "; a joint keeps its kind, its bodies and the number of its rows");
    std::copy(rows.begin(), rows.end(), scene.joints.begin() + placed.first);
    placed.joint = joint;
}

}  // namespace rigid
