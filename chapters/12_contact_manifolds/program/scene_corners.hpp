/// \file scene_corners.hpp
/// Blocks that rock, a polygon that rolls, and a bullet.
#pragma once

#include "chapters/12_contact_manifolds/program/manifold_run.hpp"

namespace rigid {

inline Demo rocking_scene()
{
    Demo scene = manifold_demo(
        "rocking",
        "A block rocks from corner to corner and loses at each impact "
        "what Housner says",
        {{0, 1}, {1.9, 1.3}}, [](const Settings& settings) {
            const Real w = settings["width"] / 2, h = 1;
            ManifoldSetup setup;
            setup.scene = block_on_floor(w, h, settings["tilt"] * pi / 180, true);
            setup.impulse_scale = 0.05;
            setup.traced = 0;
            setup.measure = [w, h](const ManifoldState& s) -> std::vector<Real> {
                return {s.scene.bodies.x[2] * 180 / pi, s.scene.bodies.u[2],
                        housner_ratio(w, h), energy(s.scene)};
            };
            return setup;
        });
    scene.h = 1.0 / 480;
    scene.methods = {"exact", "sweeps", "one_point", "no_names"};
    scene.tunables.push_back({"width", "m", "of a block of 2 m", 1, 0.2, 2,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"tilt", "°", "at the start", 12, 1, 45, Numbers::real,
                              OnChange::restarts});
    scene.columns = {{"angle", "°", "of the block", Plot::linear},
                     {"omega", "rad/s", "counterclockwise", Plot::linear},
                     {"ratio", "", "of ω by hand at each impact"},
                     {"energy", "J", "kinetic and potential", Plot::linear}};
    return scene;
}

inline Demo rolling_scene()
{
    Demo scene = manifold_demo(
        "rolling", "A polygon rolls over its corners; each contact keeps its name",
        {{0, 0.9}, {1.9, 1.3}}, [](const Settings& settings) {
            ManifoldSetup setup;
            setup.scene = roller(static_cast<int>(settings["corners"]), 1);
            setup.change = [](RigidScene& moved, const Settings& now) {
                moved.joints.back().speed = now["speed"];
            };
            setup.impulse_scale = 3;
            setup.names = true;
            setup.measure = [](const ManifoldState& s) -> std::vector<Real> {
                return {s.scene.bodies.x[2],
                        static_cast<Real>(s.now.contacts.size()), s.kept};
            };
            return setup;
        });
    scene.tunables.push_back({"corners", "", "of the polygon", 8, 3, 40,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"speed", "rad/s", "of the motor", 1, -5, 5,
                              Numbers::real, OnChange::goes_on, Keys::up_and_down});
    scene.columns = {
        {"angle", "rad", "of the polygon", Plot::linear},
        {"contacts", "", "points", Plot::linear},
        {"kept", "", "share of the impulses that found their rows", Plot::linear}};
    return scene;
}

inline Demo bullet_scene()
{
    Demo scene = manifold_demo(
        "bullet", "A bullet at 300 m/s and a wall of 1 cm: 5 m in a step",
        {{-0.2, 0}, {3.2, 2.2}}, [](const Settings& settings) {
            ManifoldSetup setup;
            const bool round = settings["length"] == 0;
            setup.scene =
                bullet(round ? disc(0.005) : capsule(settings["length"], 0.001),
                       settings["angle"] * pi / 180, settings["spin"]);
            setup.traced = 1;
            setup.measure = [](const ManifoldState& s) -> std::vector<Real> {
                return {s.scene.bodies.x[3], s.scene.bodies.x[4],
                        s.scene.bodies.u[3]};
            };
            return setup;
        });
    scene.tunables.push_back({"angle", "°", "to the normal of the wall", 0, -60, 60,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"length", "m", "of the bullet, 0 for a ball", 0, 0,
                              0.2, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"spin", "rad/s", "of the bullet", 0, -1000, 1000,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"stop", "", "1: fast bodies are stopped at impacts",
                              1, 0, 1, Numbers::whole});
    scene.columns = {{"x", "m", "of the bullet; the wall is at 0", Plot::linear},
                     {"y", "m", "of the bullet", Plot::linear},
                     {"speed", "m/s", "along x", Plot::linear}};
    return scene;
}

}  // namespace rigid
