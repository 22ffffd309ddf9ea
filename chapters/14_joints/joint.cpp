// The functions of joint.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/14_joints/joint.hpp"

#include <initializer_list>

namespace rigid {

void require_valid(const RigidJoint& joint, std::size_t number,
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
    for (const Real value : {joint.lower, joint.upper, joint.spring.target})
        if (std::isfinite(value) && std::abs(value) > largest_number)
            refuse("has a limit or a target of " + shortest(value) +
                   "; none may be beyond 1e75, but a limit that is infinite");
    if (joint.kind == JointKind::distance && joint.upper < 0)
        refuse("has the upper limit " + shortest(joint.upper) +
               "; no distance is below 0");
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
    const Drive &motor = joint.motor, &spring = joint.spring;
    const auto refuse_idle = [&](std::initializer_list<Real> idle,
                                 const std::string& what) {
        for (const Real value : idle)
            if (value != 0)
                refuse("has a setting of " + shortest(value) +
                       " that does nothing; it has " + what);
    };
    const std::string pull =
        "the stiffness, the damping and the force of its spring";
    if (joint.kind == JointKind::mouse)
        refuse_idle({motor.force, motor.speed, joint.torque, spring.target}, pull);
    if (joint.kind == JointKind::motor)
        refuse_idle({motor.force, motor.speed, spring.target},
                    pull + ", and a torque");
    if (joint.kind == JointKind::friction)
        refuse_idle({motor.speed, spring.force, spring.stiffness, spring.damping,
                     spring.target},
                    "the force of its motor, and a torque");
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
