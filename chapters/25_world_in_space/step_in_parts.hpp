/// \file step_in_parts.hpp
/// A step in parts, each of which looks for contacts: what Bullet, ODE and Jolt call sub-steps.
#pragma once

#include "chapters/25_world_in_space/space_method.hpp"

namespace rigid {

//! [parts]
/// So many steps of h/parts. A sub-step has the contacts of its step, whose normals
/// and points stay as they were found; a part finds its own.
/// \param parts  1 or more
/// \param now    of the last part, with the visits of all
template <class Method>
void step_in_parts(SpaceScene& scene, StepSettings settings, int parts,
                   Method&& method, StepData<6>& now)
{
    if (parts < 1)
        throw std::invalid_argument("a step is taken in " + std::to_string(parts) +
                                    " parts; it must be 1 or more");
    settings.h /= parts;
    std::int64_t visits = 0;
    for (int i = 0; i < parts; ++i) {
        step(scene, settings, method, now);
        visits += now.visits;
    }
    now.visits = visits;
}
//! [parts]

}  // namespace rigid
