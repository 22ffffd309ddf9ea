/// \file touch_scenes.hpp
/// What slides, stacks and is poured.
#pragma once

#include "chapters/24_friction_is_a_disc/program/space_run.hpp"
#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"

namespace rigid {

inline const std::vector<std::string> ways_to_drag = {"cone", "box", "exact_cone"};

inline void add_touch_tunables(Demo& scene, Real mu, Real sweeps, Real least = 0)
{
    scene.tunables.push_back(
        {"mu", "", "friction", mu, least, 2, Numbers::real, OnChange::restarts});
    scene.tunables.push_back(
        {"sweeps", "", "of a step, at most", sweeps, 1, 5000, Numbers::whole});
}

inline Demo slide_scene()
{
    Demo scene = rough_demo(
        "slide", "A block slides: friction on a disc, on a box, in a pyramid",
        {{0, 0}, {2.2, 1.5}}, 1.0 / 240, {"cone", "box", "pyramid", "exact_cone"},
        [](const Settings& settings) {
            RoughSetup setup;
            const Real speed = settings["speed"], mu = settings["mu"],
                       angle = settings["direction"] * pi / 180, h = settings.h;
            setup.scene = sliding_block(speed, angle, mu);
            setup.camera.target = {0.5, 0, -0.3};
            setup.camera.distance = 8;
            setup.camera.height = 0.6;
            setup.ground = 3;
            setup.traces = true;
            setup.measure = [=](const RoughState& s) -> std::vector<Real> {
                const Vec3 ahead(cos(angle), 0, -sin(angle)),
                    aside(sin(angle), 0, cos(angle));
                const Vec3 way = s.scene.bodies.x.head<3>(),
                           lost = speed * ahead - s.scene.bodies.u.head<3>();
                const Real all = s.t > 0 ? mu * 9.81 * s.t : 1;
                return {s.scene.bodies.u.head<3>().norm(),
                        way.dot(ahead),
                        stopping_distance(speed, mu, h),
                        way.dot(aside),
                        lost.x() / all,
                        lost.z() / all};
            };
            return setup;
        });
    scene.tunables.push_back({"speed", "m/s", "at the start", 3, 0.1, 10,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"direction", "°", "from the first tangent", 45, 0,
                              360, Numbers::real, OnChange::restarts});
    scene.tunables.push_back(
        {"corners", "", "of the pyramid", 6, 3, 32, Numbers::whole});
    add_touch_tunables(scene, 0.4, 200, 0.01);  // without friction it never stops
    scene.columns = {{"speed", "m/s", "of the block", Plot::linear},
                     {"distance", "m", "along its first direction", Plot::linear},
                     {"distance_exact", "m", "(24.5)"},
                     {"aside", "m", "across its first direction", Plot::linear},
                     {"drag_x", "", "mean force over mu m g, against x"},
                     {"drag_z", "", "mean force over mu m g, against z"}};
    return scene;
}

inline Demo stack_scene()
{
    Demo scene = rough_demo(
        "stack", "Boxes on boxes", {{0, 0}, {8, 6}}, 1.0 / 60, ways_to_drag,
        [](const Settings& settings) {
            RoughSetup setup;
            setup.scene = box_stack(static_cast<int>(settings["boxes"]),
                                    settings["turn"] * pi / 180, settings["mu"]);
            setup.scene.bodies.inverse_mass.tail<6>() /= settings["top"];
            setup.camera.target = {0, 5, 0};
            setup.camera.distance = 20;
            setup.ground = 4;
            const VecX start = setup.scene.bodies.x;
            setup.measure = [start](const RoughState& s) -> std::vector<Real> {
                const VecX& x = s.scene.bodies.x;
                Real sideways = 0, sunk = 0;
                for (Index k = 0; k < s.scene.bodies.count(); ++k) {
                    const Vec3 way = x.segment<3>(6 * k) - start.segment<3>(6 * k);
                    sideways = std::max(sideways, Vec2(way.x(), way.z()).norm());
                    sunk = std::max(sunk, -way.y());
                }
                return {energy(s.scene) - s.energy, sideways, sunk,
                        deepest_overlap(s.now),
                        static_cast<Real>(s.now.solution.iterations)};
            };
            return setup;
        });
    scene.tunables.push_back({"boxes", "", "of the stack", 10, 1, 30,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"top", "",
                              "mass of the topmost over that of the others", 1,
                              0.001, 10000, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"turn", "°", "of each box against the one below", 3,
                              0, 45, Numbers::real, OnChange::restarts});
    scene.tunables.push_back(
        {"substeps", "", "of a step, with its contacts", 1, 1, 64, Numbers::whole});
    add_touch_tunables(scene, 0.5, 500);
    scene.columns = {
        {"energy", "J", "less that of the start", Plot::linear},
        {"sideways", "m", "the farthest that a box has moved so",
         Plot::logarithmic},
        {"sunk", "m", "the farthest that a box has moved down", Plot::linear},
        {"overlap", "m", "the deepest", Plot::linear},
        {"sweeps", "", "of the step", Plot::linear}};
    return scene;
}

/// What is poured into a pit, in layers of side².
template <class Scene, class Steps>
Demo poured_demo(const std::string& name, const std::string& summary, int side,
                 Real bodies, Real most)
{
    const Real wider = 0.4 * (side - 3), far = 1 + wider;
    Demo scene = solid_demo<Scene, Steps>(
        name, summary, {{0, -0.1 * far}, {3.6 * far, 2.4 * far}}, 1.0 / 120,
        ways_to_drag, [side, wider, far](const Settings& settings) {
            SolidSetup<Scene> setup;
            setup.scene = mixed_heap(static_cast<int>(settings["bodies"]),
                                     settings["mu"], settings.seed, side);
            setup.camera.target = {0, 0.5 * far, 0};
            setup.camera.distance = 8 * far;
            setup.camera.height = 0.8;
            setup.ground = 1 + wider, setup.pit = 1.2 + wider;
            setup.measure = [](const SolidState<Scene>& s) -> std::vector<Real> {
                return {energy(s.scene) - s.energy,
                        static_cast<Real>(s.now.contacts.size()),
                        deepest_overlap(s.now),
                        static_cast<Real>(s.now.solution.iterations)};
            };
            return setup;
        });
    scene.tunables.push_back({"bodies", "", "that fall", bodies, 1, most,
                              Numbers::whole, OnChange::restarts});
    add_touch_tunables(scene, 0.5, 50);
    scene.columns = {{"energy", "J", "less that of the start", Plot::linear},
                     {"contacts", "", "points where solids touch", Plot::linear},
                     {"overlap", "m", "the deepest", Plot::linear},
                     {"sweeps", "", "of the step", Plot::linear}};
    return scene;
}

inline Demo heap_scene()
{
    return poured_demo<RoughSolids, RoughSteps>(
        "heap", "Balls, capsules, boxes and hulls fall into a pit", 3, 30, 200);
}

}  // namespace rigid
