/// \file joint_rows.hpp
/// A joint is a few rows: which measures of chapter 11 each kind is made of.
///
///     distance   ‖d‖ − L = 0                          revolute   d_x = 0, d_y = 0
///     rope       L − ‖d‖ ≥ 0                          weld       d_x = 0, d_y = 0, θ_b − θ_a = angle
///     prismatic  t·d = 0, θ_b − θ_a = angle           wheel      t·d = 0; a spring along n·d
///     gear       θ_a + ratio θ_b = c                  rack       r (θ_a − θ_b) + n·d = c
///     pulley     L − ‖p_a − q_a‖ − ratio ‖p_b − q_b‖ ≥ 0
///     mouse      springs on e₁·d and e₂·d              motor      those, and on θ_b − θ_a
///     friction   motors of speed 0 on these three
///
/// with d = p_b − p_a, e₁ and e₂ the axes of a, n the axis of a (of a rack: of b) and t = n turned by a quarter.
/// Behind them: two limits q − lower ≥ 0 and upper − q ≥ 0, a motor dq/dt = speed (of a wheel dθ/dt), and a spring on
/// q − target.
///
/// The last three kinds may have their points apart. Two opposite forces at p_a and p_b would then be a couple out of nothing,
/// unless they are along d. As e₁ and e₂ turn with a, the true derivative of e·d is the velocity of b at p_b against that of a
/// carried on to the same place: both forces act at p_b, and momentum is kept whatever bounds and damping do.
#pragma once

#include "chapters/11_rotation/point_constraints.hpp"
#include "chapters/14_joints/joint.hpp"

namespace rigid {

/// What a joint's free coordinate q is, as a row of chapter 11: C = q.
inline PointJoint coordinate_row(const RigidJoint& joint)
{
    using Measure = PointJoint::Measure;
    PointJoint q;
    q.a = joint.a, q.b = joint.b;
    q.at_a = joint.at_a, q.at_b = joint.at_b;
    q.direction = joint.axis;
    q.collides = joint.collide_connected;
    q.measure = Measure::turning;
    if (joint.kind == JointKind::distance) q.measure = Measure::distance;
    if (joint.kind == JointKind::revolute) {
        q.measure = Measure::angle;
        q.length = joint.angle;
    }
    return q;
}

/// The rows that hold two frames together: no limits, no drives.
inline void add_frame_rows(const RigidJoint& joint, std::vector<PointJoint>& rows)
{
    using Measure = PointJoint::Measure;
    PointJoint row = coordinate_row(joint);
    const auto add = [&](Measure measure, const Vec2& direction, Real length) {
        row.measure = measure;
        row.direction = direction;
        row.length = length;
        rows.push_back(row);
    };
    const auto add_pin_rows = [&] {
        add(Measure::along, {1, 0}, 0);
        add(Measure::along, {0, 1}, 0);
    };
    // of two points that may be apart: both bodies are pushed at p_b
    const auto add_place_rows = [&] {
        add(Measure::turning, {1, 0}, 0);
        add(Measure::turning, {0, 1}, 0);
    };
    const auto add_angle = [&] { add(Measure::angle, {1, 0}, joint.angle); };

    switch (joint.kind) {
    //! [kinds]
    case JointKind::distance:
        // with limits, a motor or a spring (or damper) the distance is free
        if (joint.lower == -infinity && joint.upper == infinity &&
            !(joint.spring.stiffness + joint.spring.damping > 0) &&
            !(joint.motor.force > 0))
            add(Measure::distance, {1, 0}, joint.length);
        break;
    case JointKind::rope:
        row.kind = ConstraintKind::unilateral;
        row.sense = -1;
        add(Measure::distance, {1, 0}, joint.length);
        break;
    case JointKind::revolute:
        add_pin_rows();
        break;
    case JointKind::prismatic:
        add(Measure::turning, perpendicular(joint.axis), 0);
        add_angle();
        break;
    case JointKind::weld:
        add_pin_rows();
        add_angle();
        break;
    case JointKind::wheel:
        add(Measure::turning, perpendicular(joint.axis), 0);
        break;
    case JointKind::gear:
        row.gear_a = 1, row.gear_b = joint.ratio;
        add(Measure::angle, {1, 0}, joint.length);
        break;
    case JointKind::rack:
        row.gear_a = joint.ratio, row.gear_b = 1;
        add(Measure::rack, joint.axis, joint.length);
        break;
    case JointKind::pulley:
        row.kind = ConstraintKind::unilateral;
        row.sense = -1;
        row.gear_a = 1, row.gear_b = joint.ratio;
        row.over_a = joint.over_a, row.over_b = joint.over_b;
        add(Measure::pulley, {1, 0}, joint.length);
        break;
    case JointKind::mouse:
    case JointKind::motor:
        row.kind = ConstraintKind::spring;
        row.stiffness = joint.spring.stiffness;
        row.damping = joint.spring.damping;
        row.force = joint.spring.force;
        add_place_rows();
        if (joint.kind == JointKind::mouse) break;
        row.force = joint.torque;
        add_angle();
        break;
    case JointKind::friction:
        row.kind = ConstraintKind::motor;
        row.force = joint.motor.force;
        add_place_rows();
        row.force = joint.torque;
        add_angle();
        break;
        //! [kinds]
    }
}

//! [drives]
/// The limits, the motor and the spring of a joint's coordinate q; the motor of a
/// wheel turns it.
inline void add_drive_rows(const RigidJoint& joint, std::vector<PointJoint>& rows)
{
    if (!has_coordinate(joint.kind)) return;
    const PointJoint q = coordinate_row(joint);
    const auto add_motor = [&] {
        if (!(joint.motor.force > 0)) return;
        rows.push_back(q);
        // a wheel's motor turns it: its q is the way of its spring
        if (joint.kind == JointKind::wheel)
            rows.back().measure = PointJoint::Measure::angle;
        rows.back().kind = ConstraintKind::motor;
        rows.back().speed = joint.motor.speed;
        rows.back().force = joint.motor.force;
    };
    if (joint.lower == joint.upper) {  // locked: one row, both ways
        rows.push_back(q);
        rows.back().length += joint.lower;
        if (joint.kind == JointKind::wheel) add_motor();
        return;
    }
    for (const Real sense : {1.0, -1.0}) {  // q − lower ≥ 0, upper − q ≥ 0
        const Real limit = sense > 0 ? joint.lower : joint.upper;
        if (!std::isfinite(limit)) continue;
        rows.push_back(q);
        rows.back().kind = ConstraintKind::unilateral;
        rows.back().sense = sense;
        rows.back().length += limit;
    }
    add_motor();
    if (joint.spring.stiffness + joint.spring.damping > 0) {
        rows.push_back(q);
        rows.back().kind = ConstraintKind::spring;
        rows.back().stiffness = joint.spring.stiffness;
        rows.back().damping = joint.spring.damping;
        rows.back().force = joint.spring.force;
        rows.back().length += joint.spring.target;
    }
}
//! [drives]

/// q of a joint that has one, at the positions x [m, rad].
inline Real coordinate(const VecX& x, const RigidJoint& joint)
{
    return joint_constraint(x, coordinate_row(joint)).C;
}

}  // namespace rigid
