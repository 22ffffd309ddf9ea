/// \file placed_joints.hpp
/// How a joint gets into a scene, and how another one takes its place there.
#pragma once

#include "chapters/14_joints/joint_rows.hpp"
#include "common/elementary.hpp"

namespace rigid {

/// Adds a joint to a scene.
/// \return  its number
/// Throws std::invalid_argument, with a sentence, for a joint that makes no sense.
std::size_t add_joint(JointedScene& scene, const RigidJoint& joint);

/// Takes the joint that was added last out of the scene again.
/// Throws std::invalid_argument if there is none.
void remove_last_joint(JointedScene& scene);

/// The point of body k that is at a place of the world now; of the world: the place.
/// Throws std::invalid_argument unless there is such a body.
Vec2 local_point(const RigidScene& scene, Index k, const Vec2& place);

/// A joint of two bodies at one place of the world, where their frames are to be as they are now.
RigidJoint joint_at(const RigidScene& scene, JointKind kind, Index a, Index b,
                    const Vec2& place);

/// Another joint in the place of one: the same kind and bodies, and as many rows.
/// Throws std::invalid_argument where that is not so: a motor that is to be switched on later starts with a force above 0.
void change_joint(JointedScene& scene, std::size_t number, const RigidJoint& joint);

}  // namespace rigid
