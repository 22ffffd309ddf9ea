/// \file joint_rows.hpp
/// A joint is a few rows: which measures of chapter 11 each kind is made of.
///
///     distance   ‖d‖ − L = 0                          revolute   d_x = 0, d_y = 0
///     rope       L − ‖d‖ ≥ 0                          weld       d_x = 0, d_y = 0, θ_b − θ_a = angle
///     prismatic  t·d = 0, θ_b − θ_a = angle           wheel      t·d = 0; a spring along n·d
///     gear       θ_a + ratio θ_b = c                  rack       r θ_a + n·p_b = c
///     pulley     L − ‖p_a − q_a‖ − ratio ‖p_b − q_b‖ ≥ 0
///
/// with d = p_b − p_a, n the axis of a and t = n turned by a quarter, (14.1). Behind them: two limits q − lower ≥ 0 and
/// upper − q ≥ 0, a motor dq/dt = speed, and a spring on q − target.
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
    const auto add_angle = [&] { add(Measure::angle, {1, 0}, joint.angle); };

    switch (joint.kind) {
    //! [kinds]
    case JointKind::distance:
        // with limits or a spring the distance is free between them
        if (joint.lower == -infinity && joint.upper == infinity &&
            !(joint.spring.stiffness > 0) && !(joint.motor.force > 0))
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
        add_pin_rows();
        if (joint.kind == JointKind::mouse) break;
        row.force = joint.torque;
        add_angle();
        break;
    case JointKind::friction:
        row.kind = ConstraintKind::motor;
        row.force = joint.motor.force;
        add_pin_rows();
        row.force = joint.torque;
        add_angle();
        break;
        //! [kinds]
    }
}

//! [drives]
/// The limits, the motor and the spring of a joint's coordinate q.
inline void add_drive_rows(const RigidJoint& joint, std::vector<PointJoint>& rows)
{
    if (!has_coordinate(joint.kind)) return;
    const PointJoint q = coordinate_row(joint);
    if (joint.lower == joint.upper) {  // locked: one row, both ways
        rows.push_back(q);
        rows.back().length += joint.lower;
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
    if (joint.motor.force > 0) {
        rows.push_back(q);
        rows.back().kind = ConstraintKind::motor;
        rows.back().speed = joint.motor.speed;
        rows.back().force = joint.motor.force;
    }
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

//! [place]
/// Adds a joint to a scene.
/// \return  its number
/// Throws std::invalid_argument, with a sentence, for a joint that makes no sense.
inline std::size_t add_joint(JointedScene& scene, const RigidJoint& joint)
{
    require_valid(joint, scene.placed.size(), scene.bodies);
    PlacedJoint placed;
    placed.joint = joint;
    placed.first = static_cast<int>(scene.joints.size());
    add_frame_rows(joint, scene.joints);
    add_drive_rows(joint, scene.joints);
    placed.count = static_cast<int>(scene.joints.size()) - placed.first;
    scene.owner.resize(static_cast<std::size_t>(placed.first), -1);
    scene.owner.resize(scene.joints.size(), static_cast<int>(scene.placed.size()));
    scene.placed.push_back(placed);
    return scene.placed.size() - 1;
}
//! [place]

/// The point of body k that is at a place of the world now; of the world: the place.
inline Vec2 local_point(const RigidScene& scene, Index k, const Vec2& place)
{
    if (k == world) return place;
    const Vec2 d = place - scene.bodies.position(k).head<2>();
    const Real c = std::cos(scene.bodies.x[3 * k + 2]),
               s = std::sin(scene.bodies.x[3 * k + 2]);
    return {c * d.x() + s * d.y(), c * d.y() - s * d.x()};
}

/// A joint of two bodies at one place of the world, where their frames are to be as they are now.
inline RigidJoint joint_at(const RigidScene& scene, JointKind kind, Index a,
                           Index b, const Vec2& place)
{
    RigidJoint joint;
    joint.kind = kind;
    joint.a = a, joint.b = b;
    joint.at_a = local_point(scene, a, place);
    joint.at_b = local_point(scene, b, place);
    joint.angle =
        scene.bodies.x[3 * b + 2] - (a == world ? 0 : scene.bodies.x[3 * a + 2]);
    return joint;
}

/// q of a joint that has one, at the positions x [m, rad].
inline Real coordinate(const VecX& x, const RigidJoint& joint)
{
    return joint_constraint(x, coordinate_row(joint)).C;
}

/// Another joint in the place of one: the same kind and bodies, and as many rows.
/// Throws std::invalid_argument where that is not so: a motor that is to be switched on later starts with a force above 0.
inline void change_joint(JointedScene& scene, std::size_t number,
                         const RigidJoint& joint)
{
    PlacedJoint& placed = scene.placed.at(number);
    require_valid(joint, number, scene.bodies);
    std::vector<PointJoint> rows;
    add_frame_rows(joint, rows);
    add_drive_rows(joint, rows);
    if (static_cast<int>(rows.size()) != placed.count ||
        joint.kind != placed.joint.kind || joint.a != placed.joint.a ||
        joint.b != placed.joint.b)
        throw std::invalid_argument(
            "joint " + std::to_string(number) + " has " +
            std::to_string(placed.count) + " rows and would have " +
            std::to_string(rows.size()) +
            "; a joint keeps its kind, its bodies and the number of its rows");
    std::copy(rows.begin(), rows.end(), scene.joints.begin() + placed.first);
    placed.joint = joint;
}

}  // namespace rigid
