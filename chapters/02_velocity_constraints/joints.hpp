/// \file joints.hpp
/// The joints of a scene as constraints: C, J and the kind, at any positions.
///
///     rail   C = nᵀ(x_b − x_a) − c = 0             motor   d/dt of the same C is a given speed, |F| limited
///     stop   the same C ≥ 0                        rope    C = L − ‖x_b − x_a‖ ≥ 0
///
/// A new kind of joint is added here and in common/shapes.hpp, and nowhere else.
#pragma once

#include "chapters/02_velocity_constraints/geometry.hpp"

namespace rigid {

//! [rope]
/// The distance of two bodies is at most that of the link: \f$C = L - \lVert x_b -
/// x_a \rVert\f$, unilateral.
inline Constraint<2> slack_constraint(const VecX& x, const Link& link)
{
    Constraint<2> rod = distance_constraint(x, link);
    return {rod.a, rod.b, -rod.C, -rod.Ja, -rod.Jb, ConstraintKind::unilateral};
}
//! [rope]

//! [joint]
/// C and J of a joint at the positions x.
inline Constraint<2> joint_constraint(const VecX& x, const Joint& joint)
{
    if (joint.kind == Joint::Kind::rope)
        return slack_constraint(x, {joint.a, joint.b, joint.length});
    Constraint<2> along =
        alignment_constraint<2>(x, joint.a, joint.b, joint.direction, joint.length);
    if (joint.kind == Joint::Kind::stop) along.kind = ConstraintKind::unilateral;
    if (joint.kind == Joint::Kind::motor) {
        along.kind = ConstraintKind::motor;
        along.speed = joint.speed;
        along.force = joint.force;
    }
    return along;
}
//! [joint]

}  // namespace rigid
