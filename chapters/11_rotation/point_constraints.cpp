// The functions of point_constraints.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/11_rotation/point_constraints.hpp"

namespace rigid {

void require_valid(const PointJoint& joint, std::size_t number, Index bodies)
{
    const auto refuse = [number](const std::string& what) {
        throw std::invalid_argument("joint " + std::to_string(number) + " " + what);
    };
    if (joint.a < world || joint.a >= bodies || joint.b < 0 || joint.b >= bodies ||
        joint.a == joint.b)
        refuse("joins bodies " + std::to_string(joint.a) + " and " +
               std::to_string(joint.b) + " among " + std::to_string(bodies) +
               "; they must be two, and only a may be the world (−1)");
    const auto finite = [&](const char* what, std::initializer_list<Real> numbers) {
        for (const Real one : numbers)
            if (!std::isfinite(one))
                refuse("has " + std::string(what) + " of " + shortest(one) +
                       "; it must be finite");
    };
    finite("a point", {joint.at_a.x(), joint.at_a.y(), joint.at_b.x(),
                       joint.at_b.y(), joint.over_a.x(), joint.over_a.y(),
                       joint.over_b.x(), joint.over_b.y()});
    finite("a length", {joint.length});
    finite("a gear", {joint.gear_a, joint.gear_b});
    finite("a speed", {joint.speed});
    if (joint.kind == ConstraintKind::spring &&
        !(joint.stiffness >= 0 && joint.damping >= 0 &&
          std::isfinite(joint.stiffness) && std::isfinite(joint.damping) &&
          joint.stiffness + joint.damping > 0))
        refuse("is a spring of the stiffness " + shortest(joint.stiffness) +
               " and the damping " + shortest(joint.damping) +
               "; they must be finite, zero or positive, and not both zero");
    if (!(std::abs(joint.direction.norm() - 1) <= 1e-9))
        refuse("has a direction of the length " + shortest(joint.direction.norm()) +
               "; it must be 1");
    if (!(joint.force >= 0))
        refuse("has the force " + shortest(joint.force) +
               "; it must be zero or positive");
    if (joint.sense != 1 && joint.sense != -1)
        refuse("has the sense " + shortest(joint.sense) + "; it must be 1 or -1");
}

}  // namespace rigid
