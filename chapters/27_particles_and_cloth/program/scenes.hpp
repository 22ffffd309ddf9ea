/// \file scenes.hpp
/// Sheets that hang, wave and tear.
#pragma once

#include "chapters/27_particles_and_cloth/program/line_scenes.hpp"

namespace rigid {

inline Tunable squares_tunable(Real squares, Real most)
{
    return {"squares", "",   "of a side",    squares,
            2,         most, Numbers::whole, OnChange::restarts};
}

/// A scene of a sheet: how it is made, seen, and what changes while it runs.
template <class State>
Demo sheet_demo(
    const std::string& name, const std::string& summary, const View& view,
    const Camera& camera, Real ground, Real squares, Real k,
    std::function<typename State::Scene(const Settings&)> make,
    std::function<void(State&, const Settings&)> change = {},
    std::function<std::vector<Real>(const State&)> measure = cloth_measures<State>)
{
    Demo scene =
        cloth_demo<State>(name, summary, view, 8, 1,
                          [=, make = std::move(make)](const Settings& settings) {
                              ClothSetup<State> setup;
                              setup.cloth = make(settings);
                              setup.camera = camera;
                              setup.ground = ground;
                              setup.measure = measure;
                              setup.change = change;
                              return setup;
                          });
    scene.tunables.push_back(squares_tunable(squares, 100));
    scene.tunables.push_back(stiffness_tunable(k));
    scene.tunables.push_back(
        {"limit", "%", "threads are drawn back to it; 0: none", 0, 0, 50});
    scene.columns = cloth_columns;
    return scene;
}

inline int squares_of(const Settings& settings)
{
    return static_cast<int>(settings["squares"]);
}

inline Demo hung_demo_of_cloth()
{
    return sheet_demo<ClothState>(
        "sheet", "A sheet on two corners", {{0, -0.45}, {1.1, 0.8}},
        looks({0, 0, 0.2}, 6, 0.5, 0.3), 0, 20, 500, [](const Settings& s) {
            return hung_sheet(squares_of(s), s["stiffness"]);
        });
}

inline Demo net_demo()
{
    Demo scene = cloth_demo<ClothState>(
        "net", "A net of threads that do not stretch", {{0, -0.45}, {1.1, 0.8}}, 2,
        10, [](const Settings& settings) {
            ClothSetup<ClothState> setup;
            setup.cloth = hung_net(squares_of(settings));
            setup.camera = looks({0, 0, 0.2}, 6, 0.5, 0.3);
            setup.measure = cloth_measures<ClothState>;
            return setup;
        });
    scene.tunables.push_back(squares_tunable(12, 40));
    scene.columns = cloth_columns;
    scene.methods = {"exact", "threads", "xpbd", "pbd", "augmented"};
    return scene;
}

inline Demo flag_demo()
{
    Demo scene = sheet_demo<ClothState>(
        "flag", "A flag in the wind", {{0.5, -0.35}, {1, 0.75}},
        looks({0, 0, 0}, 6, 0.35, 0.15), 0, 24, 1000,
        [](const Settings& s) {
            return flag(squares_of(s), s["stiffness"], s["wind"]);
        },
        [](ClothState& state, const Settings& s) {
            state.cloth.wind = s["wind"] * Vec3(0.96, 0, 0.28);
        });
    scene.tunables.push_back(
        {"wind", "m/s", "along the flag, a little across it", 6, 0, 20});
    return scene;
}

inline Demo curtain_demo()
{
    return sheet_demo<ClothState>(
        "curtain", "A curtain is drawn", {{-0.1, -0.7}, {1, 0.9}},
        looks({0, 0, 0}, 6, 0.3, 0.2), 0, 24, 1000,
        [](const Settings& s) { return curtain(squares_of(s), s["stiffness"]); },
        [](ClothState& state, const Settings& s) {
            // pins gather to the left and come back, in eight seconds
            const Real speed = state.t < 0.5 || std::fmod(state.t, 8) > 7
                                   ? 0
                                   : 0.7 * sin(2 * pi * state.t / 8);
            for (int i = 0; i <= squares_of(s); i += 2)
                if (!(state.cloth.bodies.inverse_mass[3 * i] > 0))
                    state.cloth.bodies.velocity(i)
                        << -speed * 0.5 * i / squares_of(s),
                        0, 0;
        });
}

inline Demo banner_demo()
{
    return sheet_demo<ClothState>(
        "banner", "A crane swings a banner", {{0, -0.8}, {1.5, 1.1}},
        looks({0, 0, 0}, 7, 0.4, 0.1), 0, 20, 2000,
        [](const Settings& s) { return banner(squares_of(s), s["stiffness"]); },
        [](ClothState& state, const Settings& s) {
            for (const int i : {0, squares_of(s)})
                if (!(state.cloth.bodies.inverse_mass[3 * i] > 0))
                    state.cloth.bodies.velocity(i) << 1.2 * cos(1.5 * state.t), 0,
                        0;
        });
}

inline Demo tear_demo()
{
    Demo scene = sheet_demo<ClothState>(
        "tear", "A sheet is pulled apart, or by your hand",
        {{0.1, -0.5}, {1, 0.75}}, looks({0, 0, 0}, 6, 0.2, 0.1), 0, 24, 1000,
        [](const Settings& s) {
            return torn_sheet(squares_of(s), s["stiffness"], s["speed"]);
        });
    scene.tunables.push_back(
        {"strength", "%", "stretch that tears a thread; 0: none does", 15, 0, 200});
    scene.tunables.push_back({"speed", "m/s", "of the right edge", 0.2, 0, 2,
                              Numbers::real, OnChange::restarts});
    return scene;
}

}  // namespace rigid
