/// \file geometric_stiffness.hpp
/// A loaded joint is stiff across its load: that stiffness, taken at the end of the step.
///
///     κ = Σ r·F ≥ 0,    (I + h² κ) ω' = I ω + h τ + …      F on the body at the arm r, of the step before
///
/// (14.18). A pull F at the arm r turns the body back by the torque −κ φ when it has turned by φ. Rows along J of the start of
/// the step leave that out, as an explicit spring would, and a light link under a large load then shakes itself apart when
/// h √(κ/I) is above 2. An implicit spring is stable at any step; it damps. \cite tournier2015
#pragma once

#include "chapters/14_joints/joint_rows.hpp"
#include "chapters/14_joints/newton_positions.hpp"

namespace rigid {

//! [stiffness]
/// h κ of each body [N m s], from the impulses in now.solution.lambda and the
/// positions of the scene; never below zero. Of a body that the step does not look
/// at it is what it was.
inline void turning_stiffness(const RigidScene& scene, const StepData<3>& now,
                              VecX& kappa)
{
    if (kappa.size() != scene.bodies.count()) kappa.setZero(scene.bodies.count());
    for (const int k : now.active) kappa[k] = 0;
    for (std::size_t i = 0; i < now.sources.size(); ++i) {
        if (now.sources[i].of != Source::Of::joint) continue;
        const Constraint<3>& c = now.constraints[i];
        const PointJoint& joint =
            scene.joints[static_cast<std::size_t>(now.sources[i].index)];
        if (joint.measure == PointJoint::Measure::angle) continue;
        const Real lambda = now.solution.lambda[static_cast<Index>(i)];
        const auto add = [&](Index k, const Vec2& at, const RowVec<3>& J) {
            if (!scene.bodies.can_move(k)) return;
            const Vec2 r = point_of(scene.bodies.x, k, at) -
                           scene.bodies.position(k).head<2>();
            kappa[k] += lambda * r.dot(J.head<2>().transpose());
        };
        add(c.a, joint.at_a, c.Ja);
        add(c.b, joint.at_b, c.Jb);
    }
    for (const int k : now.active) kappa[k] = std::max(kappa[k], Real{0});
}
//! [stiffness]

//! [loaded]
/// Newton's method on positions, and bodies that turn as stiffly as their joints are
/// loaded: in the rows of a step I + h² κ stands for I.
struct LoadedJoints : NewtonPositions {
    bool stiff = true;

    template <class Scene>
    void rows(Scene& scene, const StepSettings& settings, StepData<3>& now)
    {
        Bodies<3>& bodies = scene.bodies;
        if (stiff) {
            turning_stiffness(scene, now, kappa_);
            inverse_inertia_.clear();
            for (const int k : now.active) {
                inverse_inertia_.push_back(bodies.inverse_mass[3 * k + 2]);
                Real& inverse_inertia = bodies.inverse_mass[3 * k + 2];
                const Real less =
                    1 / (1 + settings.part() * kappa_[k] * inverse_inertia);
                inverse_inertia *= less;
                now.u_star[3 * k + 2] *= less;
            }
        }
        NewtonPositions::rows(scene, settings, now);
    }

    template <class Scene, class Solver>
    void move(Scene& scene, const StepSettings& settings, Solver& solver,
              StepData<3>& now)
    {
        for (std::size_t i = 0; stiff && i < now.active.size(); ++i)
            scene.bodies.inverse_mass[3 * now.active[i] + 2] = inverse_inertia_[i];
        NewtonPositions::move(scene, settings, solver, now);
    }
    //! [loaded]

private:
    VecX kappa_;
    std::vector<Real> inverse_inertia_;  ///< of the active bodies, their own
};

}  // namespace rigid
