/// \file scenes.hpp
/// One spring, a stack with a heavy top, a wheel on a spring, a body and a cloth of springs, a bridge.
#pragma once

#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/16_soft_constraints/program/soft_run.hpp"
#include "common/elementary.hpp"

namespace rigid {

inline Tunable number(const char* name, const char* unit, const char* help,
                      Real value, Real low, Real high,
                      Numbers numbers = Numbers::real)
{
    return {name, unit, help, value, low, high, numbers, OnChange::restarts};
}

/// A mass on a spring beside the motion of the differential equation.
inline Demo spring_scene()
{
    Demo scene = soft_demo(
        "spring", "A mass on a spring, at any stiffness", {{0, -1}, {1.6, 1.6}},
        1.0 / 60, [](const Settings& settings) {
            const Softness how{settings["spring"], settings["damping"]};
            SoftSetup setup;
            setup.scene = hanging_masses({1}, spring_of(how, 1));
            setup.scene.gravity = {0, 0};
            setup.scene.bodies.x[1] = -1.5;
            setup.measure = [how](const SoftState& s) -> std::vector<Real> {
                const Real x = -1 - s.scene.bodies.x[1],
                           omega = 2 * pi * how.frequency, z = how.damping_ratio,
                           w = omega * std::sqrt(std::abs(1 - z * z));
                Real truth = 0;
                if (z < 1)
                    truth = 0.5 * exp(-z * omega * s.t) *
                            (cos(w * s.t) + z * omega / w * sin(w * s.t));
                return {x, truth, energy(s.scene) + s.spring_energy()};
            };
            return setup;
        });
    scene.tunables.push_back(
        number("spring", "Hz", "frequency of the spring", 2, 0.01, 1e6));
    scene.tunables.push_back(
        number("damping", "", "its damping ratio", 0, 0, 0.99));
    scene.columns = {
        {"x", "m", "out of its rest", Plot::linear},
        {"exact", "m", "of the differential equation", Plot::linear, "x"},
        {"energy", "J", "kinetic and of the spring", Plot::linear}};
    return scene;
}

/// Boxes, and a heavy one on top.
inline Demo stack_scene()
{
    Demo scene = soft_demo(
        "stack", "A heavy box on a stack: who holds it?", {{0, 3}, {4, 3.6}},
        1.0 / 60, [](const Settings& settings) {
            const int boxes = static_cast<int>(settings["boxes"]);
            SoftSetup setup;
            setup.scene = heavy_top(boxes, settings["ratio"]);
            const Real start = setup.scene.bodies.x[3 * boxes + 1];
            setup.measure = [start,
                             boxes](const SoftState& s) -> std::vector<Real> {
                return {s.overlap(), start - s.scene.bodies.x[3 * boxes + 1],
                        energy(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back(
        number("boxes", "", "below it", 5, 1, 40, Numbers::whole));
    scene.tunables.push_back(
        number("ratio", "", "mass of the top over that of a box", 10, 0.01, 1e5));
    scene.columns = {
        {"overlap", "m", "the deepest", Plot::logarithmic},
        {"sunk", "m", "how far the top is below its start", Plot::linear},
        {"energy", "J", "kinetic and potential", Plot::linear}};
    return scene;
}

/// A body on a wheel that rolls over nothing: the floor is pulled away under it and comes back.
inline Demo suspension_scene()
{
    Demo scene = soft_demo(
        "suspension", "A quarter of a car falls on its wheel", {{0, 0.9}, {2, 1.3}},
        1.0 / 60, [](const Settings& settings) {
            SoftSetup setup;
            setup.scene = quarter_car({settings["spring"], settings["damping"]}, 0);
            for (const Index k : {0, 1}) setup.scene.bodies.x[3 * k + 1] += 0.4;
            setup.measure = [](const SoftState& s) -> std::vector<Real> {
                return {s.scene.bodies.x[1],
                        coordinate(s.scene.bodies.x, s.scene.placed[0].joint),
                        s.overlap()};
            };
            return setup;
        });
    scene.tunables.push_back(
        number("spring", "Hz", "frequency of the spring", 5, 0.5, 50));
    scene.tunables.push_back(number("damping", "", "its damping ratio", 0.1, 0, 5));
    scene.columns = {{"body", "m", "height of the body", Plot::linear},
                     {"spring", "m", "length of the spring", Plot::linear},
                     {"overlap", "m", "of wheel and floor"}};
    return scene;
}

inline std::vector<Column> net_columns()
{
    return {{"energy", "J", "kinetic, potential, of springs", Plot::linear},
            {"stored", "J", "of springs", Plot::linear},
            {"overlap", "m", "the deepest"}};
}

inline std::vector<Real> net_measures(const SoftState& s)
{
    return {energy(s.scene) + s.spring_energy(), s.spring_energy(), s.overlap()};
}

inline std::vector<Tunable> net_tunables(Real stiffness)
{
    return {number("stiffness", "N/m", "of each spring", stiffness, 1, 1e9),
            number("damping", "N s/m", "of each spring", 2, 0, 1e4)};
}

inline Demo soft_body_scene()
{
    Demo scene = soft_demo(
        "soft_body", "A body of springs falls on a floor", {{1.4, 1.2}, {2.6, 1.8}},
        1.0 / 120, [](const Settings& settings) {
            Net net;
            net.spring = {settings["stiffness"], settings["damping"]};
            net.corner = {0, 0.8};
            SoftSetup setup;
            setup.scene = soft_body(net);
            setup.measure = net_measures;
            return setup;
        });
    for (const Tunable& tunable : net_tunables(1000))
        scene.tunables.push_back(tunable);
    scene.columns = net_columns();
    return scene;
}

inline Demo cloth_scene()
{
    Demo scene =
        soft_demo("cloth", "A net hangs on two corners", {{1.4, 0.4}, {2.4, 2}},
                  1.0 / 120, [](const Settings& settings) {
                      Net net;
                      net.spring = {settings["stiffness"], settings["damping"]};
                      SoftSetup setup;
                      setup.touches = false;
                      setup.scene = hung_net(net);
                      setup.measure = net_measures;
                      return setup;
                  });
    for (const Tunable& tunable : net_tunables(300))
        scene.tunables.push_back(tunable);
    scene.columns = net_columns();
    return scene;
}

/// Chapter 14's bridge on pins that are springs.
inline Demo soft_bridge_scene()
{
    Demo scene = soft_demo(
        "bridge", "A bridge whose pins are springs bears three boxes",
        {{0, -1}, {4.6, 2}}, 1.0 / 60, [](const Settings& settings) {
            SoftSetup setup;
            setup.scene = bridge_scene(static_cast<int>(settings["planks"]));
            for (int i = 0; i < 3; ++i)
                add_body(setup.scene, box(0.5, 0.5), settings["load"] / 0.25,
                         {-2.0 + 2 * i, i == 1 ? -0.8 : -0.2});
            cover(setup.scene, {0.5, 0, 0, 0});
            setup.measure = [](const SoftState& s) -> std::vector<Real> {
                return {largest_joint_error(s.scene), s.overlap(), energy(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back(
        number("planks", "", "of it", 12, 2, 100, Numbers::whole));
    scene.tunables.push_back(
        number("load", "kg", "of each of three boxes", 20, 1, 5000));
    scene.columns = {{"gap", "m", "largest error of a joint", Plot::logarithmic},
                     {"overlap", "m", "the deepest", Plot::logarithmic},
                     {"energy", "J", "kinetic and potential", Plot::linear}};
    return scene;
}

}  // namespace rigid
