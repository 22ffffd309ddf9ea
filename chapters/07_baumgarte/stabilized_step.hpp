/// \file stabilized_step.hpp
/// The step of a scene of discs, from force to position, with one of the ways to repay a position error.
///
///     forces → u* → contacts → C, J → rows (b, bounds) → order → λ → u → x
///
/// Chapter 6's step with another b, and with what some of the ways do to x afterwards. It may be taken in several
/// substeps: contacts are found once, all the rest is done n times with h/n.
#pragma once

#include "chapters/06_sequential_impulse/impulse_step.hpp"
#include "chapters/07_baumgarte/projection.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"
#include "common/text.hpp"

namespace rigid {

/// What a step depends on besides the state.
struct StabilizedStepSettings : ImpulseStepSettings {
    StabilizerSettings stabilizer;
    int substeps = 1;
    Real carry = 0;           ///< part of λ that the next substep starts from, 0 … 1; see (7.21)
    bool repay_once = false;  ///< projection after the last substep only, instead of after each
};

/// What the step finds on its way, kept for the reader to look at and for the next step to reuse. `solution` holds
/// the λ of the last substep: links, contacts, machines.
struct StabilizedStep : ImpulseStep {
    VecX x_found;             ///< where the bodies were when the contacts were found [m]
    bool ordered = false;     ///< the order of the visits is chosen once in a step
    VecX v;                   ///< pseudo-velocities of split_impulse [m/s]
    std::vector<Real> goal;   ///< of projection [m]
    std::int64_t visits = 0;  ///< rows visited in this step, whatever for
};

//! [constraint_at]
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
        } else {
            const Direction d(xb - x.segment<2>(2 * contact.a));
            contact.normal = d.n;
            contact.gap = d.length - scene.radius[contact.a] - scene.radius[contact.b];
        }
        return contact_constraint(contact);
    }
};
//! [constraint_at]

/// The first arrow of a step: which contacts it has. Sets λ to zero for each link, contact and machine; who knows
/// better (chapter 8) writes another λ there before advance().
///
/// Throws std::invalid_argument, naming the setting and its value, unless the settings make sense.
inline void find_step_contacts(const DiscScene& scene, const StabilizedStepSettings& settings,
                               StabilizedStep& now)
{
    require_valid(static_cast<const ImpulseStepSettings&>(settings));
    require_valid(settings.stabilizer);
    if (settings.substeps < 1)
        throw std::invalid_argument("substeps is " + std::to_string(settings.substeps) +
                                    "; it must be 1 or more");
    if (!(settings.carry >= 0 && settings.carry <= 1))
        throw std::invalid_argument("carry is " + shortest(settings.carry) + "; it must be from 0 to 1");
    find_contacts(scene.bodies.x, scene.radius, scene.walls, scene.linked, settings.margin, now.contacts);
    now.x_found = scene.bodies.x;
    now.ordered = false;
    now.visits = 0;
    now.solution.lambda.setZero(
        static_cast<Index>(scene.links.size() + now.contacts.size() + now.machines.size()));
}

/// Contacts that bounce, (6.16): a bounce that is faster than the repaying speed takes its place.
inline void add_bounces(const DiscScene& scene, const StabilizedStepSettings& settings, Real h,
                        StabilizedStep& now)
{
    if (!(settings.restitution > 0)) return;
    const Real slowest = settings.threshold * settings.gravity.norm() * settings.h;
    for (std::size_t i = scene.links.size(); i < now.constraints.size(); ++i) {
        Row<2>& row = now.rows[i];
        const Real repaying = std::exchange(row.bias, 0);
        const Real b = contact_bias(now.constraints[i].C, row.velocity(scene.bodies.u),
                                    row.velocity(now.u_star), settings.restitution, slowest, h);
        row.bias = b < 0 ? std::min(b, repaying) : repaying;
    }
}

