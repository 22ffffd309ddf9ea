/// \file turning_run.hpp
/// What the programs of chapters 11 to 13 share: what a step is told, what is looked at after it, and a scene's sliders.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/11_rotation/program/rigid_picture.hpp"
#include "common/program/demo_of.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// A step of settings.h in settings["substeps"] parts; the pointer pulls the body that is nearest to it.
inline StepSettings step_settings(const Settings& settings, const Input& input,
                                  const Bodies<3>& bodies)
{
    StepSettings how{.h = settings.h,
                     .substeps = static_cast<int>(settings["substeps"])};
    if (input.pressed) {
        how.pulled = nearest_body(bodies, input.pointer);
        how.hand = input.pointer;
    }
    return how;
}

/// Throws StepFailure, naming the body, unless each position and velocity is finite.
inline void require_finite_state(const Bodies<3>& bodies)
{
    for (Index k = 0; k < bodies.count(); ++k)
        if (!bodies.position(k).allFinite() || !bodies.velocity(k).allFinite())
            throw StepFailure("the state of body " + std::to_string(k) +
                              " is not finite");
}

/// A scene whose steps `Turning` takes, with the tunables that all of them have.
template <class Turning, class Setup>
Demo turning_demo(const std::string& name, const std::string& summary,
                  const View& view, Real h, std::vector<std::string> methods,
                  std::function<Setup(const Settings&)> setup)
{
    return demo_of<Turning>(
        name, summary, view, h, std::move(methods),
        {{"substeps", "", "parts of a step", 1, 1, 64, Numbers::whole,
          OnChange::goes_on, Keys::up_and_down},
         {"sweeps", "", "sweeps a sub-step, of the methods that sweep", 10, 1, 200,
          Numbers::whole}},
        std::move(setup));
}

}  // namespace rigid
