/// \file small_scenes.hpp
/// Two scenes of this chapter: a disc in a groove, and Newton's cradle with its own step.
#pragma once

#include "chapters/06_sequential_impulse/impacts.hpp"
#include "chapters/06_sequential_impulse/impulse_method.hpp"
#include "common/elementary.hpp"

#include <cmath>

namespace rigid {

/// A disc of 1 kg and radius 0.1 m at rest in a groove whose sides rise at an angle: it touches both. The normals
/// are n₁ = (sin α, cos α) and n₂ = (−sin α, cos α).
/// \param angle  α [rad], 0 … 90°
inline DiscScene groove(Real angle)
{
    DiscScene scene;
    scene.bodies = Bodies<2>(1);
    scene.radius = VecX::Constant(1, 0.1);
    scene.bodies.position(0) = Vec2(0, 0.1 / cos(angle));
    scene.walls = {{{sin(angle), cos(angle)}, 0}, {{-sin(angle), cos(angle)}, 0}};
    scene.half_size = {0.4, 0.3};
    return scene;
}

/// Newton's cradle: N balls of 1 kg and radius 0.1 m side by side, touching, each on a rod of 1 m. Bodies
/// 0 … N − 1 are the balls, from left to right; N … 2N − 1 are what they hang from.
/// \param lifted  so many balls, from the left, are drawn aside
/// \param angle   by so much [rad]
inline DiscScene cradle(Index count, Index lifted, Real angle)
{
    require_count("balls of a cradle", count);
    constexpr Real radius = 0.1, length = 1;
    DiscScene scene;
    scene.bodies = Bodies<2>(2 * count);
    scene.radius = VecX::Constant(2 * count, radius);
    scene.radius.tail(count).setConstant(0.2 * radius);
    for (Index k = 0; k < count; ++k) {
        const Vec2 pivot(radius * static_cast<Real>(2 * k + 1 - count), length);
        const Real aside = k < lifted ? angle : 0;
        scene.bodies.position(count + k) = pivot;
        scene.bodies.position(k) = pivot - length * Vec2(sin(aside), cos(aside));
        scene.bodies.inverse_mass.segment<2>(2 * (count + k)).setZero();
        scene.links.push_back({count + k, k, length});
    }
    scene.half_size = {radius * static_cast<Real>(count) + 0.6, 0.7};
    link_neighbours(scene);
    return scene;
}

enum class ImpactOrder { simultaneous, sequential };

/// What a step of impacts depends on and what it needs, kept from step to step.
struct ImpactStep {
    Real restitution = 0;    ///< e of every contact, 0 … 1
    ImpulseSettings sweeps;  ///< of the step after the impacts

    std::vector<Contact> contacts;
    std::vector<Row<2>> rows;  ///< contacts, first for the impacts
    ImpulseMemory<2> memory;
    Solution solution;
    ImpulseMethod method;  ///< of the step after the impacts
    StepData<2> rest;
};

//! [impact_step]
/// One step: contacts that close in it hit first, by one of the two laws; then this
/// chapter's step, in which nothing bounces any more.
/// \param touching  a gap below this counts as none [ℓ]: the simultaneous law
///                  depends on which bodies touch
inline void impact_step(DiscScene& scene, const StepSettings& settings,
                        ImpactOrder law, ImpactStep& now, Real touching = 1e-4)
{
    Bodies<2>& bodies = scene.bodies;
    require_step(settings.h);
    const Real length = typical_length(scene);
    find_contacts(scene, settings.margin * length, now.contacts);
    now.rows.clear();
    for (const Contact& contact : now.contacts)
        now.rows.push_back(unilateral(
            contact_constraint(contact), bodies.inverse_mass,
            contact.gap > touching * length ? contact.gap / settings.h : 0));
    const Real e = now.restitution;
    if (law == ImpactOrder::sequential) {
        sequential_impacts(now.rows, e, 1e-12, 1000, bodies.u, now.solution);
    } else {
        newton_biases(now.rows, e, bodies.u);
        now.solution.lambda.resize(0);
        sequential_impulse(now.rows, {}, {.max_sweeps = 10000, .tolerance = 1e-12},
                           now.memory, bodies.u, now.solution);
    }
    now.method.solver.sweeps = now.sweeps;
    step(scene, settings, now.method, now.rest);
}
//! [impact_step]

}  // namespace rigid