//! [substep_rows]
/// The first half of a small step h: forces, u*, and the rows where the bodies are now.
inline void substep_rows(DiscScene& scene, const StabilizedStepSettings& settings, Real h,
                         StabilizedStep& now)
{
    Bodies<2>& bodies = scene.bodies;

    // Forces, and the velocity u* that they alone would lead to (3.4).
    bodies.f.setZero();
    add_gravity(bodies, settings.gravity);
    add_bend_springs(bodies, scene.bends, settings.stiffness, settings.damping);
    if (settings.pulled != world) add_pull(bodies, settings.pulled, settings.hand);
    now.u_star = bodies.u + h * bodies.inverse_mass.cwiseProduct(bodies.f);

    // C and J where the bodies are now; b is what the stabiliser makes of C, or a bounce.
    now.constraints.resize(scene.links.size() + now.contacts.size());
    for (std::size_t i = 0; i < now.constraints.size(); ++i)
        now.constraints[i] = DiscConstraintAt{scene, now}(i, bodies.x);
    stabilized_rows<2>(now.constraints, scene.links.size(), bodies.inverse_mass, settings.stabilizer, h,
                       now.rows);
    add_bounces(scene, settings, h, now);
    now.rows.insert(now.rows.end(), now.machines.begin(), now.machines.end());
    if (!now.ordered)
        order_rows(now.rows, bodies.count(), settings.order, now.random, now.colouring, now.order);
    now.ordered = true;
}
//! [substep_rows]

//! [substep_solve]
/// The second half: λ by sweeps from now.solution.lambda, u, x, and what repays the error outside of b.
/// \param last  this is the last substep of the step
inline void substep_solve(DiscScene& scene, const StabilizedStepSettings& settings, Real h, bool last,
                          StabilizedStep& now)
{
    Bodies<2>& bodies = scene.bodies;
    const StabilizerSettings& stabilizer = settings.stabilizer;
    const std::span<const Constraint<2>> constraints(now.constraints);
    const std::size_t links = scene.links.size();

    ImpulseSettings sweeps = settings.sweeps;
    sweeps.alternate = settings.order == Order::alternating;
    bodies.u = now.u_star;
    sequential_impulse(now.rows, now.order, sweeps, now.memory, bodies.u, now.solution);
    now.visits += now.memory.visits;
    bodies.x += h * bodies.u;

    switch (stabilizer.method) {
    case Stabilizer::none:
    case Stabilizer::baumgarte:
        break;
    case Stabilizer::relaxation:
        now.visits += relax(constraints, now.order, links, stabilizer, h, now.memory);
        bodies.u = now.memory.u;
        read_impulses(now.memory, now.order, now.solution.lambda);
        break;
    case Stabilizer::split_impulse:
        now.visits += split_impulse(constraints, now.order, links, stabilizer, h, now.memory, now.v);
        bodies.x += h * now.v;
        break;
    case Stabilizer::projection:
        if (!settings.repay_once || last)
            now.visits += project_positions<2>(DiscConstraintAt{scene, now}, constraints.size(), {}, links,
                                               bodies.inverse_mass, stabilizer,
                                               settings.repay_once ? settings.h : h, now.goal, bodies.x);
        break;
    }
}
//! [substep_solve]

//! [step]
/// All substeps, with the contacts that find_step_contacts() found, from the λ that now.solution holds.
inline void advance(DiscScene& scene, const StabilizedStepSettings& settings, StabilizedStep& now)
{
    const Real h = settings.h / settings.substeps;
    for (int k = 0; k < settings.substeps; ++k) {
        if (k > 0) now.solution.lambda *= settings.carry;
        substep_rows(scene, settings, h, now);
        substep_solve(scene, settings, h, k + 1 == settings.substeps, now);
    }
}

/// One time step. Depends on its arguments alone.
inline void stabilized_step(DiscScene& scene, const StabilizedStepSettings& settings, StabilizedStep& now)
{
    find_step_contacts(scene, settings, now);
    advance(scene, settings, now);
}
//! [step]

}  // namespace rigid
