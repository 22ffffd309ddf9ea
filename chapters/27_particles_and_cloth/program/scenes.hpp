/// \file scenes.hpp
/// Sheets that hang, fall, catch and tear.
#pragma once

#include "chapters/27_particles_and_cloth/program/line_scenes.hpp"

namespace rigid {

inline Tunable squares_tunable(Real squares, Real most)
{
    return {"squares", "",   "of a side",    squares,
            2,         most, Numbers::whole, OnChange::restarts};
}

/// A scene of a sheet: how it is made, seen, and what changes while it runs.
inline Demo
sheet_demo(const std::string& name, const std::string& summary, const View& view,
           const Camera& camera, Real ground, Real squares, Real k,
           std::function<ClothScene(const Settings&)> make,
           std::function<void(ClothState&, const Settings&)> change = {})
{
    Demo scene = cloth_demo(
        name, summary, view, 8, 1,
        [=, make = std::move(make)](const Settings& settings) {
            ClothSetup setup;
            setup.cloth = make(settings);
            setup.camera = camera;
            setup.ground = ground;
            setup.measure = cloth_measures;
            if (name == "fold")
                setup.measure = [](const ClothState& state) {
                    auto all = cloth_measures(state);
                    all.push_back(static_cast<Real>(state.memory.self.stopped));
                    return all;
                };
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
    return sheet_demo("sheet", "A sheet on two corners", {{0, -0.45}, {1.1, 0.8}},
                      looks({0, 0, 0.2}, 6, 0.5, 0.3), 0, 20, 500,
                      [](const Settings& s) {
                          return hung_sheet(squares_of(s), s["stiffness"]);
                      });
}

inline Demo flag_demo()
{
    Demo scene = sheet_demo(
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
    return sheet_demo(
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

inline Demo tablecloth_demo()
{
    Demo scene = sheet_demo(
        "tablecloth", "A cloth falls on a table", {{0, 0.45}, {1.2, 0.8}},
        looks({0, 0, 0}, 6, 0.6, 0.45), 1.4, 32, 1000, [](const Settings& s) {
            return tablecloth(squares_of(s), s["stiffness"], s["mu"]);
        });
    scene.tunables.push_back(
        {"mu", "", "friction", 0.5, 0, 2, Numbers::real, OnChange::restarts});
    return scene;
}

inline Demo trampoline_demo()
{
    Demo scene = sheet_demo(
        "trampoline", "A sheet catches what falls on it", {{0, 0.1}, {1.5, 1}},
        looks({0, 0, 0}, 7, 0.5, 0.35), 0, 24, 500, [](const Settings& s) {
            return catching_sheet(squares_of(s), s["stiffness"], s["mass"],
                                  s["box"] > 0, s["pinned"] > 0);
        });
    scene.tunables.push_back({"mass", "kg", "of what falls", 1, 0.01, 100,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"box", "", "a box in place of a ball", 0, 0, 1,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back(
        {"pinned", "", "all around", 1, 0, 1, Numbers::whole, OnChange::restarts});
    scene.methods = {"threads", "xpbd",
                     "pbd"};  // contacts that push back are rows of these
    return scene;
}

inline Demo bridge_demo()
{
    Demo scene = sheet_demo(
        "bridge", "A box falls on a rope bridge", {{0, -0.1}, {2.3, 1.1}},
        looks({0, -0.3, 0}, 9, 0.35, 0.2), 0, 40, 20000, [](const Settings& s) {
            return rope_bridge(squares_of(s), s["stiffness"], s["mass"]);
        });
    scene.tunables.push_back({"mass", "kg", "of the box", 5, 0.1, 100,
                              Numbers::real, OnChange::restarts});
    scene.methods = {"threads", "xpbd", "pbd"};
    return scene;
}

inline Demo banner_demo()
{
    return sheet_demo(
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

inline Demo ball_demo()
{
    Demo scene = sheet_demo(
        "ball", "A cloth falls on a ball that turns", {{0, -0.1}, {1.3, 0.95}},
        looks({0, 0, 0}, 7, 0.5, 0.4), 0, 40, 1000, [](const Settings& s) {
            return sheet_on_ball(squares_of(s), 1.6, s["stiffness"], s["mu"],
                                 s["spin"]);
        });
    scene.tunables.push_back(
        {"mu", "", "friction", 0.3, 0, 2, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"spin", "rad/s", "of the ball", 3, -20, 20,
                              Numbers::real, OnChange::restarts});
    return scene;
}

inline Demo fold_demo()
{
    Demo scene =
        sheet_demo("fold", "A sheet falls on its edge and folds on itself",
                   {{0, 0.35}, {1.1, 0.75}}, looks({0, 0, 0}, 6, 0.6, 0.25), 1, 14,
                   500, [](const Settings& s) {
                       return folding_sheet(squares_of(s), s["stiffness"],
                                            s["thickness"] / 1000, s["mu"]);
                   });
    scene.tunables.push_back({"thickness", "mm", "against itself; 0: it passes", 12,
                              0, 30, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"mu", "", "friction on itself", 0.2, 0, 2,
                              Numbers::real, OnChange::restarts});
    scene.columns.push_back(
        {"stopped", "", "particles that stopped before they met", Plot::linear});
    return scene;
}

inline Demo hills_demo()
{
    Demo scene = sheet_demo(
        "hills", "A cloth falls on a ground of triangles", {{0, 0}, {1.3, 0.9}},
        looks({0, 0, 0}, 6, 0.5, 0.5), 0, 40, 1000, [](const Settings& s) {
            return sheet_on_mesh(squares_of(s), 1.6, s["stiffness"], s["mu"]);
        });
    scene.tunables.push_back(
        {"mu", "", "friction", 0.4, 0, 2, Numbers::real, OnChange::restarts});
    return scene;
}

inline Demo tear_demo()
{
    Demo scene =
        sheet_demo("tear", "A sheet is pulled apart, or by your hand",
                   {{0.1, -0.5}, {1, 0.75}}, looks({0, 0, 0}, 6, 0.2, 0.1), 0, 24,
                   1000, [](const Settings& s) {
                       return torn_sheet(squares_of(s), s["stiffness"], s["speed"]);
                   });
    scene.tunables.push_back(
        {"strength", "%", "stretch that tears a thread; 0: none does", 15, 0, 200});
    scene.tunables.push_back({"speed", "m/s", "of the right edge", 0.2, 0, 2,
                              Numbers::real, OnChange::restarts});
    return scene;
}

}  // namespace rigid
