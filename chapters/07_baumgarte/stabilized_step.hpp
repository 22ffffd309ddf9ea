/// \file stabilized_step.hpp
/// The step of a scene of discs, from force to position, with one of the ways to repay a position error.
///
///     forces → u* → contacts → C, J → rows (b, bounds) → λ → u → x
///
/// Chapter 6's step, with another b, and with what some of the ways do to x afterwards. It may be taken in several
/// substeps: contacts are found once, everything else is done n times with h/n.
#pragma once

#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/07_baumgarte/projection.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"
#include "common/contact.hpp"
#include "common/forces.hpp"
#include "common/scenes.hpp"

#include <vector>

namespace rigid {

/// What a step depends on besides the state.
struct StabilizedStepSettings {
    Real h = 1.0 / 60;          ///< time step [s]
    Vec2 gravity = {0, -9.81};  ///< [m/s²]
    Real stiffness = 0;         ///< k of the torsional springs, a pure number; see add_bend_springs()
    Real damping = 0;           ///< of the bends [1/s]
    Real margin = 0.02;         ///< a contact gets its row when its gap is below this [m]
    Index pulled = world;       ///< the disc that a hand pulls; world = none
    Vec2 hand = {0, 0};         ///< where to [m]
    ImpulseSettings sweeps;     ///< of each substep
    StabilizerSettings stabilizer;
    int substeps = 1;
    bool warm = false;  ///< later substeps start from the λ of the one before; else from zero
};

/// What the step finds on its way, kept for the reader to look at and for the next step to reuse.
struct StabilizedStep {
    VecX u_star;  ///< velocities after the forces, before the impulses [m/s]
    std::vector<Contact>
        contacts;  ///< found at the beginning of the step; their rows stand behind the links'
    VecX x_found;  ///< where the bodies were then [m]
    std::vector<Constraint<2>> constraints;
    std::vector<Row<2>> rows;
    std::vector<int> order;  ///< of the visits; empty = as they are
    ImpulseMemory<2> memory;
    VecX v;                   ///< pseudo-velocities of split_impulse [m/s]
    Solution solution;        ///< λ [N s] of the last substep; find_step_contacts() sets it to zero
    std::int64_t visits = 0;  ///< rows visited in this step, whatever for
};

/// Constraint i of a scene of discs at any positions: links first, then contacts.
struct DiscConstraintAt {
    const DiscScene& scene;
    const StabilizedStep& now;

    Constraint<2> operator()(std::size_t i, const VecX& x) const
    {
        const std::size_t links = scene.links.size();
        if (i < links) return distance_constraint(x, scene.links[i]);
        Contact contact = now.contacts[i - links];
        const Vec2 xb = x.segment<2>(2 * contact.b);
        if (contact.a == world) {  // a wall is flat: its normal stays
            contact.gap += contact.normal.dot(xb - now.x_found.segment<2>(2 * contact.b));
            return contact_constraint(contact);
        }
        const Direction d(xb - x.segment<2>(2 * contact.a));
        contact.normal = d.n;
        contact.gap = d.length - scene.radius[contact.a] - scene.radius[contact.b];
        return contact_constraint(contact);
    }
};

/// The first arrow of a step: which contacts it has. Sets λ to zero for each link and contact; who knows better
/// (chapter 8) writes another λ there before advance().
inline void find_step_contacts(const DiscScene& scene, const StabilizedStepSettings& settings,
                               StabilizedStep& now)
{
    require_step(settings.h);
    require_valid(settings.stabilizer);
    if (settings.substeps < 1)
        throw std::invalid_argument("substeps is " + std::to_string(settings.substeps) +
                                    "; it must be 1 or more");
    find_contacts(scene.bodies.x, scene.radius, scene.walls, scene.linked, settings.margin, now.contacts);
    now.x_found = scene.bodies.x;
    now.solution.lambda.setZero(static_cast<Index>(scene.links.size() + now.contacts.size()));
    now.visits = 0;
}

//! [substep]
/// One small step h with the contacts that were found. The sweeps start from now.solution.lambda.
inline void substep(DiscScene& scene, const StabilizedStepSettings& settings, Real h, StabilizedStep& now)
{
    Bodies<2>& bodies = scene.bodies;
    const StabilizerSettings& stabilizer = settings.stabilizer;
    const std::size_t links = scene.links.size(), count = links + now.contacts.size();
    const DiscConstraintAt constraint_at{scene, now};

    // Forces, and the velocity u* that they alone would lead to (3.4).
    bodies.f.setZero();
    add_gravity(bodies, settings.gravity);
    add_bend_springs(bodies, scene.bends, settings.stiffness, settings.damping);
    if (settings.pulled != world) add_pull(bodies, settings.pulled, settings.hand);
    now.u_star = bodies.u + h * bodies.inverse_mass.cwiseProduct(bodies.f);

    // C and J where the bodies are now, and what b makes of C.
    now.constraints.resize(count);
    for (std::size_t i = 0; i < count; ++i) now.constraints[i] = constraint_at(i, bodies.x);
    const std::span<const Constraint<2>> constraints(now.constraints);
    stabilized_rows(constraints, links, bodies.inverse_mass, stabilizer, h, now.rows);

    // λ by sweeps, and the new velocity.
    bodies.u = now.u_star;
    sequential_impulse(now.rows, now.order, settings.sweeps, now.memory, bodies.u, now.solution);
    now.visits += now.memory.visits;

    // The new positions, and what repays the error outside of b.
    bodies.x += h * bodies.u;
    switch (stabilizer.method) {
    case Stabilizer::none:
    case Stabilizer::baumgarte:
        break;
    case Stabilizer::relaxation:
        now.visits += relax(constraints, now.order, links, stabilizer, h, now.memory);
        bodies.u = now.memory.u.head(bodies.u.size());
        for (std::size_t k = 0; k < count; ++k)
            now.solution.lambda[now.order.empty() ? static_cast<Index>(k) : now.order[k]] =
                now.memory.rows[k].lambda;
        break;
    case Stabilizer::split_impulse:
        now.visits += split_impulse(constraints, now.order, links, stabilizer, h, now.memory, now.v);
        bodies.x += h * now.v.head(bodies.x.size());
        break;
    case Stabilizer::projection:
        now.visits += project_positions<2>(constraint_at, count, now.order, links, bodies.inverse_mass,
                                           stabilizer, h, bodies.x);
        break;
    }
}
//! [substep]

/// All substeps, with the contacts that find_step_contacts() found, from the λ that now.solution holds.
inline void advance(DiscScene& scene, const StabilizedStepSettings& settings, StabilizedStep& now)
{
    const Real h = settings.h / settings.substeps;
    for (int k = 0; k < settings.substeps; ++k) {
        if (k > 0 && !settings.warm) now.solution.lambda.setZero();
        substep(scene, settings, h, now);
    }
}

//! [step]
/// One time step. Depends on its arguments alone.
inline void stabilized_step(DiscScene& scene, const StabilizedStepSettings& settings, StabilizedStep& now)
{
    find_step_contacts(scene, settings, now);
    advance(scene, settings, now);
}
//! [step]

}  // namespace rigid
