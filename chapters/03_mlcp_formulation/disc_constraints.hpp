/// \file disc_constraints.hpp
/// What a step needs from a scene of discs: the velocities that its forces lead to, and its constraints at any
/// positions. A new kind of force enters in free_velocities(), a new kind of constraint in constraint_at().
#pragma once

#include "chapters/02_velocity_constraints/joints.hpp"
#include "chapters/03_mlcp_formulation/step_data.hpp"

namespace rigid {

//! [forces]
/// Forces, and the velocity u* that they alone would lead to (3.4), of the active
/// bodies.
inline void free_velocities(DiscScene& scene, const StepSettings& settings,
                            StepData<2>& now)
{
    Bodies<2>& bodies = scene.bodies;
    const Real h = settings.part();
    for (const int k : now.active) {
        const Real inverse_mass = bodies.inverse_mass[2 * k];
        bodies.force(k) =
            inverse_mass > 0 ? Vec2(scene.gravity / inverse_mass) : Vec2(0, 0);
    }
    add_bend_springs(bodies, now.bends, settings.stiffness, settings.damping,
                     9.81 * now.length);
    if (settings.pulled != world) add_pull(bodies, settings.pulled, settings.hand);
    // What the step doesn't look at has the velocity that it has: rows may join it
    // to what moves.
    if (now.u_star.size() != bodies.u.size()) now.u_star = bodies.u;
    for (const int k : now.active)
        now.u_star.segment<2>(2 * k) =
            bodies.velocity(k) + h * bodies.apply_inverse_mass(k, bodies.force(k));
}
//! [forces]

//! [constraint_at]
/// Constraint i of the step at any positions x.
inline Constraint<2> constraint_at(const DiscScene& scene, const StepData<2>& now,
                                   std::size_t i, const VecX& x)
{
    const auto index = static_cast<std::size_t>(now.sources[i].index);
    if (now.sources[i].of == Source::Of::link)
        return distance_constraint(x, scene.links[index]);
    if (now.sources[i].of == Source::Of::joint)
        return joint_constraint(x, scene.joints[index]);
    const Contact& contact = now.contacts[index];
    return contact_constraint(
        contact.a == world ? wall_contact(scene, x, contact.feature, contact.b)
                           : disc_contact(scene, x, contact.a, contact.b));
}
//! [constraint_at]

/// C and J of all constraints where the bodies are now. In the first sub-step contacts are as they were found.
inline void evaluate_constraints(const DiscScene& scene, StepData<2>& now)
{
    now.constraints.resize(now.sources.size());
    for (std::size_t i = 0; i < now.sources.size(); ++i) {
        const Source source = now.sources[i];
        now.constraints[i] =
            source.of == Source::Of::contact && now.substep == 0
                ? contact_constraint(
                      now.contacts[static_cast<std::size_t>(source.index)])
                : constraint_at(scene, now, i, scene.bodies.x);
    }
}

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
