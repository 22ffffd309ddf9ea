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
    Real torque = 0;  ///< of the kinds friction and motor: at most [N m]
    /// of the mean over a sub-step: an impulse P counts as P/h [N, N m]
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
inline void require_valid(const RigidJoint& joint, std::size_t number,
                          const Bodies<3>& bodies)
{
    const auto refuse = [&](const std::string& what) {
        throw std::invalid_argument("the " + std::string(to_string(joint.kind)) +
                                    " joint " + std::to_string(number) + " " +
                                    what);
    };
    const auto positive = [&](Real value, const std::string& name, bool bounded) {
        if (!(value >= 0) || (bounded && !std::isfinite(value)))
            refuse("has the " + name + " " + shortest(value) +
                   "; it must be zero or positive" +
                   (bounded ? " and finite" : ""));
    };
    const Index count = bodies.count();
    if (joint.a < world || joint.a >= count || joint.b < 0 || joint.b >= count)
        refuse("joins bodies " + std::to_string(joint.a) + " and " +
               std::to_string(joint.b) + " among " + std::to_string(count) +
               "; only its a may be the world (-1)");
    if (joint.a == joint.b)
        refuse("joins body " + std::to_string(joint.a) +
               " to itself; it needs two bodies");
    if (!bodies.can_move(joint.a) && !bodies.can_move(joint.b))
        refuse("joins bodies " + std::to_string(joint.a) + " and " +
               std::to_string(joint.b) +
               ", which cannot move; one of them must have a mass");
    if (!joint.at_a.allFinite() || !joint.at_b.allFinite() ||
        !joint.over_a.allFinite() || !joint.over_b.allFinite() ||
        !std::isfinite(joint.angle) || !std::isfinite(joint.length) ||
        !std::isfinite(joint.ratio) || !std::isfinite(joint.motor.speed) ||
        !std::isfinite(joint.spring.target))
        refuse("has a frame, a length, a ratio, a speed or a target that is not "
               "finite");
    for (const Real length :
         {joint.at_a.x(), joint.at_a.y(), joint.at_b.x(), joint.at_b.y(),
          joint.over_a.x(), joint.over_a.y(), joint.over_b.x(), joint.over_b.y(),
          joint.length, joint.ratio, joint.angle})
        if (std::abs(length) > largest_number)
            refuse("has a frame, a length or a ratio of " + shortest(length) +
                   "; none may be beyond 1e75");
    if (!(std::abs(joint.axis.norm() - 1) <= 1e-9))
        refuse("has an axis of the length " + shortest(joint.axis.norm()) +
               "; it must be 1");
    if (!(joint.lower <= joint.upper))
        refuse("has the lower limit " + shortest(joint.lower) + " and the upper " +
               shortest(joint.upper) + "; lower must not be above upper");
    if (joint.lower == infinity || joint.upper == -infinity)
        refuse("has the limits " + shortest(joint.lower) + " and " +
               shortest(joint.upper) + "; no number is between them");
    const bool driven = joint.motor.force > 0 || joint.spring.stiffness > 0 ||
                        joint.spring.damping > 0;
    const bool poses = joint.kind == JointKind::mouse ||
                       joint.kind == JointKind::friction ||
                       joint.kind == JointKind::motor;
    if (!has_coordinate(joint.kind) &&
        (joint.lower > -infinity || joint.upper < infinity || (driven && !poses)))
        refuse("has limits, a motor or a spring; it has no coordinate that they "
               "could act on");
    if (joint.kind != JointKind::gear && joint.kind != JointKind::rack)
        positive(joint.length, "length", true);
    positive(joint.motor.force, "motor force", false);
    positive(joint.spring.force, "spring force", false);
    positive(joint.spring.stiffness, "stiffness", true);
    positive(joint.spring.damping, "damping", true);
    positive(joint.torque, "torque", false);
    positive(joint.breaking_force, "breaking force", false);
    positive(joint.breaking_torque, "breaking torque", false);
    if ((joint.kind == JointKind::mouse || joint.kind == JointKind::motor) &&
        !(joint.spring.stiffness + joint.spring.damping > 0))
        refuse("pulls by a spring of no stiffness and no damping; give it one");
}

}  // namespace rigid
