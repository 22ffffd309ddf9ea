/// \file disc_step.hpp
/// The whole step of a scene of discs, from force to position, on one screen.
///
///     forces → u* → contacts → rows (J, b, bounds) → A, q → λ → u → x
///
/// The solver is a parameter: it is given the MLCP as data and hands back λ. Chapter 3 passes its exact
/// ways, chapter 4 passes sweeps, and nothing else changes.
#pragma once

#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "common/contact.hpp"
#include "common/forces.hpp"
#include "common/scenes.hpp"

#include <type_traits>
#include <vector>

namespace rigid {

/// What a step depends on besides the state.
struct DiscSettings {
    Real h = 1.0 / 480;         ///< time step [s]
    Vec2 gravity = {0, -9.81};  ///< [m/s²]
    Real stiffness = 0;         ///< k of the torsional springs, a pure number; see add_bend_springs()
    Real damping = 0;           ///< of the bends [1/s]
    Real margin = 0.02;         ///< a contact gets its row when its gap is below this [m]
    Index pulled = world;       ///< the disc that a hand pulls; world = none
    Vec2 hand = {0, 0};         ///< where to [m]
};

/// Throws std::invalid_argument, naming the setting and its value, unless all of them make sense.
inline void require_valid(const DiscSettings& settings)
{
    require_step(settings.h);
    require_forces(settings.gravity, settings.stiffness, settings.damping, settings.hand);
    require_margin(settings.margin);
}

/// What the step finds on its way, kept for the reader to look at and for the next step to reuse.
struct DiscStep {
    VecX u_star;                    ///< velocities after the forces, before the impulses [m/s]
    std::vector<Contact> contacts;  ///< their rows stand behind those of the links
    std::vector<Row<2>> rows;
    AssemblyScratch scratch;
    Mlcp mlcp;
    Solution solution;
};

/// Calls a solver of either form.
template <class Solve>
void hand_over(const Solve& solve, const Mlcp& mlcp, Solution& solution)
{
    if constexpr (std::is_invocable_v<const Solve&, const Mlcp&, Solution&>) solve(mlcp, solution);
    else solution = solve(mlcp);
}

//! [rows]
/// One bilateral row for each link, then one unilateral row for each contact.
///
/// What we want is C(x + h u) = 0, or ≥ 0, after the step. To first order that is C + h J u,
/// hence the bias b = C/h, (3.30). It repays the whole of an error in one step; why that is rash
/// in general is a later chapter's subject.
/// \param h  time step [s]
inline void disc_rows(const DiscScene& scene, Real h, const std::vector<Contact>& contacts,
                      std::vector<Row<2>>& rows)
{
    const Bodies<2>& bodies = scene.bodies;
    rows.clear();
    for (const Link& link : scene.links) {
        const Constraint<2> rod = distance_constraint(bodies.x, link);
        rows.push_back(bilateral(rod, bodies.inverse_mass, rod.C / h));
    }
    for (const Contact& contact : contacts) {
        const Constraint<2> touch = contact_constraint(contact);
        rows.push_back(unilateral(touch, bodies.inverse_mass, touch.C / h));
    }
}
//! [rows]

//! [step]
/// One time step. Depends on its arguments alone.
/// \param solve  any callable: void(const Mlcp&, Solution&), where the Solution still holds the
///               last answer, or Solution(const Mlcp&). If it throws, the scene stands where it stood.
template <class Solve>
void step(DiscScene& scene, const DiscSettings& settings, const Solve& solve, DiscStep& now)
{
    Bodies<2>& bodies = scene.bodies;
    const Real h = settings.h;
    require_valid(settings);

    // Forces, and the velocity u* that they alone would lead to (3.4).
    bodies.f.setZero();
    add_gravity(bodies, settings.gravity);
    add_bend_springs(bodies, scene.bends, settings.stiffness, settings.damping);
    if (settings.pulled != world) add_pull(bodies, settings.pulled, settings.hand);
    now.u_star = bodies.u + h * bodies.inverse_mass.cwiseProduct(bodies.f);

    // What must not happen: the rows w = J u + b.
    find_contacts(bodies.x, scene.radius, scene.walls, scene.linked, settings.margin, now.contacts);
    disc_rows(scene, h, now.contacts, now.rows);

    // The least change of u* that keeps to them: w = A λ + q, complementary to λ (3.12).
    assemble(now.rows, now.u_star, now.scratch, now.mlcp);
    hand_over(solve, now.mlcp, now.solution);

    // u = u* + M⁻¹ Jᵀ λ (3.9), and with the new velocity the new position (1.10).
    bodies.u = now.u_star;
    apply(now.rows, now.solution.lambda, bodies.u);
    bodies.x += h * bodies.u;
}
//! [step]

}  // namespace rigid
