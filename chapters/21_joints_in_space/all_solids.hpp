/// \file all_solids.hpp
/// What the step needs of joints in space: which rows they have, and what these are where the bodies are.
#pragma once

#include "chapters/20_turning_in_space/free_solids.hpp"
#include "chapters/21_joints_in_space/joint_coordinates.hpp"

namespace rigid {

/// What a step looks at each time, joints as well. Throws std::invalid_argument, with a sentence that names the thing,
/// unless it makes sense.
void require_bodies(const JointedSolids& scene);

/// The frames of a joint, found once for rows that are neighbours.
struct JointPlace {
    JointFrames frames;
    int joint = -1;  ///< whose these are

    Constraint<6> row(const JointedSolids& scene, const Source& source)
    {
        const int number = source.index / joint_slots;
        const SpaceJoint& at = scene.joints[static_cast<std::size_t>(number)];
        if (number != joint) frames = frames_of(scene.bodies.x, at), joint = number;
        return joint_constraint(frames, at, source.index % joint_slots);
    }
};

/// Constraint i of the step at any positions x.
inline Constraint<6> constraint_at(const JointedSolids& scene,
                                   const StepData<6>& now, std::size_t i,
                                   const VecX& x)
{
    const Source& source = now.sources[i];
    const SpaceJoint& joint =
        scene.joints[static_cast<std::size_t>(source.index / joint_slots)];
    return joint_constraint(frames_of(x, joint), joint, source.index % joint_slots);
}

/// All of them where the bodies are.
void evaluate_constraints(const JointedSolids& scene, StepData<6>& now);

//! [all_solids]
/// The contacts stage with joints and without contacts: every body is looked at, and
/// every joint.
struct AllSolids : FreeSolids {
    template <class Method>
    void begin(const JointedSolids& scene, const StepSettings& settings,
               Method& method, StepData<6>& now) const
    {
        require_bodies(scene);
        FreeSolids::begin(scene, settings, method, now);
        list_joints(
            scene, [](Index) { return true; }, now);
    }
    /// The rows of the joints of some bodies, and no contact yet.
    /// \param looks  bool(Index): whether the step looks at a body
    template <class Looks>
    static void list_joints(const JointedSolids& scene, const Looks& looks,
                            StepData<6>& now)
    {
        const Bodies<6>& bodies = scene.bodies;
        now.contacts.clear();
        now.sources.clear();
        for (std::size_t i = 0; i < scene.joints.size(); ++i) {
            const SpaceJoint& joint = scene.joints[i];
            if (!bodies.can_move(joint.a) && !bodies.can_move(joint.b)) continue;
            if (!(joint.a != world && looks(joint.a)) && !looks(joint.b)) continue;
            for_each_slot(frames_of(bodies.x, joint), joint, [&](int slot) {
                now.sources.push_back(
                    {Source::Of::joint, static_cast<int>(i) * joint_slots + slot});
            });
        }
    }
};
//! [all_solids]

}  // namespace rigid
