/// \file scene_vehicles.hpp
/// A car on hills, a trebuchet.
#pragma once

#include "chapters/14_joints/bar_linkages.hpp"
#include "chapters/14_joints/program/joint_run.hpp"
#include "common/elementary.hpp"

namespace rigid {

inline Demo car_demo()
{
    Demo scene = joint_demo(
        "car", "Wheels on springs and a motor, over hills", {{6, 1.2}, {9, 3.5}},
        1.0 / 120, [](const Settings& settings) {
            JointSetup setup;
            JointedScene& all = setup.scene;
            setup.touches = true;
            for (int i = 0; i < 5; ++i)
                add_body(all, box(2.2, 0.4), Mass{}, {2.0 + 3 * i, 0.1},
                         i % 2 == 0 ? 0.22 : -0.22);
            all.walls.push_back({{0, 1}, 0});
            const Index chassis = add_body(all, box(2, 0.5), 300.0, {-1.5, 1});
            for (const Real side : {-0.7, 0.7}) {
                RigidJoint wheel;
                wheel.kind = JointKind::wheel;
                wheel.a = chassis;
                wheel.b = add_body(all, disc(0.35), 60.0, {-1.5 + side, 0.6});
                wheel.at_a = {side, -0.4};
                wheel.axis = {0, 1};
                wheel.lower = -0.2, wheel.upper = 0.25;
                wheel.spring = {0, 0, settings["stiffness"], 900, 0};
                add_joint(all, wheel);
                RigidJoint drive;
                drive.kind = JointKind::friction;  // its torque alone
                drive.a = chassis, drive.b = wheel.b;
                drive.torque = settings["torque"];
                add_joint(all, drive);
            }
            cover(all, {1, 0, 0, 0});
            setup.change = [](JointedScene& moved, const Settings& now) {
                for (const PlacedJoint& placed : moved.placed)
                    if (placed.joint.kind == JointKind::friction) {
                        PointJoint& turn = moved.joints[static_cast<std::size_t>(
                            placed.first + placed.count - 1)];
                        turn.speed = -now["speed"] / 0.35;
                    }
            };
            setup.measure = [chassis](const JointState& s) -> std::vector<Real> {
                const VecX& x = s.scene.bodies.x;
                return {x[3 * chassis], s.scene.bodies.u[3 * chassis],
                        coordinate(x, s.scene.placed[0].joint),
                        coordinate(x, s.scene.placed[2].joint)};
            };
            return setup;
        });
    scene.tunables.push_back({"speed", "m/s", "that the motor wants", 3, -6, 6,
                              Numbers::real, OnChange::goes_on, Keys::up_and_down});
    scene.tunables.push_back({"torque", "N m", "of each axle, at most", 400, 0,
                              2000, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"stiffness", "N/m", "of a spring", 3e4, 1e3, 1e6,
                              Numbers::real, OnChange::restarts});
    scene.columns = {{"x", "m", "of the chassis", Plot::linear},
                     {"v", "m/s", "its velocity", Plot::linear},
                     {"rear", "m", "of the spring, out of its rest", Plot::linear},
                     {"front", "m", "of the other", Plot::linear}};
    return scene;
}

inline Demo trebuchet_demo()
{
    Demo scene = joint_demo(
        "trebuchet", "A heavy box falls, a beam turns, a sling lets go",
        {{6, 5}, {14, 8}}, 1.0 / 240, [](const Settings& settings) {
            JointSetup setup;
            setup.scene = trebuchet_scene(settings["weight"], JointKind::rope);
            setup.scene.walls.push_back({{0, 1}, 0});
            constexpr Index stone = 2;
            constexpr std::size_t rope = 2;
            setup.traced = stone;
            const Real release = settings["release"] * pi / 180;
            setup.change = [release](JointedScene& moved, const Settings&) {
                const Vec2 v = moved.bodies.velocity(stone).head<2>();
                // it lets go when the stone flies forward at this angle
                if (v.norm() > 5 && v.x() > 0 && atan2(v.y(), v.x()) < release)
                    moved.placed[rope].broken = true;
            };
            setup.measure = [](const JointState& s) -> std::vector<Real> {
                return {s.scene.bodies.x[3 * stone],
                        s.scene.bodies.x[3 * stone + 1],
                        s.scene.bodies.velocity(stone).head<2>().norm(),
                        s.scene.placed[rope].broken ? 1.0 : 0.0};
            };
            return setup;
        });
    scene.tunables.push_back({"weight", "kg", "of the box", 1000, 100, 5000,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"release", "°", "at which the sling lets go", 40, 0,
                              90, Numbers::real, OnChange::restarts});
    scene.columns = {{"x", "m", "of the stone", Plot::linear},
                     {"y", "m", "its height", Plot::linear},
                     {"speed", "m/s", "of the stone", Plot::linear},
                     {"free", "", "1: the sling has let go"}};
    return scene;
}

}  // namespace rigid
