/// \file disc_constraints.hpp
/// What a step needs from a scene of discs: the velocities that its forces lead to, and its constraints at any
/// positions. A new kind of force enters in free_velocities(), a new kind of constraint in constraint_at().
#pragma once

#include "chapters/02_velocity_constraints/joints.hpp"
#include "chapters/03_mlcp_formulation/step_data.hpp"

namespace rigid {

/// Forces, and the velocity u* that they alone would lead to (3.4), of the active
/// bodies.
void free_velocities(DiscScene& scene, const StepSettings& settings,
                     StepData<2>& now);

/// Constraint i of the step at any positions x.
Constraint<2> constraint_at(const DiscScene& scene, const StepData<2>& now,
                            std::size_t i, const VecX& x);

/// C and J of all constraints where the bodies are now. In the first sub-step contacts are as they were found.
void evaluate_constraints(const DiscScene& scene, StepData<2>& now);

/// The rows of the constraints, by their kinds, with a bias for each. A row that is kept has its J, only b is new.
/// \param bias  Real (const Constraint<Dof>&) [m/s]
template <int Dof, class Bias>
void write_rows(const Bodies<Dof>& bodies, Real h, StepData<Dof>& now,
                const Bias& bias)
{
    now.rows.resize(now.constraints.size());
    for (std::size_t i = 0; i < now.constraints.size(); ++i) {
        const Real b = bias(now.constraints[i]);
        if (!now.kept.empty() && now.kept[i] && now.substep == 0) {
            now.rows[i].bias = b;
            // rows may have other numbers now
            now.rows[i].bounded_by = now.constraints[i].bounded_by;
        } else now.rows[i] = row_of(now.constraints[i], bodies.inverse_mass, b, h);
    }
}

/// x ← x + h u of the active bodies.
template <int Dof>
void advance_positions(Bodies<Dof>& bodies, Real h, const StepData<Dof>& now)
{
    for (const int k : now.active) bodies.integrate(k, bodies.velocity(k), h);
}

}  // namespace rigid
