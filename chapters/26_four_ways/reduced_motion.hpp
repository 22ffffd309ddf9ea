/// \file reduced_motion.hpp
/// A constraint as a coordinate that is not there: motion in the coordinates of joints, with rows only for what is left.
///
///     d²q/dt² = H⁻¹ (τ − bias)          the articulated-body recursion of chapter 15, never H itself
///     τ = Σ up the tree                 recursive Newton-Euler, its inverse: the check
///     A = J H⁻¹ Jᵀ                      of loops and contacts, a recursion for each row
///
/// (26.8), (26.12), (26.13). Where nothing but the tree holds, a step is of order four. Loops keep their rows on accelerations. What
/// bounces does so at its moment inside the step, if nothing else touches; contacts and limits that rest are an MLCP of velocities
/// (chapter 3), in these coordinates. A body that hangs on no joint floats: it is given a rail along x, on that a rail along y, and a
/// pin, which have no mass: three coordinates. \cite featherstone2008
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
    EventSettings
        settings;          ///< beyond most_events the rest of a step is one of rows
    Real restitution = 0;  ///< e of contacts and limits, besides that of surfaces
    /// an overlap comes out at most so fast, and keeps that velocity [ℓ/s, rad/s]
    static constexpr Real repair_speed = 1;
    /// contacts and limits: false for a scene where nothing ever touches
    bool touches = true;
    CollisionFilter filter;
    std::int64_t recursions = 0;  ///< up and down the tree, so far
    std::int64_t bounces = 0;     ///< that were given their moment, so far

    /// \throws std::invalid_argument  for a scene that makes no sense, and for what coordinates have no row for
    explicit ReducedMotion(const JointedScene& scene);

    /// Advances by h seconds, and writes places and velocities of the bodies into the scene. What was changed there since the
    /// last step is taken over, as near as the joints allow it. The status is that of the last rows; `solved` where there are
    /// none. Without an answer the scene stands where that was.
    /// \throws std::invalid_argument  for another scene than that of the constructor, settings or a step that make no sense
    Status advance(JointedScene& scene, Real h);

    const VecX& q() const { return q_; }
    const VecX& dq() const { return dq_; }

    /// Of the tree, the bodies that float among them.
    Index coordinates() const { return q_.size(); }

    /// d²q/dt² at (q, dq) under the weight and the forces τ of the joints [N, N m], without rows: down, up, down.
    /// \param tau  empty: none
    /// \throws std::invalid_argument  for vectors of another length than coordinates()
    VecX forward_dynamics(const VecX& q, const VecX& dq, const VecX& tau);

    /// τ for which the joints accelerate so: recursive Newton-Euler, (26.13).
    VecX inverse_dynamics(const VecX& q, const VecX& dq, const VecX& ddq);

private:
    /// The door of each step; takes over what the caller has changed.
    void follow(const JointedScene& scene);
    /// Whether its joints hold what the constructor's scene held.
    bool holds_as_given(const JointedScene& scene) const;
    /// q and q̇ of places and velocities of the bodies.
    void take(const Bodies<3>& bodies);
    void require_fits(const VecX& v, const char* name) const;
    Status accelerations(const VecX& q, const VecX& dq, VecX& ddq);
    /// Of order four: the tree and its loops alone.
    Status fly(Real h, VecX& q, VecX& dq);
    /// One step of rows on velocities, h long, in a step of the given length.
    Status push(const JointedScene& scene, Real h, Real whole, bool bounces_too);
    /// How many of what is near bounce.
    Index bouncing() const;
    /// Of h seconds those in which nothing goes farther than to what it may hit, and half its inner radius into that [s]; 0: it
    /// has none.
    Real safe_part(const JointedScene& scene, Real h) const;
    /// Whether what touches bounced, at once and all together.
    bool bounce(const JointedScene& scene);
    /// Flies for h seconds or to the first contact. Returns how long that was.
    Real fly_until_closed(Real h, Real width, Status& status);
    void find_near(const JointedScene& scene, Real h);
    void write(JointedScene& scene);
    void place(const VecX& q, const VecX& dq)
    {
        tree_.place(q, x_);
        tree_.move(dq, x_, u_);
    }
    /// The smallest gap of what approaches at (q, dq); infinity: nothing does.
    Real open(const VecX& q, const VecX& dq);
    /// Whether something touches that will not have parted in h seconds.
    bool rests(Real h) const;
    Row<3> row_of(const PushJoint& push) const;
    void add_drag(const PushJoint& push, int normal, std::vector<Row<3>>& rows,
                  std::vector<FrictionBox>& boxes) const;
    Real restitution_of(const PushJoint& push) const
    {
        return std::max(restitution, push.surface.restitution);
    }
    /// The impulses of rows of which couple() has made a problem, at the speeds u_.
    Status solve(const std::vector<Row<3>>& rows,
                 const std::vector<FrictionBox>& boxes);
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
    VecX written_x_, written_u_;  ///< of the bodies, at the end of the last step
    std::vector<PointJoint> joints_given_;  ///< of the constructor's scene
    std::vector<PushJoint> near_;
    std::vector<VecX> answers_;  ///< H⁻¹ Jᵀ of each row
    Mlcp mlcp_;
    FindFriction find_;
    Solution solution_;
    Real length_ = 1;
};

}  // namespace rigid
