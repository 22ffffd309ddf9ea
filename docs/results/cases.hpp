/// \file cases.hpp
/// The cases by subject, and what they share.
#pragma once

#include "docs/results/one_step.hpp"

#include "common/scenes.hpp"

namespace rigid::results {

void add_smooth_motion(Registry& registry);  ///< Kepler's orbit and a pendulum, free and on a rod
void add_lines(Registry& registry);          ///< the impulses of one step: chains and columns
void add_heaps(Registry& registry);          ///< triangles of discs, and the ten discs
void add_bounces(Registry& registry);        ///< a ball that bounces
void add_runs(Registry& registry);           ///< a thousand steps of chains and heaps, as engines take them

/// The step of a scene that is at rest and stays so. \param h  [s]
OneStep resting_step(const DiscScene& scene, Real h);

inline Registry all_cases()
{
    Registry registry;
    add_smooth_motion(registry);
    add_lines(registry);
    add_heaps(registry);
    add_bounces(registry);
    add_runs(registry);
    return registry;
}

}  // namespace rigid::results
