/// \file line_scenes.hpp
/// Masses under each other, a strip.
#pragma once

#include "chapters/27_particles_and_cloth/program/cloth_run.hpp"

namespace rigid {

inline Tunable stiffness_tunable(Real k)
{
    return {"stiffness", "N/m", "of a thread's spring", k,
            1,           1e6,   Numbers::real,          OnChange::restarts};
}

inline Camera looks(const Vec3& target, Real distance, Real azimuth, Real height)
{
    Camera camera;
    camera.target = target, camera.distance = distance;
    camera.azimuth = azimuth, camera.height = height;
    return camera;
}

/// The example by hand.
inline Demo chain_demo()
{
    Demo scene = cloth_demo<ClothState>(
        "masses", "Masses under each other on springs, by hand",
        {{0, -1.6}, {1.6, 1.9}}, 1, 1, [](const Settings& settings) {
            ClothSetup<ClothState> setup;
            setup.cloth = hung_masses(static_cast<int>(settings["masses"]),
                                      settings["stiffness"]);
            setup.camera = looks({0, 0, 0}, 20, 0, 0);
            setup.measure = [](const ClothState& s) -> std::vector<Real> {
                return {-s.cloth.bodies.position(1).y() - 1,
                        largest_stretch(s.cloth) * 100, energy(s.cloth) - s.energy};
            };
            return setup;
        });
    scene.h = 0.1;
    scene.tunables.push_back(
        {"masses", "", "of 1 kg", 2, 1, 50, Numbers::whole, OnChange::restarts});
    scene.tunables.push_back(stiffness_tunable(100));
    scene.columns = {
        {"first", "m", "how far the first mass has come down", Plot::linear},
        {"stretch", "%", "of the spring that is stretched most", Plot::linear},
        {"energy", "J", "less that of the start", Plot::linear}};
    scene.side_by_side = {"xpbd", "newton", "explicit"};
    return scene;
}

inline Demo strip_demo()
{
    Demo scene = cloth_demo<ClothState>(
        "strip", "A strip that is clamped at one end bends under its weight",
        {{0.55, -0.35}, {0.85, 0.6}}, 1, 10, [](const Settings& settings) {
            ClothSetup<ClothState> setup;
            const int n = static_cast<int>(settings["segments"]);
            const auto how =
                settings["angle"] > 0 ? Bending::angle : Bending::quadratic;
            setup.cloth = clamped_strip(n, 2, how, settings["alternate"] > 0);
            setup.cloth.gravity = {0, -settings["load"], 0};
            setup.cloth.drag = 5;
            setup.camera = looks({0, 0, 0}, 8, 0.1, 0.15);
            setup.mesh = true;
            setup.measure = [n](const ClothState& s) -> std::vector<Real> {
                const Vec3 tip = s.cloth.bodies.position(n + 1);
                return {tip.x(), -tip.y(), s.memory.newton.residual};
            };
            return setup;
        });
    scene.methods = {"newton", "implicit",  "exact",
                     "xpbd",   "particles", "midpoint"};
    scene.tunables.push_back({"segments", "", "of the strip", 20, 4, 100,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"load", "", "q L³/EI, weight over bending stiffness",
                              5, 0, 50, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"angle", "", "bends by angle", 0, 0, 1,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"alternate", "", "diagonals alternate", 1, 0, 1,
                              Numbers::whole, OnChange::restarts});
    scene.columns = {{"tip_x", "m", "of the free end", Plot::linear},
                     {"tip_down", "m", "of the free end", Plot::linear},
                     {"residual", "m", "of Newton's method", Plot::logarithmic}};
    return scene;
}

}  // namespace rigid
