/// \file limit_reach.hpp
/// Which limits a step could reach: a blow changes the speed of a joint within the step, so its own speed says too little.
///
///     far   ⇔   C > margin + 2 h (|Ċ| + D + s (V + E + h |g|))   V the fastest point of its island, belts included, s = 1 for
///                                                               lengths, 1/R for angles, D what its own motor and spring
///                                                               add to −Ċ in a step, E to the speeds of points what others
///                                                               of its island do
///
/// (14.7). A limb whose end is stopped, or struck, at the speed V turns at V/R. A row with C > 0 lets the joint come as near as the
/// limit, and no nearer; without it the limit is overstepped by h Ċ before it has a row.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/12_contact_manifolds/time_of_impact.hpp"
#include "chapters/14_joints/joint_rows.hpp"
#include "common/union_find.hpp"

#include <algorithm>

namespace rigid {

/// The rows of an angle move no centroid: their C is in radians, not in metres.
inline bool is_of_angles(const PointJoint& joint)
{
    return joint.measure == PointJoint::Measure::angle;
}

class LimitReach {
public:
    /// \param now  contacts and sources of the step, found
    void look(const JointedScene& scene, const StepSettings& settings,
              const StepData<3>& now);

    /// (14.7): whether this step cannot reach a one-sided row.
    bool is_far(const JointedScene& scene, std::size_t j);

private:
    static bool is_limit(const PointJoint& joint)
    {
        return joint.kind == ConstraintKind::unilateral;
    }

    /// What a motor or a spring adds to dq/dt in a step, up to its speed or C/h, as far as its force reaches; 0 of other rows.
    /// \param sense  1 or −1: so much of it as goes up, or down; 0: either
    Real drive_speed(const JointedScene& scene, const PointJoint& drive,
                     Real sense) const;

    /// Calls visit(drive) for the motors and springs of a limit's own coordinate.
    template <class Visit>
    void for_each_own_drive(const JointedScene& scene, std::size_t j,
                            const Visit& visit) const;

    /// How far a drive moves points where its coordinate goes by 1 [m].
    Real reach_of(const RigidScene& scene, const PointJoint& drive) const;

    /// R of the smaller of two bodies [m].
    Real shorter_lever(const RigidScene& scene, const PointJoint& joint) const;

    /// V and E of each island: of what contacts and joints connect.
    void find_fastest(const JointedScene& scene, const StepData<3>& now);

    template <class Number>
    static Number& at(std::vector<Number>& list, Index k)
    {
        return list[static_cast<std::size_t>(k)];
    }
    Real& of_island(std::vector<Real>& list, Index k)
    {
        return at(list, lowest_of(above_, static_cast<int>(k)));
    }
    /// The larger one of a joint's two islands, where what lies between cannot move.
    Real larger(std::vector<Real>& list, const PointJoint& joint)
    {
        return std::max(joint.a == world ? 0 : of_island(list, joint.a),
                        of_island(list, joint.b));
    }

    Real h_ = 0, margin_ = 0, length_ = 1, fall_ = 0;
    std::vector<int> above_;  ///< of each body in a row: another of its island
    /// V and E, at the lowest body of each island [m/s]
    std::vector<Real> speed_, drives_;
};

}  // namespace rigid
