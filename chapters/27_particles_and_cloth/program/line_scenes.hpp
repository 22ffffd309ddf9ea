/// \file line_scenes.hpp
/// Masses under each other, a strip.
#pragma once

#include "chapters/27_particles_and_cloth/program/cloth_run.hpp"
#include "chapters/27_particles_and_cloth/program/strips.hpp"

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
        "strip", "A strip that is clamped at one end, and the elastica",
        {{0.55, -0.35}, {0.85, 0.6}}, 1, 10, [](const Settings& settings) {
            ClothSetup<ClothState> setup;
            const int n = static_cast<int>(settings["segments"]),
                      model = static_cast<int>(settings["model"]);
            const Real load = settings["load"];
            const bool at_the_end = settings["end"] > 0;
            setup.cloth = strip_under({model, n, settings["alternate"] > 0,
                                       settings["diagonals"], settings["across"]},
                                      load, at_the_end);
            setup.cloth.drag = 5;
            setup.camera = looks({0, 0, 0}, 8, 0.1, 0.15);
            setup.mesh = true;
            const Elastica exact = elastica(load, at_the_end);
            const Real l = Real(1) / n;
            for (const Vec2& p : exact.points)  // in the middle of the strip
                setup.curve.emplace_back(p.x(), -p.y(), model == 3 ? 0 : l);
            const Vec2 end = exact.tip();
            const int tip = tip_of({model, n});
            setup.measure = [tip, end](const ClothState& s) -> std::vector<Real> {
                const Vec3 p = s.cloth.bodies.position(tip);
                return {p.x(), -p.y(), (Vec2(p.x(), -p.y()) - end).norm(),
                        s.memory.newton.residual};
            };
            return setup;
        });
    scene.methods = {"newton", "implicit",  "exact",
                     "xpbd",   "particles", "midpoint"};
    const auto add = [&scene](const char* name, const char* unit, const char* what,
                              Real value, Real lo, Real hi, Numbers kind) {
        scene.tunables.push_back(
            {name, unit, what, value, lo, hi, kind, OnChange::restarts});
    };
    add("segments", "", "of the strip", 20, 4, 100, Numbers::whole);
    add("load", "", "q L³/EI, weight over bending stiffness", 5, 0.01, 50,
        Numbers::real);
    add("end", "", "a load P L²/EI at its end in place of its weight", 0, 0, 1,
        Numbers::whole);
    add("model", "", "of bending: 0 lines, 1 angles, 2 edges, 3 springs across", 0,
        0, 3, Numbers::whole);
    add("alternate", "", "diagonals alternate", 1, 0, 1, Numbers::whole);
    add("diagonals", "", "stiffness of hinges about diagonals, in those of others",
        1, 1, 1e4, Numbers::real);
    add("across", "N/m", "springs to the second neighbour", 3e5, 1, 1e8,
        Numbers::real);
    scene.columns = {
        {"tip_x", "m", "of the free end", Plot::linear},
        {"tip_down", "m", "of the free end", Plot::linear},
        {"off", "m", "from the end of the elastica", Plot::logarithmic},
        {"residual", "m", "of Newton's method", Plot::logarithmic}};
    return scene;
}

}  // namespace rigid
