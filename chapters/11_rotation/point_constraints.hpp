/// \file point_constraints.hpp
/// The constraints of Part I on points that are not centres: C as before, and J with a third column.
///
///     p = x + R(θ) r,  ṗ = v + ω × r          every J below is n times that
///     distance   C = ‖p_b − p_a‖ − L           J = (−n, −r_a × n),  (n, r_b × n),  n = (p_b − p_a)/‖p_b − p_a‖
///     along      C = n·(p_b − p_a) − c         the same J with a given n
///     turning    n turns with a                J_a = (−n, −(r_a + p_b − p_a) × n)
///     angle      C = g_a θ_a + g_b θ_b − c     J = (0, 0, g_a), (0, 0, g_b)
///     pulley     C = Σ g ‖p − q‖ − c           J = g (n, r × n),  n = (p − q)/‖p − q‖, of either body
///     rack       C = g_a (θ_a − θ_b) + g_b n·(p_b − p_a) − c, n turns with b: turning with a and b exchanged
///     corner     C = n·p − c − ρ ≥ 0           J = (n, r × n)
///     contact    C = n·(p_b − p_a) − ρ ≥ 0     (−n, −r_a × n), (n, r_b × n),  turning where n is of a face of a or b
///
/// (11.6), (11.13), (11.14). θ is a number like any other and is wrapped nowhere: a gear that has turned ten times is at 20π.
#pragma once

#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/11_rotation/rigid_scene.hpp"
#include "common/contact.hpp"
#include "common/elementary.hpp"

