/// \file correction.hpp
/// The correction stage of the step: one of the five ways to treat a position error, in b before the solver and in x
/// after it. Where it needs a second answer on the same rows, the solver gives it.
#pragma once

#include "chapters/06_sequential_impulse/restitution.hpp"
#include "chapters/07_baumgarte/projection.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"

namespace rigid {

struct Correction : StabilizerSettings, Restitution, PlainCorrection {
    /// projection after the last sub-step only, instead of after each
    bool at_the_end = false;

    // What is kept from step to step.
    SecondProblem second;
    VecX v;                  ///< pseudo-velocities of split_impulse [m/s]
    std::vector<Real> goal;  ///< of projection [m]

    void require_valid() const
    {
        rigid::require_valid(static_cast<const Restitution&>(*this));
        rigid::require_valid(static_cast<const StabilizerSettings&>(*this));
    }
    void describe(StabilizerSettings& how) const { how = *this; }

    //! [rows]
    /// b is what the way makes of C, or a bounce.
    template <class Scene>
    void rows(const Scene& scene, const StepSettings& settings,
              StepData<Scene::dof>& now) const
    {
        const Real h = settings.part();
        const StabilizerSettings how = in_metres(*this, now.length);
        write_rows(scene.bodies, h, now,
                   [&](const auto& c) { return velocity_bias(c, how, h); });
        add_bounces(scene, *this, settings, now);
    }
    //! [rows]

    //! [move]
    /// The new positions, and what corrects the error outside of b.
    template <class Scene, SolvesAgain<Scene::dof> Solver>
    void move(Scene& scene, const StepSettings& settings, Solver& solver,
              StepData<Scene::dof>& now)
    {
        constexpr int Dof = Scene::dof;
        auto& bodies = scene.bodies;
        const Real h = settings.part();
        const StabilizerSettings how = in_metres(*this, now.length);
        advance_positions(bodies, h, now);

        switch (method) {
        case Stabilizer::none:
        case Stabilizer::baumgarte:
            break;
        // the velocity that was only there to correct is taken back
        case Stabilizer::relaxation:
            pose_relaxation<Dof>(now, how, h, bodies.u, second);
            solver.solve_again(second, bodies, now);
            break;
        // a velocity that is used once and forgotten
        case Stabilizer::split_impulse:
            pose_split_impulse<Dof>(now, how, h, bodies.u, second);
            if (v.size() != bodies.u.size()) v.setZero(bodies.u.size());
            solver.solve_apart(second, v, now);
            for (const int k : now.active)
                bodies.integrate(k, v.template segment<Dof>(Dof * k), h);
            break;
        case Stabilizer::projection:
            if (!at_the_end || now.substep + 1 == settings.substeps)
                now.visits += project_positions<Dof>(
                    [&](std::size_t i, const VecX& x) {
                        return constraint_at(scene, now, i, x);
                    },
                    now.constraints.size(), bodies.inverse_mass, how,
                    at_the_end ? settings.h : h, goal, bodies.x);
            break;
        }
    }
    //! [move]
};

}  // namespace rigid
