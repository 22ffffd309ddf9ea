/// \file water_step.hpp
/// One step of bodies and water together, with the step of chapters 3 to 14 as it is.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/29_waves/floating.hpp"

namespace rigid {

//! [water_step]
/// Slices and levels; slopes and drag on both; then contacts and joints move the
/// bodies, and velocities the water. Throws std::invalid_argument, before anything
/// moves, for bodies or water that are not valid, or a step beyond
/// Floating::stable_step().
template <class Scene, class Method>
void step(Scene& scene, ShallowWater& water, Floating& floating,
          const StepSettings& settings, Method&& method, StepData<3>& now)
{
    require_step(settings.h);
    require_bodies(scene);
    require_valid(water);
    floating.find(scene, water);  // waves are faster where a hull is
    const Real longest = floating.stable_step(water);
    if (settings.h > longest * (1 + 1e-12))
        throw std::invalid_argument("the time step is " + shortest(settings.h) +
                                    " s; a wave passes a whole cell in " +
                                    shortest(longest) + " s");
    floating.push(scene, water, settings.h);
    step(scene, settings, method, now);
    carry_water(water, settings.h);
}
//! [water_step]

}  // namespace rigid
