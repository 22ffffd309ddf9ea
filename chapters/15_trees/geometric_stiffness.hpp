/// \file geometric_stiffness.hpp
/// A loaded joint is stiff across its load: that stiffness, taken only as far as a step cannot carry it.
///
///     κ = Σ r·F,   k = T/L          a body that F pulls at the arm r turns back; a line under the pull T swings back      (15.13)
///     (I + i) (ω' − ω) = h τ + …    i = β (h² κ − s I)        ≥ 0                                                        (15.15)
///     w = J⊥ (u − u_old) + λ/i      i = β (h² k − s m⊥)       ≥ 0, a row across the line                                 (15.16)
///
/// Rows along J of the start of a step leave this stiffness to the next step, as an explicit spring does: stable while
/// h √(κ/I) < 2. An inertia that is larger by h² κ/4 for the change of a velocity, and for that alone, is stable at any step and
/// damps nothing: Newmark's method with β = 1/4 \cite newmark1959. What I carries by itself, half of s = 1 for each
/// end, is left alone, so a pendulum is what it is. What others whip, h |ω| √(h² κ/I) above a twentieth of a radian without
/// the share (h ω)² that its own turning asks for, no step can tell where it is going: what is beyond that bound is
/// damped, at most as an implicit spring damps \cite tournier2015.
#pragma once

#include "chapters/15_trees/line_inertance.hpp"
#include "chapters/15_trees/newton_positions.hpp"

namespace rigid {

//! [stiffness]
/// h κ of each body [N m s], from the impulses in now.solution.lambda and the
/// positions of the scene; never below zero. Of a body that the step does not look
/// at it is what it was.
/// \param arm  of each body: the square of its longest arm to a joint [m²]
inline void turning_stiffness(const RigidScene& scene, const StepData<3>& now,
                              VecX& kappa, VecX& arm)
{
    if (kappa.size() != scene.bodies.count()) kappa.setZero(scene.bodies.count());
    if (arm.size() != kappa.size()) arm.setZero(kappa.size());
    for (const int k : now.active) kappa[k] = 0, arm[k] = 0;
    for (int i = 0; i < static_cast<int>(now.sources.size()); ++i)
        if (is_of_joint(now, i))
            for_each_arm(scene, now, i, [&](Index k, const Vec2& r, const Vec2& J) {
                kappa[k] += now.solution.lambda[i] * r.dot(J);
                arm[k] = std::max(arm[k], r.squaredNorm());
            });
    for (const int k : now.active) kappa[k] = std::max(kappa[k], Real{0});
}
//! [stiffness]

//! [loaded]
/// Newton's method on positions, and bodies that turn as their joints are loaded: for
/// the change of a velocity I + i stands for I.
struct LoadedJoints : NewtonPositions {
    bool stiff = true;

    template <class Scene>
    void rows(Scene& scene, const StepSettings& settings, StepData<3>& now)
    {
        if (stiff) {
            turning_stiffness(scene, now, kappa_, arm_);
            inverse_inertia_.clear();
            for (const int k : now.active)
                inverse_inertia_.push_back(
                    resist(scene.bodies, k, settings.part(), now));
            resist_across(scene, settings.part(), now);
        }
        NewtonPositions::rows(scene, settings, now);
    }

    template <class Scene, class Solver>
    void move(Scene& scene, const StepSettings& settings, Solver& solver,
              StepData<3>& now)
    {
        NewtonPositions::move(scene, settings, solver, now);
        for (std::size_t i = 0; stiff && i < now.active.size(); ++i)
            scene.bodies.inverse_mass[3 * now.active[i] + 2] = inverse_inertia_[i];
    }
    //! [loaded]

private:
    //! [resist]
    /// (15.15), of a body.
    /// \return  its own inverse inertia
    Real resist(Bodies<3>& bodies, int k, Real h, StepData<3>& now) const
    {
        Real& inverse = bodies.inverse_mass[3 * k + 2];
        const Real own = inverse, spin = bodies.u[3 * k + 2];
        const Real load = h * kappa_[k] * own;  // h² κ/I
        if (!(load > loaded::carried)) return own;
        // about its farthest joint it has more inertia than about its centroid
        const Real about = load / (1 + arm_[k] * own / bodies.inverse_mass[3 * k]);
        const Real drag = loaded::drag(h * spin, about, load),
                   firm = loaded::beta * (load - loaded::carried),
                   less = 1 / (1 + firm + drag);
        inverse *= less;
        const Real toward = spin * (firm / (firm + drag));
        Real& free = now.u_star[3 * k + 2];
        free = toward + less * (free - toward);
        return own;
    }
    //! [resist]

    /// (15.16), of the lines that have a row across them.
    void resist_across(const JointedScene& scene, Real h, StepData<3>& now)
    {
        const auto any = std::any_of(
            now.constraints.begin(), now.constraints.end(),
            [](const auto& c) { return c.kind == ConstraintKind::inerter; });
        if (!any) return;
        row_of_.assign(scene.joints.size(), -1);
        for (std::size_t i = 0; i < now.sources.size(); ++i)
            if (now.sources[i].of == Source::Of::joint && now.sources[i].part == 0)
                row_of_[static_cast<std::size_t>(now.sources[i].index)] =
                    static_cast<int>(i);
        for (std::size_t i = 0; i < now.sources.size(); ++i) {
            Constraint<3>& c = now.constraints[i];
            if (c.kind != ConstraintKind::inerter) continue;
            const auto j = static_cast<std::size_t>(now.sources[i].index);
            const int part = now.sources[i].part;
            Real pull = 0;
            for_each_pull(scene, j, part, [&](std::size_t k, Real sense) {
                if (row_of_[k] >= 0)
                    pull += sense * now.solution.lambda[row_of_[k]];
            });
            const Row<3> row = bilateral(c, scene.bodies.inverse_mass);
            const Real mobility = row.inverse_effective_mass();
            c.speed = row.velocity(scene.bodies.u);
            c.inertance = inertance_under(scene, j, part, c, pull, h);
            if (const Real firm = c.inertance * mobility; firm > 0) {
                const Real load = firm / loaded::beta + loaded::carried,
                           turn = h * c.speed / line_length(scene, j, part),
                           drag = loaded::drag(turn, load, load);
                c.inertance += drag / mobility;
                c.speed *= firm / (firm + drag);
            }
            // a line that went slack in this step has next to none
            c.inertance = std::max(c.inertance, 1e-9 / mobility);
        }
    }

    VecX kappa_, arm_;
    std::vector<Real> inverse_inertia_;  ///< of the active bodies, their own
    std::vector<int> row_of_;            ///< of each of scene.joints; −1 = none
};

}  // namespace rigid
