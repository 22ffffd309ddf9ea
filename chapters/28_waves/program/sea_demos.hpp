/// \file sea_demos.hpp
/// The scenes on water of two directions, with their tunables.
#pragma once

#include "chapters/28_waves/program/line_run.hpp"
#include "chapters/28_waves/program/sea_run.hpp"

#include <functional>

namespace rigid {

inline Demo sea_demo_of(const std::string& name, const std::string& summary,
                        std::vector<Tunable> tunables,
                        const std::function<SeaSetup(const Settings&)>& setup)
{
    tunables.insert(
        tunables.end(),
        {{"waves", "m", "height of waves from the left wall", 0.05, 0, 0.3},
         {"period", "s", "of these waves", 2.5, 0.5, 10},
         {"drag", "", "of what goes ahead", 1, 0, 10},
         wave_number("displace", "", "1: bodies make waves; 0: they do not", 1, 0,
                     1, Numbers::whole),
         {"camera", "°", "where the eye is, around the scene", 20, -60, 60}});
    Demo scene = demo_of<SeaRun>(name, summary, {{0, -0.2}, {8.4, 4.2}}, 1.0 / 60,
                                 {"box"}, std::move(tunables), setup);
    scene.held = "presses the water";
    scene.columns = {
        {"x", "m", "of the body"},
        {"y", "m", "of the body", Plot::linear},
        {"z", "m", "of the body"},
        {"lean", "°", "of the body", Plot::linear},
        {"speed", "m/s", "of the body", Plot::linear},
        {"volume", "", "of the water, over that of the start, less 1"}};
    return scene;
}

inline Demo sea_demo()
{
    return sea_demo_of(
        "sea", "A boat to steer, a raft, a duck and a crate",
        {{"throttle", "N", "of the propeller", 250, -500, 1000},
         {"rudder", "°", "to port, negative; to starboard, positive", 15, -45, 45}},
        [](const Settings&) {
            SeaSetup setup{sea(96, 12, 1.2), world, 0};
            setup.steered = setup.watched = add_boat(setup.sea, -3, 1.5);
            add_duck(setup.sea, 1.5, 2.6);
            add_raft(setup.sea, 1.5, -2, 3, 2);
            add_floating_box(setup.sea, {-2.5, 0, -3}, {0.8, 0.6, 0.9}, 0.5, 0.1);
            return setup;
        });
}

inline Demo crates_demo()
{
    return sea_demo_of(
        "crates", "Which box capsizes, in space?",
        {wave_number("part", "", "density over that of water", 0.5, 0.05, 0.95),
         wave_number("ratio", "", "width over height of the middle one", 1.2, 0.3,
                     4)},
        [](const Settings& settings) {
            SeaSetup setup{sea(96, 12, 1.2), world, 1};
            const Real part = settings["part"];
            add_floating_box(setup.sea, {-3, 0, 0}, {0.7, 0.7, 1.6}, part, 0.05);
            add_floating_box(setup.sea, {0, 0, 0},
                             {0.7 * settings["ratio"], 0.7, 1.6}, part, 0.05);
            add_floating_box(setup.sea, {3, 0, 0}, {1.2, 0.7, 1.6}, part, 0.05);
            return setup;
        });
}

}  // namespace rigid
