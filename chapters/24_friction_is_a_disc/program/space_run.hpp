/// \file space_run.hpp
/// Solids with friction: on a disc, on a box, in a pyramid, on a disc solved exactly.
#pragma once

#include "chapters/23_faces_that_touch/program/space_run.hpp"
#include "chapters/24_friction_is_a_disc/program/boat_picture.hpp"
#include "chapters/24_friction_is_a_disc/rough_touching.hpp"

namespace rigid {

class RoughSteps {
public:
    explicit RoughSteps(const SolidSetup<RoughSolids>& setup)
    {
        cones_.correction.slop = boxes_.correction.slop = guesses_.correction.slop =
            setup.slop;
    }

    void step(RoughSolids& scene, const Settings& settings, const StepSettings& how,
              StepData<6>& now)
    {
        const auto take = [&](auto& method, Real tolerance = 1e-6) {
            method.solver.sweeps = {static_cast<int>(settings["sweeps"]),
                                    tolerance};
            rigid::step(scene, how, method, now);
        };
        const std::string& by = settings.method;
        if (by == "cone") take(cones_);
        else if (by == "box") take(boxes_);
        else if (by == "exact_cone") take(guesses_, 1e-9);
        else {
            pyramids_.solver.corners = static_cast<int>(settings["corners"]);
            take(pyramids_);
        }
    }
    static void draw_ground(SolidPicture&, const RoughSolids&) {}
    static void draw_more(SolidPicture& picture, const RoughSolids& scene)
    {
        draw_boats(picture, scene);
    }

private:
    RoughCones cones_, pyramids_, guesses_ = solved_exactly();
    RoughBoxes boxes_;
};

using RoughState = SolidState<RoughSolids>;
using RoughSetup = SolidSetup<RoughSolids>;
inline constexpr auto rough_demo = solid_demo<RoughSolids, RoughSteps>;

}  // namespace rigid
