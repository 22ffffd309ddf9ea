/// \file reduced_motion.hpp
/// A constraint as a coordinate that is not there: motion in the coordinates of joints, with rows only for what is left.
///
///     d²q/dt² = H⁻¹ (τ − bias)          the articulated-body recursion of chapter 15, never H itself
///     τ = Σ up the tree                 recursive Newton-Euler, its inverse: the check
///     A = J H⁻¹ Jᵀ                      of loops and contacts, a recursion for each row
///
/// (26.8), (26.12), (26.13). Where nothing but the tree holds, a step is of order four. Loops keep their rows on accelerations;
/// contacts and limits are an MLCP of velocities (chapter 3), in these coordinates. A body that hangs on no joint floats: it is
/// given a rail along x, on that a rail along y, and a pin, which have no mass: three coordinates. \cite featherstone2008
#pragma once

#include "chapters/13_friction/friction_solver.hpp"
#include "chapters/14_joints/placed_joints.hpp"
#include "chapters/15_trees/reduced.hpp"
#include "chapters/26_four_ways/push_joints.hpp"

namespace rigid {

/// A scene as a tree: the joints that close loops are taken out, their rows kept apart.
struct TreeAndLoops {
    JointedScene
        tree;  ///< the scene's bodies, then two carriers for each that floats
    std::vector<PointJoint> loops;
    std::vector<Index>
        carried;  ///< of each body: itself; of a carrier, what it carries
};

//! [split]
/// A joint is the tree's if its body b hangs on none yet and carries not its body a; revolute, prismatic and weld joints alone.
/// All others are rows. A body without one floats.
TreeAndLoops split_loops(const JointedScene& scene);
//! [split]

class ReducedMotion {
public:
    Real restitution = 0;  ///< e of contacts and limits, besides that of surfaces
    /// contacts and limits: false for a scene where nothing ever touches
    bool touches = true;
    CollisionFilter filter;
    std::int64_t recursions = 0;  ///< up and down the tree, so far

    /// \throws std::invalid_argument  for motors and springs
    explicit ReducedMotion(const JointedScene& scene);

    /// Advances by h seconds, and writes places and velocities of the bodies into the scene. The status is that of the last
    /// rows; `solved` where there are none.
    Status advance(JointedScene& scene, Real h);

    const VecX& q() const { return q_; }
    const VecX& dq() const { return dq_; }

    /// Of the tree, the bodies that float among them.
    Index coordinates() const { return q_.size(); }

    /// d²q/dt² at (q, dq) under the weight and the forces τ of the joints [N, N m], without rows: down, up, down.
    /// \param tau  empty: none
    VecX forward_dynamics(const VecX& q, const VecX& dq, const VecX& tau);

    /// τ for which the joints accelerate so: recursive Newton-Euler, (26.13).
    VecX inverse_dynamics(const VecX& q, const VecX& dq, const VecX& ddq);

private:
    Status accelerations(const VecX& q, const VecX& dq, VecX& ddq);
    /// q̇ of each row's unit impulse, and A = J H⁻¹ Jᵀ.
    void couple(std::vector<Row<3>>& rows);

    Index carried_by(Index body) const
    {
        return parts_.carried[static_cast<std::size_t>(body)];
    }

    TreeAndLoops parts_;
    ReducedTree tree_;
    std::vector<ReducedLink> links_;
    VecX q_, dq_, x_, u_, c_, motion_, f_;
    std::vector<PushJoint> near_;
    std::vector<VecX> answers_;  ///< H⁻¹ Jᵀ of each row
    Mlcp mlcp_;
    FindFriction find_;
    Solution solution_;
};

}  // namespace rigid
