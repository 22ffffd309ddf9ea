/// \file resting_forces.hpp
/// What sleepers bear: the forces with which their islands fell asleep, by the names of the rows.
#pragma once

#include "chapters/19_engine/world_state.hpp"

namespace rigid {

/// Whether body k sleeps; neither the world does nor what no step has seen, also where
/// another body had its place.
inline bool is_asleep(const EngineState& state, Index k)
{
    const AwakeSet& set = state.awake().set;
    return k != world && k < static_cast<Index>(set.activity.size()) &&
           set.is_asleep(k) && state.was_there(k);
}

//! [resting]
/// Calls visit(key, force [N]) for each row of a sleeper's island.
template <class Visit>
void for_each_resting_force(const EngineState& state, Index k, const Visit& visit)
{
    const ToldManifolds& sleepers = state.awake();
    const SleepingForces& forces = sleepers.forces;
    auto body = static_cast<std::size_t>(k);
    do {
        for (int e = forces.head[body]; e >= 0;) {
            const SleepingForces::Entry& entry =
                forces.entries[static_cast<std::size_t>(e)];
            visit(entry.key, entry.force);
            e = entry.next;
        }
        body = static_cast<std::size_t>(sleepers.set.ring[body]);
    } while (body != static_cast<std::size_t>(k));
}

/// (14.5) of a joint of sleeper k, with the J that its rows have where all rest.
inline Reaction resting_reaction(const EngineState& state, std::size_t number,
                                 Index k)
{
    const JointedScene& scene = state.scene;
    const VecX& x = scene.bodies.x;
    const PlacedJoint& placed = scene.placed[number];
    Vec<3> sum = Vec<3>::Zero();
    for_each_resting_force(state, k, [&](const ImpulseKey& key, Real force) {
        if (key.first != ImpulseKey::of_a_machine || key.second < placed.first ||
            key.second >= placed.first + placed.count)
            return;
        const PointJoint& row = scene.joints[static_cast<std::size_t>(key.second)];
        const Constraint<3> c = key.part == 0 ? joint_constraint(x, row)
                                              : across_line(x, row, key.part);
        if (c.b == placed.joint.b) sum += force * c.Jb.transpose();
    });
    const Vec2 arm = point_of(x, placed.joint.b, placed.joint.at_b) -
                     scene.bodies.position(placed.joint.b).head<2>();
    const Vec2 P = sum.head<2>();
    return {P, sum[2] - cross2(arm, P)};
}
//! [resting]

}  // namespace rigid
