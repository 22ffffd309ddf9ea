/// \file one_row_step.hpp
/// One body and one row: a bead on a wire, a disc beside a rail. The same step, for a scene without contacts.
#pragma once

#include "chapters/07_baumgarte/corrected_method.hpp"

namespace rigid {

//! [one_row_scene]
/// Body 0 on one bilateral constraint.
/// \tparam ConstraintAt  C and J at given positions: Constraint<2> (const VecX& x)
template <class ConstraintAt>
struct OneRowScene {
    static constexpr int dof = 2;
    Bodies<2> bodies{1};
    Vec2 gravity = {0, -9.81};  ///< [m/s²]
    ConstraintAt at;
};

/// e of its row, besides that of the method (chapter 6): none.
template <class ConstraintAt>
Real own_restitution(const OneRowScene<ConstraintAt>&, const StepData<2>&,
                     std::size_t)
{
    return 0;
}

template <class ConstraintAt>
void free_velocities(OneRowScene<ConstraintAt>& scene, const StepSettings& settings,
                     StepData<2>& now)
{
    scene.bodies.f.setZero();
    add_gravity(scene.bodies, scene.gravity);
    now.u_star =
        scene.bodies.u +
        settings.part() * scene.bodies.inverse_mass.cwiseProduct(scene.bodies.f);
}

template <class ConstraintAt>
Constraint<2> constraint_at(const OneRowScene<ConstraintAt>& scene,
                            const StepData<2>&, std::size_t, const VecX& x)
{
    return scene.at(x);
}

template <class ConstraintAt>
void evaluate_constraints(const OneRowScene<ConstraintAt>& scene, StepData<2>& now)
{
    now.constraints = {scene.at(scene.bodies.x)};
}

/// The one body is looked at, and nothing touches it.
struct OneRowContacts : PlainContacts {
    template <class Scene, class Method>
    void begin(const Scene&, const StepSettings&, Method&, StepData<2>& now) const
    {
        now.active = {0};
        now.sources = {{}};
    }
};
//! [one_row_scene]

struct OneRowMethod {
    OneRowContacts contacts;
    Correction correction;
    ColdStart start;
    ImpulseSolver<2> solver;

    OneRowMethod() { solver.sweeps.max_sweeps = 1; }
};

}  // namespace rigid
