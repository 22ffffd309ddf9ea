/// \file joint_accelerations.hpp
/// The accelerations that joints allow, by the same factor as their velocities.
///
///     d²C/dt² = J a + k = 0,    k = what velocities alone make of it,    a = M⁻¹ (f + Jᵀ λ)
///
/// Rows on a with the bias k. No step is in it, so a step of any order may be taken with them; chapter 1 has some.
/// Whatever error of C there is stays.
#pragma once

#include "chapters/14_joints/joint_rows.hpp"
#include "chapters/15_trees/joint_factor.hpp"
#include "common/elementary.hpp"

namespace rigid {

//! [velocity_product]
/// k, the second derivative of C while no velocity changes [m/s², rad/s²].
/// Throws std::invalid_argument for a measure that it does not know.
inline Real velocity_product(const PointJoint& joint, const VecX& x, const VecX& u)
{
    using Measure = PointJoint::Measure;
    if (joint.measure == Measure::angle) return 0;
    if (joint.measure == Measure::pulley || joint.measure == Measure::rack)
        throw std::invalid_argument("pulleys and racks have no accelerations here; "
                                    "points, directions and angles have");
    // v and the acceleration −ω² r of a point
    const auto motion = [&](Index k, const Vec2& at, Vec2& v) -> Vec2 {
        v.setZero();
        if (k == world) return {0, 0};
        const Vec2 r = point_of(x, k, at) - x.segment<2>(3 * k);
        const Real omega = u[3 * k + 2];
        v = u.segment<2>(3 * k) + omega * perpendicular(r);
        return -omega * omega * r;
    };
    Vec2 va, vb;
    const Vec2 bend =
        motion(joint.b, joint.at_b, vb) - motion(joint.a, joint.at_a, va);
    const Vec2 d =
        point_of(x, joint.b, joint.at_b) - point_of(x, joint.a, joint.at_a);
    Vec2 n = joint.direction;
    Real k = 0;
    if (joint.measure == Measure::distance) {
        n = d.normalized();
        k = ((vb - va).squaredNorm() - pow(n.dot(vb - va), 2)) / d.norm();
    } else if (joint.measure == Measure::turning && joint.a != world) {
        n = point_of(x, joint.a, n) - x.segment<2>(3 * joint.a);
        const Real omega = u[3 * joint.a + 2];
        k = 2 * omega * perpendicular(n).dot(vb - va) - omega * omega * n.dot(d);
    }
    return joint.sense * (k + n.dot(bend));
}
//! [velocity_product]

/// Accelerations of bodies whose joints push and pull; memory is kept.
class JointAccelerations {
public:
    /// \param free  M⁻¹ f before, the accelerations after
    void find(const JointedScene& scene, const VecX& x, const VecX& u, VecX& free)
    {
        rows_.clear();
        k_.resize(static_cast<Index>(scene.joints.size()));
        for (std::size_t i = 0; i < scene.joints.size(); ++i) {
            const PointJoint& joint = scene.joints[i];
            if (joint.kind != ConstraintKind::bilateral)
                throw std::invalid_argument(
                    "row " + std::to_string(i) +
                    " of the joints has a bound or is a spring; accelerations are "
                    "found of those that push and pull");
            const Constraint<3> c = joint_constraint(x, joint);
            k_[static_cast<Index>(i)] = velocity_product(joint, x, u);
            rows_.push_back(
                bilateral(c, scene.bodies.inverse_mass, k_[static_cast<Index>(i)]));
        }
        factor_.factor(rows_, scene.bodies.inverse_mass);
        lambda_.setZero(k_.size());
        factor_.solve(rows_, k_, free, lambda_);
    }

private:
    std::vector<Row<3>> rows_;
    VecX k_, lambda_;
    JointFactor factor_;
};

}  // namespace rigid
