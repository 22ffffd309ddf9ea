/// \file scenes.hpp
/// Sheets that fall, catch and fold, and a rope over a drum.
#pragma once

#include "chapters/28_cloth_that_touches/program/touching_run.hpp"

namespace rigid {

inline Demo tablecloth_demo()
{
    Demo scene = touching_demo(
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
    Demo scene = touching_demo(
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

inline Demo goal_demo()
{
    Demo scene = touching_demo(
        "goal", "A ball flies into the net of a goal", {{0, 1}, {1.9, 1.35}},
        looks({0, 0.9, 0}, 9, 0.6, 0.2), 0, 30, 20000,
        [](const Settings& s) {
            return net_in_goal(squares_of(s), s["stiffness"], s["mass"],
                               s["speed"]);
        },
        {},
        [](const TouchingState& s) {
            std::vector<Real> all = touching_measures(s);
            all.push_back(s.cloth.solids.u.head<3>().norm());
            return all;
        });
    scene.tunables.push_back({"mass", "kg", "of the ball", 0.43, 0.05, 10,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"speed", "m/s", "of the ball", 20, 0, 40,
                              Numbers::real, OnChange::restarts});
    scene.columns.push_back({"speed", "m/s", "of the ball", Plot::linear});
    for (Tunable& t : scene.tunables)  // fewer let the ball through
        t.value = t.name == "substeps" ? 40 : t.name == "sweeps" ? 4 : t.value;
    scene.methods = {"threads", "xpbd", "pbd"};
    return scene;
}

inline Demo bridge_demo()
{
    Demo scene = touching_demo(
        "bridge", "A box falls on a rope bridge", {{0, -0.1}, {2.3, 1.1}},
        looks({0, -0.3, 0}, 9, 0.35, 0.2), 0, 40, 20000, [](const Settings& s) {
            return rope_bridge(squares_of(s), s["stiffness"], s["mass"]);
        });
    scene.tunables.push_back({"mass", "kg", "of the box", 5, 0.1, 100,
                              Numbers::real, OnChange::restarts});
    scene.methods = {"threads", "xpbd", "pbd"};
    return scene;
}

inline Demo ball_demo()
{
    Demo scene = touching_demo(
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
    Demo scene = touching_demo(
        "fold", "A sheet falls on its edge and folds on itself",
        {{0, 0.35}, {1.1, 0.75}}, looks({0, 0, 0}, 6, 0.6, 0.25), 1, 14, 500,
        [](const Settings& s) {
            return folding_sheet(squares_of(s), s["stiffness"],
                                 s["thickness"] / 1000, s["mu"]);
        },
        {},
        [](const TouchingState& s) {
            std::vector<Real> all = touching_measures(s);
            all.push_back(static_cast<Real>(s.memory.self.stopped));
            return all;
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
    Demo scene = touching_demo(
        "hills", "A cloth falls on a ground of triangles", {{0, 0}, {1.3, 0.9}},
        looks({0, 0, 0}, 6, 0.5, 0.5), 0, 40, 1000, [](const Settings& s) {
            return sheet_on_mesh(squares_of(s), 1.6, s["stiffness"], s["mu"]);
        });
    scene.tunables.push_back(
        {"mu", "", "friction", 0.4, 0, 2, Numbers::real, OnChange::restarts});
    return scene;
}

inline Demo pole_demo()
{
    Demo scene = touching_demo(
        "pole", "A flag on a pole that is a body, held by three ropes",
        {{0.3, 0.55}, {1.3, 0.95}}, looks({0, 0, 0}, 7, 0.4, 0.2), 1, 18, 1000,
        [](const Settings& s) {
            return flag_on_pole(squares_of(s), s["stiffness"], s["mass"],
                                s["wind"]);
        },
        [](TouchingState& state, const Settings& s) {
            state.cloth.wind = s["wind"] * Vec3(0.96, 0, 0.28);
        },
        [](const TouchingState& s) {
            std::vector<Real> all = touching_measures(s);
            const Vec3 up = rotation_of(s.cloth.solids.x, 0).col(1);
            all.push_back(atan2(Vec2(up.x(), up.z()).norm(), up.y()) * 180 / pi);
            return all;
        });
    scene.tunables.push_back({"mass", "kg", "of the pole", 1, 0.05, 20,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back(
        {"wind", "m/s", "along the flag, a little across it", 8, 0, 30});
    for (Tunable& t : scene.tunables)
        if (t.name == "sweeps") t.value = 4;  // with one, ties pull threads apart
    scene.columns.push_back({"leans", "°", "of the pole", Plot::linear});
    scene.methods = {"threads", "xpbd",
                     "pbd"};  // ties are rows of these, and pull back
    return scene;
}

inline Demo drum_demo()
{
    Demo scene = cloth_demo<TouchingState>(
        "drum", "A rope is drawn over a drum: T2/T1 is e^(mu pi)",
        {{0, 0.05}, {1, 0.75}}, 10, 10, [](const Settings& settings) {
            ClothSetup<TouchingState> setup;
            setup.cloth = rope_on_drum(static_cast<int>(settings["segments"]), 2e4,
                                       settings["mu"], 10);
            setup.camera = looks({0, 0, 0}, 8, 0.2, 0.1);
            setup.measure = [](const TouchingState& s) -> std::vector<Real> {
                return {tension(s.cloth, s.cloth.springs.size() - 1) / 10,
                        exp(s.cloth.shapes[0].friction * pi),
                        100 * largest_stretch(s.cloth)};
            };
            return setup;
        });
    scene.tunables.push_back({"segments", "", "of the rope on the drum", 60, 4, 400,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back(
        {"mu", "", "friction", 0.3, 0, 1, Numbers::real, OnChange::restarts});
    scene.columns = {
        {"ratio", "", "of both pulls", Plot::linear},
        {"ratio_exact", "", "e to the power of mu times pi", Plot::linear, "ratio"},
        {"stretch", "%", "of the spring that is stretched most", Plot::linear}};
    return scene;
}

}  // namespace rigid
