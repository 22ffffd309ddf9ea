/// \file joint_scenes.hpp
/// What hangs and what spins on joints: Newton's cradle, a gyroscope, chains.
#pragma once

#include "chapters/21_joints_in_space/gyroscope.hpp"
#include "chapters/25_world_in_space/program/hung_demo.hpp"
#include "chapters/25_world_in_space/program/touch_scenes.hpp"

namespace rigid {

inline Demo cradle_scene()
{
    Demo scene = space_demo(
        "cradle", "Newton's cradle: what one ball brings, the last takes away",
        {{0, 0}, {1.8, 1.35}}, 1.0 / 960, {"exact_cone", "cone"},
        [](const Settings& settings) {
            SpaceSetup setup;
            Cradle cradle;
            cradle.lifted = static_cast<int>(settings["lifted"]);
            cradle.gap = settings["gap"] / 1000;
            setup.scene = newtons_cradle(cradle);
            setup.restitution = settings["restitution"];
            setup.slop = 0;
            setup.skin = Skin::opaque;
            setup.camera.target = {0, 0.5, 0};
            setup.camera.distance = 5;
            setup.camera.azimuth = 0.35;
            setup.measure = [](const SpaceState& s) -> std::vector<Real> {
                const auto angle = [&s](const SpaceJoint& joint) {
                    return turn_of(twist, frames_of(s.scene.bodies.x, joint).q)
                        .value;
                };
                // hinges read zero where they were made
                const Vec3 first = centre_of(s.scene.bodies.x, 0),
                           hook = s.scene.joints[0].at_a;
                return {atan2(first.x() - hook.x(), hook.y() - first.y()) * 180 /
                            pi,
                        angle(s.scene.joints.back()) * 180 / pi,
                        energy(s.scene) - s.energy, largest_joint_error(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back({"lifted", "", "balls at the start", 1, 1, 4,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"gap", "mm", "between balls at rest", 2, 0, 20,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"restitution", "", "of the balls", 1, 0, 1,
                              Numbers::real, OnChange::restarts});
    add_touch_tunables(scene, 0, 500);
    scene.columns = {
        {"first", "°", "of the first ball's rod from the vertical", Plot::linear},
        {"last", "°", "of the last ball's rod from the vertical", Plot::linear},
        {"energy", "J", "less that of the start", Plot::linear},
        {"joint_error", "m", "largest of a locked coordinate", Plot::logarithmic}};
    return scene;
}

inline Demo gyroscope_scene()
{
    Demo scene = space_demo(
        "gyroscope", "A wheel in a gimbal: a weight on its axis turns it about",
        {{0, 0}, {0.6, 0.45}}, 1.0 / 960, {"exact", "islands"},
        [](const Settings& settings) {
            SpaceSetup setup;
            Gyroscope gyroscope;
            gyroscope.spin = settings["spin"];
            gyroscope.weight = settings["weight"];
            setup.scene = gyroscope_in_gimbal(gyroscope);
            setup.camera.distance = 2;
            setup.camera.azimuth = 1.1;
            setup.skin = Skin::opaque;
            const Real exact = precession_of(gyroscope);
            setup.measure = [exact](const SpaceState& s) -> std::vector<Real> {
                const Vec3 axis = rotation_of(s.scene.bodies.x, 2).col(0);
                return {world_spin(s.scene.bodies, 0).y(), exact,
                        asin(axis.y()) * 180 / pi, energy(s.scene) - s.energy,
                        largest_joint_error(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back({"spin", "rad/s", "of the wheel", 150, 20, 500,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"weight", "kg", "on the axis", 0.2, 0, 2,
                              Numbers::real, OnChange::restarts});
    scene.columns = {
        {"precession", "rad/s", "of the outer ring", Plot::linear},
        {"precession_exact", "rad/s", "M g l over I omega"},
        {"lift", "°", "of the wheel's axis from level", Plot::linear},
        {"energy", "J", "less that of the start", Plot::linear},
        {"joint_error", "m", "largest of a locked coordinate", Plot::logarithmic}};
    return scene;
}

inline Demo plates_scene()
{
    return hung_demo(
        "plates", "Plates on hinges swing in one plane, however they are pushed",
        {{0, 0}, {6.4, 4.8}},
        [](const Settings& settings) {
            SpaceSetup setup;
            setup.scene = plate_chain(static_cast<int>(settings["plates"]),
                                      settings["aside"]);
            setup.camera = {{0, -2.5, 0}, 16};
            setup.skin = Skin::opaque;
            return setup;
        },
        {{"plates", "", "of the chain", 5, 1, 12, Numbers::whole,
          OnChange::restarts},
         {"aside", "m/s", "a push across the plane", 1, 0, 10, Numbers::real,
          OnChange::restarts}});
}

inline Demo heavy_scene()
{
    Demo scene = hung_demo(
        "heavy_end", "A chain of light links with a heavy ball at its end",
        {{0, 0}, {7.2, 5.4}},
        [](const Settings& settings) {
            SpaceSetup setup;
            setup.scene =
                heavy_chain(static_cast<int>(settings["links"]), settings["ratio"]);
            // for what may touch, and nothing does
            setup.scene.friction.assign(setup.scene.shapes.size(), 0.5);
            setup.camera = {{1.5, -4, 0}, 18};
            setup.skin = Skin::opaque;
            return setup;
        },
        {{"links", "", "of the chain", 30, 1, 50, Numbers::whole,
          OnChange::restarts},
         {"ratio", "", "mass of the ball over that of a link", 1000, 1, 10000,
          Numbers::real, OnChange::restarts},
         {"stiff", "", "a load makes a link hard to turn (cones)", 1, 0, 1,
          Numbers::whole},
         {"sweeps", "", "of a step, at most (cone)", 50, 1, 5000, Numbers::whole}});
    scene.methods.insert(scene.methods.begin(), {"exact_cone", "cone"});
    scene.h = 1.0 / 60;
    scene.tunables.back().value = 1;  // sub-steps
    return scene;
}

}  // namespace rigid
