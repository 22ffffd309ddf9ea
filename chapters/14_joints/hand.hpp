/// \file hand.hpp
/// A hand that drags any body: a mouse joint, made for what it has to lift.
///
///     k = m ω²,  c = 2 m ω,  |F_x|, |F_y| ≤ 10 m g   m = all that joints hold together with the body, ω = 2π · 3 Hz,
///                                                    g at least 1 m/s², so that it pulls without gravity too
///
/// A spring and its bound, so it is a row with bounds, and joints have none: solved exactly, the hand never tears a joint
/// open. \cite catto2011
#pragma once

#include "chapters/14_joints/placed_joints.hpp"
#include "common/union_find.hpp"

#include <numeric>

namespace rigid {

/// Mass of all bodies that joints hold together with body k [kg].
/// Throws std::invalid_argument unless there is such a body; the world is not held.
inline Real held_mass(const JointedScene& scene, Index k)
{
    if (k < 0 || k >= scene.bodies.count())
        throw std::invalid_argument(
            "a hand holds body " + std::to_string(k) + "; it must be one of the " +
            std::to_string(scene.bodies.count()) + " bodies, from 0 on");
    std::vector<int> lowest(static_cast<std::size_t>(scene.bodies.count()));
    std::iota(lowest.begin(), lowest.end(), 0);
    for (const PlacedJoint& placed : scene.placed)
        if (!placed.broken && placed.joint.a != world &&
            scene.bodies.can_move(placed.joint.a) &&
            scene.bodies.can_move(placed.joint.b))
            unite(lowest, static_cast<int>(placed.joint.a),
                  static_cast<int>(placed.joint.b));
    const int wanted = lowest_of(lowest, static_cast<int>(k));
    Real mass = 0;
    for (Index i = 0; i < scene.bodies.count(); ++i) {
        const Real inverse = scene.bodies.inverse_mass[3 * i];
        if (inverse > 0 && lowest_of(lowest, static_cast<int>(i)) == wanted)
            mass += 1 / inverse;
    }
    return mass;
}

//! [hand]
/// The joint by which a hand at a place of the world holds body k there.
inline RigidJoint hand_joint(const JointedScene& scene, Index k, const Vec2& place)
{
    const Real m = held_mass(scene, k), omega = 2 * pi * 3;
    RigidJoint hand = joint_at(scene, JointKind::mouse, world, k, place);
    hand.spring = {0, 10 * m * std::max(scene.gravity.norm(), Real{1}),
                   m * omega * omega, 2 * m * omega, 0};
    return hand;
}
//! [hand]

/// The hand at another place.
inline void move_hand(JointedScene& scene, std::size_t number, const Vec2& place)
{
    RigidJoint hand = scene.placed.at(number).joint;
    hand.at_a = place;
    change_joint(scene, number, hand);
}

}  // namespace rigid
