/// \file impulse_step.hpp
/// The whole step of a scene of discs, from force to position, on one screen.
///
///     forces → u* → contacts → C, J → rows (b, bounds) → order → λ → u → x
///
/// Chapter 3's step without the matrix: the rows go to the sweeps as they are.
#pragma once

#include "chapters/06_sequential_impulse/bias_and_bounds.hpp"
#include "chapters/06_sequential_impulse/disc_constraints.hpp"
#include "chapters/06_sequential_impulse/row_order.hpp"
#include "chapters/06_sequential_impulse/sequential_impulse.hpp"
#include "common/contact.hpp"
#include "common/forces.hpp"
#include "common/text.hpp"

namespace rigid {

/// What a step depends on besides the state.
struct ImpulseStepSettings {
    Real h = 1.0 / 60;          ///< time step [s]
    Vec2 gravity = {0, -9.81};  ///< [m/s²]
    Real stiffness = 0;         ///< k of the torsional springs, a pure number; see add_bend_springs()
    Real damping = 0;           ///< of the bends [1/s]
    Real margin = 0.02;         ///< a contact gets its row when its gap is below this [m]
    Index pulled = world;       ///< the disc that a hand pulls; world = none
    Vec2 hand = {0, 0};         ///< where to [m]
    Real restitution = 0;       ///< e of every contact, 0 … 1
    Real threshold = 2;  ///< contacts that approach slower than threshold · |gravity| · h do not bounce
    ImpulseSettings sweeps;
    Order order = Order::given;
};

/// Throws std::invalid_argument, naming the setting and its value, unless all of them make sense.
inline void require_valid(const ImpulseStepSettings& settings)
{
    require_step(settings.h);
    const auto refuse = [](const std::string& what, Real value, const std::string& wanted) {
        throw std::invalid_argument(what + " is " + shortest(value) + "; it must be " + wanted);
    };
    require_forces(settings.gravity, settings.stiffness, settings.damping, settings.hand);
    require_margin(settings.margin);
    if (!(settings.restitution >= 0 && settings.restitution <= 1))
        refuse("the restitution", settings.restitution, "from 0 to 1");
    if (!(settings.threshold >= 0))
        refuse("the threshold of bounces", settings.threshold, "zero or positive");
    if (!(settings.sweeps.tolerance >= 0))
        refuse("the tolerance of the sweeps", settings.sweeps.tolerance, "zero or positive");
    if (settings.sweeps.max_sweeps < 0)
        refuse("the number of sweeps", settings.sweeps.max_sweeps, "zero or positive");
}

/// What the step finds on its way, kept for the reader to look at and for the next step to reuse.
struct ImpulseStep {
    VecX u_star;                    ///< velocities after the forces, before the impulses [m/s]
    std::vector<Contact> contacts;  ///< their rows stand behind those of the links
    std::vector<Constraint<2>> constraints;
    std::vector<Row<2>> rows;
    std::vector<Row<2>> machines;  ///< in: motors, ropes, stops at the present positions; last among the rows
    Random random{1};              ///< for a shuffled order
    Colouring colouring;
    std::vector<int> order;
    ImpulseMemory<2> memory;
    Solution solution;
};

//! [restitution]
/// The bias of contacts that bounce, (6.17). `rows` begins with those of the links.
inline void add_restitution(const DiscScene& scene, const ImpulseStepSettings& settings, ImpulseStep& now)
{
    if (!(settings.restitution > 0)) return;
    const Real slowest = settings.threshold * settings.gravity.norm() * settings.h;
    for (std::size_t i = scene.links.size(); i < now.constraints.size(); ++i) {
        Row<2>& row = now.rows[i];
        row.bias = 0;
        row.bias = contact_bias(now.constraints[i].C, row.velocity(scene.bodies.u), row.velocity(now.u_star),
                                settings.restitution, slowest, settings.h);
    }
}
//! [restitution]

//! [step]
/// One time step. Depends on its arguments alone.
/// \param solve  what finds λ: void(rows, order, sweeps, memory, u, solution), as sequential_impulse()
template <class Solve>
void impulse_step(DiscScene& scene, const ImpulseStepSettings& settings, const Solve& solve, ImpulseStep& now)
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

    // What must not happen: C and J, and the rows w = J u + b with their bounds.
    find_contacts(bodies.x, scene.radius, scene.walls, scene.linked, settings.margin, now.contacts);
    disc_constraints(scene, now.contacts, now.constraints);
    constraint_rows(now.constraints, scene.links.size(), bodies.inverse_mass, h, now.rows);
    add_restitution(scene, settings, now);
    now.rows.insert(now.rows.end(), now.machines.begin(), now.machines.end());

    // Sweeps on the velocities themselves, (6.5): u is u* + M⁻¹ Jᵀ λ at each moment.
    order_rows(now.rows, bodies.count(), settings.order, now.random, now.colouring, now.order);
    ImpulseSettings sweeps = settings.sweeps;
    sweeps.alternate = settings.order == Order::alternating;
    now.solution.lambda.setZero(static_cast<Index>(now.rows.size()));  // nothing is remembered
    bodies.u = now.u_star;
    solve(now.rows, now.order, sweeps, now.memory, bodies.u, now.solution);

    bodies.x += h * bodies.u;
}
//! [step]

/// The same with this chapter's sweeps.
inline void impulse_step(DiscScene& scene, const ImpulseStepSettings& settings, ImpulseStep& now)
{
    impulse_step(scene, settings, sequential_impulse<2>, now);
}

}  // namespace rigid
