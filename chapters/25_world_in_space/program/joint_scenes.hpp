/// \file joint_scenes.hpp
/// What hangs and touches: Newton's cradle, and a chain with a heavy end.
#pragma once

#include "chapters/21_joints_in_space/program/hung_demo.hpp"
#include "chapters/24_friction_is_a_disc/program/touch_scenes.hpp"
#include "chapters/25_world_in_space/cradle.hpp"
#include "chapters/25_world_in_space/program/space_run.hpp"

namespace rigid {

inline Demo cradle_scene()
{
    Demo scene = space_demo(
        "cradle", "Newton's cradle: what one ball brings, the last takes away",
        {{0, 0}, {1.8, 1.35}}, 1.0 / 960, {"exact_cone", "cone"},
        [](const Settings& settings) {
            SpaceSetup setup;
            Cradle cradle;
            cradle.lifted = static_cast<int>(settings["lifted"]);
            cradle.gap = settings["gap"] / 1000;
            setup.scene = newtons_cradle(cradle);
            setup.restitution = settings["restitution"];
            setup.slop = 0;
            setup.skin = Skin::opaque;
            setup.camera.target = {0, 0.5, 0};
            setup.camera.distance = 5;
            setup.camera.azimuth = 0.35;
            setup.measure = [](const SpaceState& s) -> std::vector<Real> {
                const auto angle = [&s](const SpaceJoint& joint) {
                    return turn_of(twist, frames_of(s.scene.bodies.x, joint).q)
                        .value;
                };
                // hinges read zero where they were made
                const Vec3 first = centre_of(s.scene.bodies.x, 0),
                           hook = s.scene.joints[0].at_a;
                return {atan2(first.x() - hook.x(), hook.y() - first.y()) * 180 /
                            pi,
                        angle(s.scene.joints.back()) * 180 / pi,
                        energy(s.scene) - s.energy, largest_joint_error(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back({"lifted", "", "balls at the start", 1, 1, 4,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"gap", "mm", "between balls at rest", 2, 0, 20,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"restitution", "", "of the balls", 1, 0, 1,
                              Numbers::real, OnChange::restarts});
    add_touch_tunables(scene, 0, 500);
    scene.columns = {
        {"first", "°", "of the first ball's rod from the vertical", Plot::linear},
        {"last", "°", "of the last ball's rod from the vertical", Plot::linear},
        {"energy", "J", "less that of the start", Plot::linear},
        {"joint_error", "m", "largest of a locked coordinate", Plot::logarithmic}};
    return scene;
}

inline Demo heavy_scene()
{
    Demo scene = hung_demo<SpaceScene, SpaceSteps>(
        "heavy_end", "A chain of light links with a heavy ball at its end",
        {{0, 0}, {7.2, 5.4}},
        [](const Settings& settings) {
            SpaceSetup setup;
            setup.scene =
                heavy_chain(static_cast<int>(settings["links"]), settings["ratio"]);
            // for what may touch, and nothing does
            setup.scene.friction.assign(setup.scene.shapes.size(), 0.5);
            setup.camera = {{1.5, -4, 0}, 18};
            setup.skin = Skin::opaque;
            return setup;
        },
        {{"links", "", "of the chain", 30, 1, 50, Numbers::whole,
          OnChange::restarts},
         {"ratio", "", "mass of the ball over that of a link", 1000, 1, 10000,
          Numbers::real, OnChange::restarts},
         {"stiff", "", "a load makes a link hard to turn (cones)", 1, 0, 1,
          Numbers::whole},
         {"sweeps", "", "of a step, at most (cone)", 50, 1, 5000, Numbers::whole}});
    scene.methods.insert(scene.methods.begin(), {"exact_cone", "cone"});
    scene.h = 1.0 / 60;
    scene.tunables.back().value = 1;  // sub-steps
    return scene;
}

}  // namespace rigid
