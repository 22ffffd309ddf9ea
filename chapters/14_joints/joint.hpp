/// \file joint.hpp
/// What a joint is to the user: two bodies, a frame in each, and what may move.
///
///     q = the coordinate that the joint leaves free       its limits, its motor and its spring act along q
///
/// The frames are points and an axis in the axes of the bodies; of the world, in the world's. A joint becomes rows in
/// joint_rows.hpp; no solver learns of it.
#pragma once

#include "chapters/13_friction/surfaces.hpp"
#include "common/text.hpp"

#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace rigid {

enum class JointKind : unsigned char {
    distance,   ///< two points keep a distance; q is the distance
    rope,       ///< they are never farther apart than that
    revolute,   ///< one point in common; q = θ_b − θ_a − angle
    prismatic,  ///< b slides along an axis of a without turning; q along the axis
    weld,       ///< nothing is free
    wheel,      ///< b slides along an axis of a on a spring, and turns
    gear,       ///< θ_a + ratio θ_b stays
    rack,  ///< radius (θ_a − θ_b) + n·d stays: b rolls on the pinion a, n is of b
    pulley,  ///< ‖p_a − q_a‖ + ratio ‖p_b − q_b‖ is never above a length
    // of these three a force is bounded along each axis of a
    mouse,     ///< a spring of bounded force pulls a point of b to one of a
    friction,  ///< resists all relative motion, with a bounded force and torque
    motor,  ///< drives the pose of b in a to a target, by springs of bounded force
};

/// How many kinds there are; a new one stands before `mouse`.
constexpr int joint_kind_count = static_cast<int>(JointKind::motor) + 1;

constexpr std::string_view to_string(JointKind kind)
{
    constexpr std::string_view names[] = {
        "distance", "rope", "revolute", "prismatic", "weld",     "wheel",
        "gear",     "rack", "pulley",   "mouse",     "friction", "motor"};
    static_assert(std::size(names) == joint_kind_count, "each kind has a name");
    return names[static_cast<std::size_t>(kind)];
}

//! [joint]
/// A force along q that has a bound: a motor has a speed, a spring a target. The
/// motor of a wheel turns it.
struct Drive {
    Real speed = 0;      ///< of a motor: the wanted dq/dt [m/s, rad/s]
    Real force = 0;      ///< at most; of a motor 0 = none, of a spring 0 = any
    Real stiffness = 0;  ///< of a spring [N/m, N m]
    Real damping = 0;    ///< of a spring [N s/m, N m s]
    Real target = 0;     ///< of a spring: the q where it rests [m, rad]
};

struct RigidJoint {
    JointKind kind = JointKind::revolute;
    Index a = world, b = 0;
    Vec2 at_a = {0, 0}, at_b = {0, 0};  ///< the points of the frames [m]
    Vec2 axis = {1, 0};  ///< unit vector, in the axes of a; of a rack, of b
    Real angle = 0;      ///< θ_b − θ_a where the two frames are parallel [rad]
    Real length = 0;     ///< that is kept; of a rack C is zero there [m, rad]
    Real ratio = 1;      ///< of gear and pulley; of a rack the pinion's radius [m]
    Vec2 over_a = {0, 0}, over_b = {0, 0};     ///< of a pulley, in the world
    Real lower = -infinity, upper = infinity;  ///< limits of q; equal = locked
    Drive motor, spring;
    Real torque = 0;  ///< of friction: at most; of motor the same, 0 = any [N m]
    /// of the mean over a sub-step, in any of a step: an impulse P counts as P/h
    /// [N, N m]
    Real breaking_force = infinity, breaking_torque = infinity;
    bool collide_connected = false;  ///< may its two bodies touch?
};
//! [joint]

/// A joint in a scene: which of scene.joints are its rows.
struct PlacedJoint {
    RigidJoint joint;
    int first = 0, count = 0;
    bool broken = false;
};

/// Bodies, surfaces, and joints. The rows of the joints are in scene.joints, as chapter 11 has them.
struct JointedScene : RoughScene {
    std::vector<PlacedJoint> placed;
    std::vector<int> owner;  ///< of each of scene.joints: which joint; −1 = none
};

/// Whether the two bodies of a joint may turn against each other freely, slide freely: where limits and motors make sense.
constexpr bool has_coordinate(JointKind kind)
{
    return kind == JointKind::distance || kind == JointKind::revolute ||
           kind == JointKind::prismatic || kind == JointKind::wheel;
}

/// Throws std::invalid_argument, naming the joint, the value and what would be right, unless it makes sense.
/// \param number  what to call it
void require_valid(const RigidJoint& joint, std::size_t number,
                   const Bodies<3>& bodies);

}  // namespace rigid