namespace rigid {

//! [point_row]
/// (11.6): n·(velocity of a point) as a row: (n, r × n), with r from the centroid
/// to the point.
inline RowVec<3> point_row(const Vec2& r, const Vec2& n)
{
    return {n.x(), n.y(), cross2(r, n)};
}
//! [point_row]

/// Throws std::invalid_argument, naming the joint and the value, unless it makes sense among so many bodies.
void require_valid(const PointJoint& joint, std::size_t number, Index bodies);

//! [joint]
/// C and J of a joint at the positions x.
/// \param turns  memory of point_of(); may be null
inline Constraint<3> joint_constraint(const VecX& x, const PointJoint& joint,
                                      Turns* turns = nullptr)
{
    using Measure = PointJoint::Measure;
    Constraint<3> c;
    c.a = joint.a, c.b = joint.b, c.kind = joint.kind, c.speed = joint.speed,
    c.force = joint.force, c.stiffness = joint.stiffness, c.damping = joint.damping;
    const auto centre = [&x](Index k) {
        return k == world ? Vec2(0, 0) : Vec2(x.segment<2>(3 * k));
    };
    const auto angle = [&x](Index k) { return k == world ? 0 : x[3 * k + 2]; };
    if (joint.measure == Measure::angle) {
        c.C = joint.gear_a * angle(c.a) + joint.gear_b * angle(c.b) - joint.length;
        c.Ja = {0, 0, joint.gear_a};
        c.Jb = {0, 0, joint.gear_b};
    } else if (joint.measure == Measure::pulley) {
        const Vec2 pa = point_of(x, c.a, joint.at_a, turns),
                   pb = point_of(x, c.b, joint.at_b, turns);
        const Direction da(pa - joint.over_a), db(pb - joint.over_b);
        c.C = joint.gear_a * da.length + joint.gear_b * db.length - joint.length;
        c.Ja = joint.gear_a * point_row(pa - centre(c.a), da.n);
        c.Jb = joint.gear_b * point_row(pb - centre(c.b), db.n);
    } else if (joint.measure == Measure::rack) {
        const Vec2 pa = point_of(x, c.a, joint.at_a, turns),
                   pb = point_of(x, c.b, joint.at_b, turns),
                   n = point_of(x, c.b, joint.direction, turns) - centre(c.b);
        c.C = joint.gear_a * (angle(c.a) - angle(c.b)) +
              joint.gear_b * n.dot(pb - pa) - joint.length;
        c.Ja = -joint.gear_b * point_row(pa - centre(c.a), n);
        c.Jb = joint.gear_b * point_row(pa - centre(c.b), n);  // n turns with b
        c.Ja[2] += joint.gear_a, c.Jb[2] -= joint.gear_a;
    } else {
        const Vec2 pa = point_of(x, c.a, joint.at_a, turns),
                   pb = point_of(x, c.b, joint.at_b, turns), d = pb - pa;
        Vec2 n = joint.direction, arm = pa - centre(c.a);
        if (joint.measure == Measure::distance) n = Direction(d).n;
        if (joint.measure == Measure::turning && c.a != world) {
            n = point_of(x, c.a, n, turns) - centre(c.a);
            arm += d;  // n turns about a's centroid too, (11.13)
        }
        c.C = n.dot(d) - joint.length;
        c.Ja = -point_row(arm, n);
        c.Jb = point_row(pb - centre(c.b), n);
    }
    if (c.a == world) c.Ja.setZero();
    c.C *= joint.sense, c.Ja *= joint.sense, c.Jb *= joint.sense;
    return c;
}
//! [joint]

//! [across]
/// The motion across a line from point to point, as a row without an error: J as of
/// a distance, with n at right angles to the line (chapter 15 has the use).
/// \param part  of a pulley 1: from q_a to p_a, 2: from q_b to p_b; else 1
inline Constraint<3> across_line(const VecX& x, const PointJoint& joint, int part)
{
    PointJoint line = joint;
    if (joint.measure == PointJoint::Measure::pulley) {
        line.a = world;
        line.at_a = part == 1 ? joint.over_a : joint.over_b;
        line.b = part == 1 ? joint.a : joint.b;
        line.at_b = part == 1 ? joint.at_a : joint.at_b;
    }
    const Vec2 d = point_of(x, line.b, line.at_b) - point_of(x, line.a, line.at_a);
    line.measure = PointJoint::Measure::along;
    line.direction = perpendicular(Direction(d).n);
    line.sense = 1;
    Constraint<3> c = joint_constraint(x, line);
    c.kind = ConstraintKind::inerter;
    c.C = 0;
    return c;
}
//! [across]

//! [corner]
/// (11.14): vertex `corner` of body b over a wall.
inline Constraint<3> corner_constraint(const RigidScene& scene, const VecX& x,
                                       std::size_t wall, Index b,
                                       std::size_t corner)
{
    const HalfSpace& half = scene.walls[wall];
    const Polygon& shape = scene.shapes[static_cast<std::size_t>(b)];
    const Vec2 p = point_of(x, b, shape.vertices[corner]);
    Constraint<3> c;
    c.b = b;
    c.C = half.normal.dot(p) - half.offset - shape.radius;
    c.Jb = point_row(p - x.segment<2>(3 * b), half.normal);
    c.kind = ConstraintKind::unilateral;
    c.bounces = true;
    return c;
}
//! [corner]

//! [contact]
/// C and J of a contact at the positions x. Let p_a and p_b be the points of its
/// bodies that were at contact.point when it was found, at x_found, or behind it at
/// the corners of the polygons where the surface is round around them: C is the gap
/// of then and what they have come apart since, along n. n turns with the body whose
/// face it is of, about its centroid, as in (11.13), or with two centres.
inline Constraint<3> contact_constraint(const Contact& contact, const VecX& x_found,
                                        const VecX& x)
{
    Constraint<3> c;
    c.a = contact.a, c.b = contact.b;
    c.C = contact.gap;
    c.kind = ConstraintKind::unilateral;
    c.bounces = true;
    const Vec2& before = contact.normal;
    const Real apart = contact.core_a + contact.core_b;
    Vec2 n = before, d = apart * n;
    bool moved = false;
    const auto arm = [&](Index k, Real sign, Real core) {
        Vec2 r = contact.point + sign * core * before - x_found.segment<2>(3 * k),
             way = x.segment<2>(3 * k) - x_found.segment<2>(3 * k);
        const Index angle = 3 * k + 2;
        const Real turn = x[angle] - x_found[angle];
        if (turn != 0) {
            const Vec2 then = r;
            const auto [sine, cosine] = sine_and_cosine(turn);
            r = cosine * then + sine * perpendicular(then);
            way += r - then;
            if (contact.normal_of == (sign > 0 ? NormalOf::b : NormalOf::a))
                n = cosine * before + sine * perpendicular(before);
        }
        c.C += sign * before.dot(way);
        d += sign * way;
        moved = moved || turn != 0 || !way.isZero(0);
        return r;
    };
    Vec2 arm_b = arm(c.b, 1, contact.core_b), arm_a(0, 0);
    if (c.a != world) arm_a = arm(c.a, -1, contact.core_a);
    if (moved) {
        if (contact.normal_of == NormalOf::centres && !d.isZero(0))
            n = d.normalized();
        c.C += (n - before).dot(d);
        if (contact.normal_of == NormalOf::a) arm_a += d;
        if (contact.normal_of == NormalOf::b) arm_b -= d;
    }
    if (c.a != world) c.Ja = -point_row(arm_a, n);
    c.Jb = point_row(arm_b, n);
    return c;
}
//! [contact]

}  // namespace rigid
