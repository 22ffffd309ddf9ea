/// \file scene_machines.hpp
/// A crane, an engine, a leg that walks, a cradle.
#pragma once

#include "chapters/14_joints/bar_linkages.hpp"
#include "chapters/15_trees/program/scene_loads.hpp"
#include "common/elementary.hpp"

namespace rigid {

inline Demo crane_demo()
{
    Demo scene = tree_demo(
        "crane", "A trolley drives, and its rope holds a thousand times a link",
        {{0, -2.2}, {4, 2.8}}, 1.0 / 60, [](const Settings& settings) {
            JointSetup setup;
            setup.scene = crane_scene(static_cast<int>(settings["links"]),
                                      settings["ratio"], settings["speed"]);
            setup.measure = load_measures;
            setup.change = [](JointedScene& moved, const Settings& now) {
                set_motor(moved, 0, now["speed"]);
            };
            return setup;
        });
    scene.tunables.push_back({"links", "", "of the rope", 30, 1, 200,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"ratio", "", "mass of the load over that of a link",
                              1000, 1, 1e5, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"speed", "m/s", "of the trolley", 0.5, -2, 2,
                              Numbers::real, OnChange::goes_on, Keys::up_and_down});
    scene.columns = load_columns();
    return scene;
}

inline Demo engine_demo()
{
    Demo scene = tree_demo(
        "engine", "A crank, a rod and a piston beside the closed form",
        {{0.35, 0}, {0.7, 0.45}}, 1.0 / 240, [](const Settings& settings) {
            JointSetup setup;
            setup.scene = engine_scene(settings["speed"], settings["torque"]);
            setup.change = [](JointedScene& moved, const Settings& now) {
                set_motor(moved, 0, now["speed"]);
            };
            setup.measure = [](const JointState& s) -> std::vector<Real> {
                const VecX& x = s.scene.bodies.x;
                const Real truth = piston_by_hand(x[2]);
                return {x[6], truth, std::abs(x[6] - truth), s.scene.bodies.u[2]};
            };
            return setup;
        });
    scene.tunables.push_back({"speed", "rad/s", "of the crank", 10, -30, 30,
                              Numbers::real, OnChange::goes_on, Keys::up_and_down});
    scene.tunables.push_back({"torque", "N m", "of its motor, at most", 1e4, 1, 1e5,
                              Numbers::real, OnChange::restarts});
    scene.columns = {
        {"piston", "m", "its place", Plot::linear},
        {"exact", "m", "closed form at the crank's angle", Plot::linear, "piston"},
        {"error", "m", "their difference", Plot::logarithmic},
        {"omega", "rad/s", "of the crank", Plot::linear}};
    return scene;
}

inline Demo leg_demo()
{
    Demo scene = tree_demo(
        "leg", "Jansen's leg: a crank turns, and a foot walks",
        {{-0.35, -0.25}, {0.9, 0.75}}, 1.0 / 240, [](const Settings& settings) {
            JointSetup setup;
            const Index crank =
                add_jansen_leg(setup.scene, 0.4, {settings["speed"], 1e3, 0, 0, 0});
            setup.traced = crank + 6;
            setup.traced_point =
                local_point(setup.scene, crank + 6, JansenLeg(0.4).p[5]);
            setup.measure = [crank](const JointState& s) -> std::vector<Real> {
                return {s.scene.bodies.u[3 * crank + 2], largest_gap(s.scene),
                        s.residual()};
            };
            return setup;
        });
    scene.tunables.push_back({"speed", "rad/s", "of the crank", 6, -20, 20,
                              Numbers::real, OnChange::restarts});
    scene.columns = {{"omega", "rad/s", "of the crank", Plot::linear},
                     {"gap", "m", "largest error of a joint", Plot::logarithmic},
                     {"residual", "m/s", "what the solver left"}};
    return scene;
}

/// Balls on rods without mass: each is one body with a pin above it.
inline Demo cradle_demo()
{
    Demo scene = tree_demo(
        "cradle", "Newton's cradle on rods", {{0, -1.1}, {2.4, 1.6}}, 1.0 / 240,
        [](const Settings& settings) {
            JointSetup setup;
            setup.touches = true;
            const int balls = static_cast<int>(settings["balls"]);
            for (int i = 0; i < balls; ++i) {
                const Real x = 0.4 * i - 0.2 * (balls - 1),
                           swing = i == 0 ? -0.8 : 0;
                RigidJoint string;
                string.at_a = {x, 0};
                string.at_b = {0, 1.5};
                string.b =
                    add_body(setup.scene, disc(0.2), Mass{1, {0, 0}, 0.02},
                             {x + 1.5 * sin(swing), -1.5 * cos(swing)}, swing);
                add_joint(setup.scene, string);
            }
            setup.picture = [](Canvas& canvas, const JointState& s) {
                for (const PlacedJoint& placed : s.scene.placed)
                    canvas.segment(
                        placed.joint.at_a,
                        s.scene.bodies.position(placed.joint.b).head<2>(),
                        {Colour::faint, 1.5, 1});
            };
            setup.measure = [balls](const JointState& s) -> std::vector<Real> {
                return {s.scene.bodies.u[2], s.scene.bodies.u[3 * balls - 1],
                        energy(s.scene) - s.energy_at_start};
            };
            return setup;
        });
    scene.tunables.push_back(
        {"balls", "", "how many", 5, 2, 9, Numbers::whole, OnChange::restarts});
    scene.tunables.push_back(
        {"restitution", "", "e", 1, 0, 1, Numbers::real, OnChange::restarts});
    scene.columns = {{"first", "rad/s", "swing of the first ball", Plot::linear},
                     {"last", "rad/s", "of the last", Plot::linear},
                     {"energy", "J", "gained since the start", Plot::linear}};
    return scene;
}

}  // namespace rigid
