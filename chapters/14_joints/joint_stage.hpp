/// \file joint_stage.hpp
/// The contacts stage with joints: a limit has its row only when it is near, a joint that bore too much breaks, and what
/// each bears can be read.
#pragma once

#include "chapters/13_friction/friction_stage.hpp"
#include "chapters/14_joints/limit_reach.hpp"

namespace rigid {

/// What a joint does to its body b: a force at the point of its frame, and a torque besides.
struct Reaction {
    Vec2 force = {0, 0};  ///< [N]
    Real torque = 0;      ///< [N m]
};

//! [reaction]
/// (14.5): the impulses of a joint's rows, along their J, over the time they took.
/// Each row has its own moment about the point where it is now: a row that acts
/// there has none, however far the body has turned since the row was made.
/// \param now  of the step that has just been taken
inline Reaction reaction(const JointedScene& scene, const StepData<3>& now,
                         std::size_t number)
{
    const PlacedJoint& placed = scene.placed.at(number);
    const VecX& x = scene.bodies.x;
    const Index b = placed.joint.b;
    const Vec2 arm =
        point_of(x, b, placed.joint.at_b) - scene.bodies.position(b).head<2>();
    Vec2 force(0, 0);
    Real torque = 0;
    for (std::size_t i = 0; i < now.sources.size(); ++i) {
        const Source& source = now.sources[i];
        if (source.of != Source::Of::joint || source.index < placed.first ||
            source.index >= placed.first + placed.count || now.rows[i].b != b)
            continue;
        const Real lambda = now.solution.lambda[static_cast<Index>(i)];
        const RowVec<3> J = constraint_at(scene, now, i, x).Jb;
        const Vec2 P = lambda * J.head<2>().transpose();
        force += lambda * now.rows[i].Jb.head<2>().transpose();
        torque += lambda * J[2] - cross2(arm, P);
    }
    return {force / now.h, torque / now.h};
}
//! [reaction]

//! [with_joints]
/// The contacts stage: whatever another one finds, but for limits that are far and
/// joints that are broken.
template <class Contacts>
struct WithJoints : Contacts {
    /// false: every limit has its rows at all times
    bool skip_far_limits = true;
    int limits_skipped = 0;        ///< rows, of the last step
    int broken = 0;                ///< joints, in the last step
    std::vector<char> was_broken;  ///< of each joint, when the last step began
    LimitReach reach;

    template <class Method>
    void begin(const JointedScene& scene, const StepSettings& settings,
               Method& method, StepData<3>& now)
    {
        wake_the_broken(scene);
        broken = 0;
        do {
            Contacts::begin(scene, settings, method, now);
            limits_skipped = 0;
            if (skip_far_limits) reach.look(scene, settings, now);
            std::erase_if(now.sources, [&](const Source& source) {
                if (source.of != Source::Of::joint) return false;
                const auto j = static_cast<std::size_t>(source.index);
                const int owner = j < scene.owner.size() ? scene.owner[j] : -1;
                if (owner >= 0 &&
                    scene.placed[static_cast<std::size_t>(owner)].broken)
                    return true;
                const bool far = skip_far_limits && reach.is_far(scene, j);
                limits_skipped += far;
                return far;
            });
        } while (wake_the_joined(scene, now));
    }
    /// (14.5) of each sub-step: what bears too much in any of them breaks, and lets go
    /// when the step ends.
    void end_part(JointedScene& scene, const StepData<3>& now)
    {
        Contacts::end_part(scene, now);
        for (std::size_t i = 0; i < scene.placed.size(); ++i) {
            PlacedJoint& one = scene.placed[i];
            const RigidJoint& joint = one.joint;
            if (one.broken || (joint.breaking_force == infinity &&
                               joint.breaking_torque == infinity))
                continue;
            const Reaction bears = reaction(scene, now, i);
            one.broken = bears.force.norm() > joint.breaking_force ||
                         std::abs(bears.torque) > joint.breaking_torque;
            broken += one.broken;
        }
    }
    template <class Method>
    void end(JointedScene& scene, const StepSettings& settings, Method& method,
             const StepData<3>& now)
    {
        Contacts::end(scene, settings, method, now);
        if (broken == 0) return;
        // what they held may just have fallen asleep
        for (std::size_t i = 0; i < scene.placed.size(); ++i)
            if (scene.placed[i].broken && was_broken[i] == 0)
                wake_ends(scene.placed[i].joint);
    }

    /// A rope that was slack may pull at a sleeper: true if one had to be woken.
    bool wake_the_joined(const JointedScene& scene, const StepData<3>& now)
    {
        if (now.active.empty()) return false;
        bool any = false;
        for (const Source& source : now.sources) {
            if (source.of != Source::Of::joint) continue;
            const PointJoint& joint =
                scene.joints[static_cast<std::size_t>(source.index)];
            for (const Index k : {joint.a, joint.b}) {
                if (k == world || !this->is_asleep(k)) continue;
                this->wake(k);
                any = true;
            }
        }
        return any;
    }

    /// Whatever a joint held wakes when it breaks, or is whole again.
    void wake_the_broken(const JointedScene& scene)
    {
        was_broken.resize(scene.placed.size(), 0);
        for (std::size_t i = 0; i < scene.placed.size(); ++i) {
            const PlacedJoint& one = scene.placed[i];
            if (one.broken == (was_broken[i] != 0)) continue;
            was_broken[i] = one.broken;
            wake_ends(one.joint);
        }
    }

    void wake_ends(const RigidJoint& joint)
    {
        for (const Index k : {joint.a, joint.b})
            if (k != world) this->wake(k);
    }
};
//! [with_joints]

}  // namespace rigid
