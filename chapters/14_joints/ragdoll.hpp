/// \file ragdoll.hpp
/// A doll of ten limbs: nine revolute joints with limits, and friction that keeps them from swinging forever.
#pragma once

#include "chapters/14_joints/placed_joints.hpp"

namespace rigid {

/// Adds a doll of about 1.7 m and 70 kg that stands upright.
/// \param at        its hip [m]
/// \param friction  torque that a joint resists with [N m]
/// \return          the number of its first body; it has ten
Index add_ragdoll(JointedScene& scene, const Vec2& at, Real friction = 2);

/// What of a doll would overlap by how it is made: it does not collide with itself.
/// \param forbid  void(Index a, Index b)
template <class Forbid>
void forbid_itself(Index first, const Forbid& forbid)
{
    for (Index a = first; a < first + 10; ++a)
        for (Index b = a + 1; b < first + 10; ++b) forbid(a, b);
}

/// Steps of a staircase that goes down to the right, as bodies that cannot move, and a floor.
inline void add_stairs(JointedScene& scene, int steps)
{
    for (int i = 0; i < steps; ++i)
        add_body(scene, box(0.6, 0.3), Mass{}, {0.6 * i, 0.3 * (steps - i) - 0.15});
    scene.walls.push_back({{0, 1}, 0});
}

}  // namespace rigid
