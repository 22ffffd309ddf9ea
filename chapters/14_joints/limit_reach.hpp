/// \file limit_reach.hpp
/// Which limits a step could reach: a blow changes the speed of a joint within the step, so its own speed says too little.
///
///     far   ⇔   C > margin + 2 h (|Ċ| + s (V + h |g|))      V the fastest point of its island, s = 1 for lengths, 1/R for angles
///
/// (14.26). A limb whose end is stopped, or struck, at the speed V turns at V/R. A row with C > 0 lets the joint come as near as the
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
              const StepData<3>& now)
    {
        h_ = settings.h;
        margin_ = settings.margin;
        length_ = now.length;
        fall_ = settings.h * scene.gravity.norm();
        const bool any = std::any_of(
            now.sources.begin(), now.sources.end(), [&](const Source& source) {
                return source.of == Source::Of::joint &&
                       is_limit(
                           scene.joints[static_cast<std::size_t>(source.index)]);
            });
        if (any) find_fastest(scene, now);
    }

    //! [far]
    /// (14.26): whether this step cannot reach a one-sided row.
    bool is_far(const JointedScene& scene, std::size_t j)
    {
        const PointJoint& joint = scene.joints[j];
        if (!is_limit(joint)) return false;
        const Constraint<3> c = joint_constraint(scene.bodies.x, joint);
        const Row<3> row = unilateral(c, scene.bodies.inverse_mass);
        const bool turns = is_of_angles(joint);
        const Real lever = turns ? shorter_lever(scene, joint) : 1,
                   margin = margin_ * (turns ? 1 : length_),
                   own = std::abs(row.velocity(scene.bodies.u)),
                   blow = (fastest(joint) + fall_) / lever;
        return c.C > margin + 2 * h_ * (own + blow);
    }
    //! [far]

private:
    static bool is_limit(const PointJoint& joint)
    {
        return joint.kind == ConstraintKind::unilateral;
    }

    /// Of a body, from its centroid [m].
    static Real farthest_point(const RigidScene& scene, Index k)
    {
        const auto at = static_cast<std::size_t>(k);
        if (at >= scene.shapes.size()) return 0;
        return turning_radius(scene.shapes[at]) + scene.shapes[at].radius;
    }

    /// R of the smaller of two bodies [m].
    Real shorter_lever(const RigidScene& scene, const PointJoint& joint) const
    {
        Real least = infinity;
        for (const Index k : {joint.a, joint.b})
            if (k != world)
                if (const Real R = farthest_point(scene, k); R > 0)
                    least = std::min(least, R);
        return std::isfinite(least) ? least : length_;
    }

    //! [fastest]
    /// V of each island: of what contacts and joints connect.
    void find_fastest(const JointedScene& scene, const StepData<3>& now)
    {
        const Bodies<3>& bodies = scene.bodies;
        above_.resize(static_cast<std::size_t>(bodies.count()));
        speed_.resize(above_.size());
        const auto for_each_pair = [&](const auto& visit) {
            for (const Source& source : now.sources) {
                const auto i = static_cast<std::size_t>(source.index);
                if (source.of == Source::Of::contact)
                    visit(now.contacts[i].a, now.contacts[i].b);
                if (source.of == Source::Of::joint)
                    visit(scene.joints[i].a, scene.joints[i].b);
            }
        };
        for_each_pair([&](Index a, Index b) {
            for (const Index k : {a, b})
                if (k != world)
                    at(above_, k) = static_cast<int>(k), at(speed_, k) = 0;
        });
        for_each_pair([&](Index a, Index b) {
            if (bodies.can_move(a) && bodies.can_move(b))
                unite(above_, static_cast<int>(a), static_cast<int>(b));
        });
        for_each_pair([&](Index a, Index b) {
            Real faster = 0;
            for (const Index k : {a, b})
                if (k != world) {
                    const Vec<3> u = bodies.velocity(k);
                    faster = std::max(faster, u.head<2>().norm() +
                                                  std::abs(u[2]) *
                                                      farthest_point(scene, k));
                }
            for (const Index k : {a, b})
                if (k != world) {
                    Real& V = of_island(k);
                    V = std::max(V, faster);
                }
        });
    }
    //! [fastest]

    template <class Number>
    static Number& at(std::vector<Number>& list, Index k)
    {
        return list[static_cast<std::size_t>(k)];
    }
    Real& of_island(Index k)
    {
        return at(speed_, lowest_of(above_, static_cast<int>(k)));
    }
    Real fastest(const PointJoint& joint)
    {
        return std::max(joint.a == world ? 0 : of_island(joint.a),
                        of_island(joint.b));
    }

    Real h_ = 0, margin_ = 0, length_ = 1, fall_ = 0;
    std::vector<int> above_;   ///< of each body in a row: another of its island
    std::vector<Real> speed_;  ///< V, at the lowest body of each island [m/s]
};

}  // namespace rigid
