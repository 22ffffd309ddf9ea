/// \file steps_alone.hpp
/// Steps, and nothing drawn, measured or written: what docs/web/test/step_times.mjs compares, in a page and without one.
#pragma once

#include "common/program/program.hpp"
#include "common/program/scripted_pointer.hpp"

namespace rigid {

/// Starts a scene so many times, and makes so many steps after each start, or fewer if one fails.
/// Returns how many it made after the last start. Each start is as the first.
inline long steps_alone(const Demo& scene, const Settings& settings, long steps, long starts)
{
    const ScriptedPointer pointer(settings.seed, scene.view);
    long made = 0;
    for (long start = 0; start < starts; ++start) {
        const std::unique_ptr<Run> run = scene.start(settings);
        try {
            for (made = 0; made < steps; ++made) {
                Input input;
                if (scene.steered)
                    input = {.pointer = pointer.at(static_cast<Real>(made) * settings.h), .present = true};
                run->step(settings, input);
            }
        } catch (const StepFailure&) {
            // An explicit method that explodes: there are as many steps as it has made.
        }
    }
    return made;
}

}  // namespace rigid
