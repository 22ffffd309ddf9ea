/// \file joint_coordinates.hpp
/// Joints in their own coordinates: one frame in either body, eight numbers that say how they lie to each other, and
/// the row of each of them.
///
///     d = R_Aᵀ (p_b − p_a)          q = q_A⁻¹ q_B                 the frames A of body a and B of body b
///     along:   Jb = (n, R_bᵀ (r_b × n)),  Ja = −(n, R_aᵀ ((r_a + p_b − p_a) × n)),  n an axis of A         (21.4)
///     turning: g(q) with the gradient (g_w, g_v):  ġ = ρ · R_Bᵀ (ω_b − ω_a),  ρ = ½ (w g_v − g_w v + g_v × v)  (21.6)
///
/// A coordinate that is locked is a bilateral row, one with limits a unilateral row at the limit that is nearer.
#pragma once

#include "chapters/02_velocity_constraints/constraint_kinds.hpp"
#include "chapters/21_joints_in_space/space_joint.hpp"
#include "common/elementary.hpp"

namespace rigid {

/// The frames of a joint where the bodies are.
struct JointFrames {
    Mat3 Ra, Rb;        ///< the bodies' axes
    Mat3 A, B;          ///< the joint's axes, seen from the world
    Vec3 arm_a, arm_b;  ///< from the bodies' origins to the joint's points
    Vec3 way;           ///< p_b − p_a
    Quaternion q;       ///< from A to B, with w ≥ 0
};

JointFrames frames_of(const VecX& x, const SpaceJoint& joint);

/// The value of a coordinate of rotation, and its gradient over the four numbers of q.
struct Turn {
    Real value = 0, over_w = 0;
    Vec3 over_v = {0, 0, 0};
};

//! [turn]
inline Turn turn_of(Coordinate which, const Quaternion& q)
{
    if (which == swing_y) return {2 * q.v[1], 0, {0, 2, 0}};
    if (which == swing_z) return {2 * q.v[2], 0, {0, 0, 2}};
    if (which == pins)
        return {2 * (q.w * q.v[0] + q.v[1] * q.v[2]),
                2 * q.v[0],
                {2 * q.w, 2 * q.v[2], 2 * q.v[1]}};
    const Real along = q.w * q.w + q.v[0] * q.v[0],
               across = q.v[1] * q.v[1] + q.v[2] * q.v[2];
    if (which == twist) {
        const Turn t{2 * atan2(q.v[0], q.w)};
        if (!(along > 0)) return t;  // turned over: any twist is as good
        return {t.value, -2 * q.v[0] / along, {2 * q.w / along, 0, 0}};
    }
    const Real c = std::sqrt(along), s = std::sqrt(across);
    const Turn t{2 * atan2(s, c)};
    if (!(s > 0 && c > 0)) return t;  // straight: it leans to no side
    return {t.value,
            -2 * s / c * q.w,
            {-2 * s / c * q.v[0], 2 * c / s * q.v[1], 2 * c / s * q.v[2]}};
}
//! [turn]

//! [coordinate]
/// (21.4), (21.6): the value of a coordinate in C, and its derivative.
inline Constraint<6> coordinate_of(const JointFrames& f, const SpaceJoint& joint,
                                   Coordinate which)
{
    Constraint<6> c;
    c.a = joint.a, c.b = joint.b;
    if (which < twist) {
        const Vec3 n = f.A.col(which);
        c.C = n.dot(f.way);
        c.Jb << n.transpose(), (f.Rb.transpose() * cross(f.arm_b, n)).transpose();
        c.Ja << -n.transpose(),
            -(f.Ra.transpose() * cross(f.arm_a + f.way, n)).transpose();
    } else {
        const Turn g = turn_of(which, f.q);
        const Vec3 rho =
            (f.q.w * g.over_v - g.over_w * f.q.v + cross(g.over_v, f.q.v)) / 2;
        const Vec3 direction = f.B * rho;  // seen from the world
        c.C = g.value;
        c.Jb << 0, 0, 0, (f.Rb.transpose() * direction).transpose();
        c.Ja << 0, 0, 0, -(f.Ra.transpose() * direction).transpose();
    }
    if (c.a == world) c.Ja.setZero();
    return c;
}
//! [coordinate]

/// The rows of a joint are numbered: two for each coordinate, the motor's last.
inline constexpr int motor_slot = 2 * coordinates, joint_slots = motor_slot + 1;

//! [limited]
/// The value of a coordinate as its limits count it. A twist is an angle but for
/// whole turns: of all that it may be, that nearest to the middle of both limits.
inline Real limited_value(const SpaceJoint& joint, int which, Real value)
{
    const auto i = static_cast<std::size_t>(which);
    const Real middle = (joint.lo[i] + joint.hi[i]) / 2;
    if (which != twist || !std::isfinite(middle)) return value;
    return value + 2 * pi * std::round((middle - value) / (2 * pi));
}
//! [limited]

//! [slot]
/// The constraint of one slot of a joint: locked or kept above its least value (2c),
/// kept below its greatest (2c + 1), or driven.
inline Constraint<6> joint_constraint(const JointFrames& f, const SpaceJoint& joint,
                                      int slot)
{
    const int which = slot == motor_slot ? joint.motor : slot / 2;
    const auto i = static_cast<std::size_t>(which);
    Constraint<6> c = coordinate_of(f, joint, static_cast<Coordinate>(which));
    if (slot == motor_slot) {
        c.kind = ConstraintKind::motor;
        c.speed = joint.speed, c.force = joint.force;
        return c;
    }
    c.C = limited_value(joint, which, c.C);
    if (slot % 2 == 0) {
        c.C -= joint.lo[i];
        c.kind = joint.locked(which) ? ConstraintKind::bilateral
                                     : ConstraintKind::unilateral;
    } else {
        c.C = joint.hi[i] - c.C;
        c.Ja = -c.Ja, c.Jb = -c.Jb;
        c.kind = ConstraintKind::unilateral;
    }
    return c;
}
//! [slot]

/// Calls visit(slot) for each row that the joint has where the bodies are.
template <class Visit>
void for_each_slot(const JointFrames& f, const SpaceJoint& joint,
                   const Visit& visit)
{
    for (int c = 0; c < coordinates; ++c) {
        const Real lo = joint.lo[static_cast<std::size_t>(c)],
                   hi = joint.hi[static_cast<std::size_t>(c)];
        if (joint.locked(c)) visit(2 * c);
        else if (std::isfinite(lo) || std::isfinite(hi)) {
            const Real value = limited_value(
                joint, c, coordinate_of(f, joint, static_cast<Coordinate>(c)).C);
            visit(value - lo < hi - value ? 2 * c : 2 * c + 1);
        }
    }
    if (joint.motor >= 0) visit(motor_slot);
}

/// The largest |C| of a locked coordinate of all joints [m, rad]; 0 without any.
Real largest_joint_error(const JointedSolids& scene);

}  // namespace rigid
