/// \file reduced_links.hpp
/// Which bodies hang on which by joints that coordinates can say: the list that the recursion of reduced.hpp goes up and down.
///
///     world ─ joint ─ body ─ joint ─ body …        parents first, one joint a body, no loops
#pragma once

#include "chapters/14_joints/joint_rows.hpp"

namespace rigid {

/// A body, the joint that it hangs on, and what the recursion writes there.
struct ReducedLink {
    using Mat3 = Eigen::Matrix<Real, 3, 3>;
    RigidJoint joint;
    Index body = 0;
    int parent = -1;  ///< its number in the list; -1 = the world
    Vec<3> s = Vec<3>::Zero(), p = s, As = s;
    Mat3 A = Mat3::Zero();
    Real per_inertia = 0;
};

/// The tree of a scene's joints.
/// Throws std::invalid_argument, naming the joint or body, for what coordinates of this kind cannot say.
inline std::vector<ReducedLink> links_of(const JointedScene& scene)
{
    std::vector<ReducedLink> links;
    const Index count = scene.bodies.count();
    std::vector<int> hangs_on(static_cast<std::size_t>(count), -1);
    for (std::size_t i = 0; i < scene.placed.size(); ++i) {
        const RigidJoint& joint = scene.placed[i].joint;
        const std::string name = "joint " + std::to_string(i);
        if (joint.kind != JointKind::revolute &&
            joint.kind != JointKind::prismatic && joint.kind != JointKind::weld)
            throw std::invalid_argument(
                name + " is a " + std::string(to_string(joint.kind)) +
                " joint; coordinates of joints take revolute, prismatic, weld");
        if (!scene.bodies.can_move(joint.b))
            throw std::invalid_argument(
                name + " holds body " + std::to_string(joint.b) +
                ", which cannot move, as its b; what moves must hang on what does "
                "not, as its a");
        int& joint_of_b = hangs_on[static_cast<std::size_t>(joint.b)];
        if (joint_of_b >= 0)
            throw std::invalid_argument(
                name + " is the second on which body " + std::to_string(joint.b) +
                " hangs: a loop, which coordinates of joints cannot close");
        joint_of_b = static_cast<int>(i);
    }
    std::vector<int> entered(static_cast<std::size_t>(count), -1);
    for (Index k = 0; k < count; ++k)
        if (scene.bodies.can_move(k) && hangs_on[static_cast<std::size_t>(k)] < 0)
            throw std::invalid_argument("body " + std::to_string(k) +
                                        " hangs on no joint; coordinates of "
                                        "joints start from the world");
    for (bool more = true; more;) {  // parents first; a round for each level
        more = false;
        for (Index k = 0; k < count; ++k) {
            const int j = hangs_on[static_cast<std::size_t>(k)];
            if (j < 0 || entered[static_cast<std::size_t>(k)] >= 0) continue;
            const RigidJoint& joint =
                scene.placed[static_cast<std::size_t>(j)].joint;
            const bool on_world = !scene.bodies.can_move(joint.a);
            const int parent =
                on_world ? -1 : entered[static_cast<std::size_t>(joint.a)];
            if (!on_world && parent < 0) continue;
            entered[static_cast<std::size_t>(k)] = static_cast<int>(links.size());
            links.emplace_back();
            links.back().joint = joint;
            links.back().body = k;
            links.back().parent = parent;
            more = true;
        }
    }
    for (Index k = 0; k < count; ++k)
        if (scene.bodies.can_move(k) && entered[static_cast<std::size_t>(k)] < 0)
            throw std::invalid_argument(
                "body " + std::to_string(k) +
                " hangs on a ring of joints, which no coordinate of them places; "
                "coordinates of joints start from the world");
    return links;
}

}  // namespace rigid
