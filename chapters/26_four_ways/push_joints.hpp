/// \file push_joints.hpp
/// Contacts as joints that only push: their C, J and second derivative are those of chapters 11 and 15, at any positions.
///
///     corner on a wall            along       C = n·p_b − c − ρ
///     corner over a side          turning     n turns with the body of the side
///     corner to corner, discs     distance    C = ‖p_b − p_a‖ − ρ_a − ρ_b
///
/// A step of order four evaluates accelerations away from where contacts were found, so the gap alone (11.14) and its J do
/// not suffice: d²C/dt² = J a + k needs k, and k needs to know what turns.
#pragma once

#include "chapters/10_skipping_work/collision_filter.hpp"
#include "chapters/12_contact_manifolds/placed_shape.hpp"
#include "chapters/13_friction/friction_rows.hpp"
#include "chapters/15_trees/joint_accelerations.hpp"
#include "chapters/26_four_ways/require_values.hpp"

#include <string_view>

namespace rigid {

/// A contact, or a joint's limit. Body a of `gap` is the one whose side it is; it may have the higher number.
struct PushJoint {
    PointJoint gap;       ///< C ≥ 0
    Surface surface;      ///< none of a limit
    Real radius = 0;      ///< of body b around its point [m]
    bool touches = true;  ///< false: a limit of a joint
};

/// What holds the scene and pushes in it: the joints of a scene that push alone, and all contacts with a gap below the margin.
/// Bodies that a joint keeps from touching, and those that the filter does, have none.
/// \param margin  [m]
/// \param found   is emptied and filled: limits, walls, pairs, each in ascending order
void find_push_joints(const JointedScene& scene, const CollisionFilter& filter,
                      Real margin, std::vector<PushJoint>& found);

/// How much nearer two bodies can come in h seconds, about: twice the way of the fastest point of any [m].
/// \param length  the least arm of what turns [m]
Real closing_reach(const JointedScene& scene, Real length, Real h);

/// M⁻¹ f of the weight of body k alone [m/s²]: none of what no force moves on.
inline Vec2 free_acceleration(const JointedScene& scene, Index k)
{
    const Vec2 inverse = scene.bodies.inverse_mass.segment<2>(3 * k);
    if (!(inverse.x() > 0)) return {0, 0};
    return {scene.gravity.x(), scene.gravity.y() * (inverse.y() / inverse.x())};
}
inline void free_accelerations(const JointedScene& scene, VecX& a)
{
    a.setZero(scene.bodies.u.size());
    for (Index k = 0; k < scene.bodies.count(); ++k)
        a.segment<2>(3 * k) = free_acceleration(scene, k);
}

/// The door of the ways that are no step of chapter 3's: throws std::invalid_argument, naming what makes no sense, and what they
/// have no row for: rolling resistance, a cloth, chains of edges, joints that break, motors and springs of joints.
/// \param otherwise  how the sentence of motors and springs ends: what the way does with joints
void require_valid_motion(const JointedScene& scene, const CollisionFilter& filter,
                          std::string_view otherwise);

/// Throws std::invalid_argument unless the lists of a filter are empty or as long as so many bodies need, its groups are below
/// most_groups, and its list of pairs ends where they do.
void require_fits(const CollisionFilter& filter, std::size_t bodies);

/// Throws std::invalid_argument for a surface whose μ depends on whether it slides.
void require_one_friction(const JointedScene& scene);

/// C, J of the normal where the bodies are.
inline Constraint<3> gap_of(const PushJoint& joint, const VecX& x)
{
    return joint_constraint(x, joint.gap);
}

//! [drag]
/// The row along a contact, J_t, and its k_t: what velocities alone make of J_t u
/// while the point sticks, −ω² of what turns with each body.
struct Drag {
    Constraint<3> c;
    Real k = 0;  ///< [m/s²]
};
inline Drag drag_of(const PushJoint& joint, const Constraint<3>& normal, int number,
                    const VecX& x, const VecX& u)
{
    const Vec2 n = normal.Jb.head<2>().transpose();
    const Vec2 core_a = point_of(x, joint.gap.a, joint.gap.at_a),
               core_b = point_of(x, joint.gap.b, joint.gap.at_b),
               p = core_b - joint.radius * n;
    const Vec2 t = perpendicular(n);
    const auto arm = [&](Index k, const Vec2& at) -> Vec2 {
        return k == world ? Vec2(0, 0) : Vec2(at - x.segment<2>(3 * k));
    };
    const auto turns = [&](Index k, const Vec2& at) {
        return k == world ? 0 : u[3 * k + 2] * u[3 * k + 2] * t.dot(arm(k, at));
    };
    const bool discs = joint.gap.measure == PointJoint::Measure::distance;
    Drag drag;
    drag.c = friction_constraint(normal, number, arm(joint.gap.a, p),
                                 arm(joint.gap.b, p), joint.surface);
    drag.k = turns(joint.gap.a, discs ? core_a : p) - turns(joint.gap.b, core_b);
    return drag;
}
//! [drag]

/// Of the ways that place an impact inside the step.
struct EventSettings {
    Real gap = 1e-7;         ///< below it a contact may be closed [ℓ]
    Real rest_speed = 1e-3;  ///< an approach that is slower does not bounce [ℓ/s]
    int most_events = 200;   ///< in a step
};

/// Throws std::invalid_argument, naming the setting and its value, unless all make sense.
void require_valid(const EventSettings& settings);

//! [moment]
/// When something that opens is closed first, in a step at whose end it is past that:
/// by secants, whose end that stays counts half, and by halves where it jumps.
struct Moment {
    Real before = 0, past;  ///< it lies between them [s]
    Real there, here;       ///< what is open at both
    int side = 0, looks = 0;

    /// \param h      the end of the step [s]
    /// \param start  what is open at its start; infinity: nothing
    /// \param end    and at its end, below zero
    Moment(Real h, Real start, Real end) : past(h), there(start), here(end) {}

    /// Where to look next; 0: `past` is the moment, to the given width [s].
    Real next(Real width)
    {
        if (looks >= 200 || !(past - before > width)) return 0;
        const Real middle = (before + past) / 2;
        Real at = middle;
        if (looks++ % 4 != 3 && there > 0 && there < infinity)
            at = past - here * (past - before) / (here - there);
        if (!(before < at && at < past)) at = middle;
        return before < at && at < past ? at : 0;
    }
    /// What was found there. Returns whether it is past the moment.
    bool take(Real at, Real open)
    {
        if (open < 0) {
            if (side < 0) there /= 2;
            past = at, here = open, side = -1;
        } else {
            if (side > 0) here /= 2;
            before = at, there = open, side = 1;
        }
        return open < 0;
    }
};
//! [moment]

}  // namespace rigid
