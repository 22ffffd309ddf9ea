/// \file space_run.hpp
/// One scene in space, under one of this chapter's methods.
#pragma once

#include "chapters/24_friction_is_a_disc/program/space_run.hpp"
#include "chapters/25_world_in_space/program/space_picture.hpp"
#include "chapters/25_world_in_space/step_in_parts.hpp"

#include <string>

namespace rigid {

using SpaceState = SolidState<SpaceScene>;
using SpaceSetup = SolidSetup<SpaceScene>;

class SpaceSteps {
public:
    explicit SpaceSteps(const SpaceSetup& setup)
    {
        one_by_one_.contacts.ground.as_one = false;
        cones_.correction.slop = boxes_.correction.slop = guesses_.correction.slop =
            setup.slop;
        cones_.correction.restitution = boxes_.correction.restitution =
            guesses_.correction.restitution = setup.restitution;
        islands_.solver.sweeps = {200, 1e-9};
    }

    void step(SpaceScene& scene, const Settings& settings, const StepSettings& how,
              StepData<6>& now)
    {
        const auto take = [&](auto& method, Real tolerance = 1e-6) {
            method.solver.sweeps = {static_cast<int>(settings["sweeps"]),
                                    tolerance};
            if (settings.tunables.contains("stiff"))
                method.correction.stiff = settings["stiff"] > 0;
            const bool parts = settings.tunables.contains("parts");
            step_in_parts(scene, how,
                          parts ? static_cast<int>(settings["parts"]) : 1, method,
                          now);
        };
        const std::string& by = settings.method;
        if (by == "exact") rigid::step(scene, how, exact_, now);
        else if (by == "islands") rigid::step(scene, how, islands_, now);
        else if (by == "cone") take(cones_);
        else if (by == "box") take(boxes_);
        else if (by == "exact_cone") take(guesses_, 1e-9);
        else take(one_by_one_);
    }
    static void draw_ground(SolidPicture& picture, const SpaceScene& scene)
    {
        for (const auto& mesh : scene.meshes) draw_mesh(picture, *mesh);
    }
    static void draw_more(SolidPicture& picture, const SpaceScene& scene)
    {
        draw_boats(picture, scene);
    }

private:
    SpaceExact exact_;
    SpaceIslands islands_;
    TouchingCones cones_, one_by_one_, guesses_ = exact_cones();
    TouchingBoxes boxes_;
};

inline constexpr auto space_demo = solid_demo<SpaceScene, SpaceSteps>;

}  // namespace rigid
