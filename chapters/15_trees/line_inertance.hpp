/// \file line_inertance.hpp
/// What a load adds to the inertia of what it makes stiff, and what of it a line under a pull needs: (15.15) and (15.16) of
/// geometric_stiffness.hpp in numbers.
#pragma once

#include "chapters/08_warm_starting/warm_start.hpp"
#include "chapters/14_joints/joint_rows.hpp"

namespace rigid {

namespace loaded {
constexpr Real beta = 0.25;  ///< of Newmark's method: the least that is stable
constexpr Real carried =
    0.5;  ///< s, of h² κ/I: 4 would be the limit for one spring
/// h ω √(h² κ/I), I about the farthest joint, of a body in a sub-step [rad]: what turns
/// faster is damped
constexpr Real most_turn = 0.05;

/// What drags a whip, as a share of its inertia: so much that it is back at its bound
/// after a step, at most the whole load. Its own turning whips nothing.
/// \param turn   h ω [rad]
/// \param about  h² κ/I, I about the farthest joint
/// \param load   h² κ/I
inline Real drag(Real turn, Real about, Real load)
{
    const Real whip = turn * turn * (about - turn * turn);
    return std::clamp(whip / (most_turn * most_turn) - 1, Real{0}, load);
}
}  // namespace loaded

//! [arms]
/// Calls visit(k, r, J) for each movable body of a joint's row, r its arm [m] and J
/// how its centroid moves the row; of an angle, and across a line, for none.
template <class Visit>
void for_each_arm(const RigidScene& scene, const StepData<3>& now, int row,
                  const Visit& visit)
{
    const auto at = static_cast<std::size_t>(row);
    const auto& source = now.sources[at];
    const PointJoint& joint = scene.joints[static_cast<std::size_t>(source.index)];
    if (joint.measure == PointJoint::Measure::angle || source.part > 0) return;
    const Constraint<3>& c = now.constraints[at];
    const auto one = [&](Index k, const Vec2& p, const RowVec<3>& J) {
        if (!scene.bodies.can_move(k)) return;
        const Vec2 r = point_of(scene.bodies.x, k, p, &scene.turns) -
                       scene.bodies.position(k).head<2>();
        visit(k, r, Vec2(J.head<2>().transpose()));
    };
    one(c.a, joint.at_a, c.Ja);
    one(c.b, joint.at_b, c.Jb);
}
//! [arms]

//! [inertance]
/// How many lines a row of a joint has: one from point to point, a pulley two. What
/// has no length has no direction, and is none.
inline int lines_of(const PointJoint& joint)
{
    using Measure = PointJoint::Measure;
    if (joint.length == 0) return 0;
    return joint.measure == Measure::distance ? 1
           : joint.measure == Measure::pulley ? 2
                                              : 0;
}

/// How long one of them is [m]
inline Real line_length(const RigidScene& scene, std::size_t j, int part)
{
    const PointJoint& joint = scene.joints[j];
    const VecX& x = scene.bodies.x;
    const Vec2 pa = point_of(x, joint.a, joint.at_a),
               pb = point_of(x, joint.b, joint.at_b);
    if (joint.measure != PointJoint::Measure::pulley) return (pb - pa).norm();
    return part == 1 ? (pa - joint.over_a).norm() : (pb - joint.over_b).norm();
}

/// i of (15.16) [kg], of a line that is pulled so.
/// \param across  the row across it
/// \param pull    h T [N s]
inline Real inertance_under(const RigidScene& scene, std::size_t j, int part,
                            const Constraint<3>& across, Real pull, Real h)
{
    const Real length = line_length(scene, j, part),
               mobility = bilateral(across, scene.bodies.inverse_mass)
                              .inverse_effective_mass();
    if (!(pull > 0 && length > 0 && mobility > 0)) return 0;
    const Real more =
        loaded::beta * (h * pull / length - loaded::carried / mobility);
    return std::isfinite(more) ? std::max(Real{0}, more) : 0;
}

/// What Λ of a joint's row adds to K of (15.12a) [kg, kg, kg m²].
/// \param tied  whether lines add too: 2T/L at each end by itself moves the centroid
inline void add_stiffness(const RigidScene& scene, const StepData<3>& now, int row,
                          Real impulse, bool tied, VecX& K)
{
    const auto j =
        static_cast<std::size_t>(now.sources[static_cast<std::size_t>(row)].index);
    const bool line = tied && lines_of(scene.joints[j]) == 1;
    const Real pull = line ? -scene.joints[j].sense * impulse : 0,
               firm = pull > 0 ? 2 * pull / line_length(scene, j, 0) : 0;
    for_each_arm(scene, now, row, [&](Index k, const Vec2& r, const Vec2& J) {
        K.segment<3>(3 * k) += Eigen::Matrix<Real, 3, 1>(
            firm, firm, impulse * r.dot(J) + firm * r.squaredNorm());
    });
}

/// Whether two rows measure the same line, as two limits of a distance do.
inline bool are_one_line(const JointedScene& scene, std::size_t i, std::size_t j)
{
    if (i == j) return true;
    const auto owner = [&](std::size_t k) {
        return k < scene.owner.size() ? scene.owner[k] : -1;
    };
    return owner(i) >= 0 && owner(i) == owner(j) &&
           lines_of(scene.joints[i]) == 1 && lines_of(scene.joints[j]) == 1;
}

/// The rows that pull a line, and with how much of their impulse.
template <class Visit>
void for_each_pull(const JointedScene& scene, std::size_t j, int part,
                   const Visit& visit)
{
    const PointJoint& joint = scene.joints[j];
    if (joint.measure == PointJoint::Measure::pulley) {
        visit(j, -joint.sense * (part == 1 ? joint.gear_a : joint.gear_b));
        return;
    }
    std::size_t first = j, last = j;
    while (first > 0 && are_one_line(scene, j, first - 1)) --first;
    while (last + 1 < scene.joints.size() && are_one_line(scene, j, last + 1))
        ++last;
    for (std::size_t i = first; i <= last; ++i) visit(i, -scene.joints[i].sense);
}

/// Whether a step needs the row across a line, by the impulses of the step before.
/// Where it has sub-steps, a load may come in one and be there in the next: so may be
/// sixteen times what was, and anything where nothing was.
inline bool needs_inerter(const JointedScene& scene, std::size_t j, int part,
                          const StepSettings& settings, const ImpulseCache& before)
{
    Real pull = 0;
    bool known = false;
    for_each_pull(scene, j, part, [&](std::size_t i, Real sense) {
        const auto impulse = remembered(before, joint_key(i), settings.part());
        pull += sense * impulse.value_or(0);
        known = known || impulse.has_value();
    });
    const bool grows = settings.substeps > 1;
    if (grows && !known) return true;
    const Constraint<3> across = across_line(scene.bodies.x, scene.joints[j], part);
    return inertance_under(scene, j, part, across, (grows ? 16 : 1) * pull,
                           settings.part()) > 0;
}
//! [inertance]

}  // namespace rigid
