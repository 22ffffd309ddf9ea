/// \file scene_machines.hpp
/// A crane, an engine, a leg that walks, a cradle, a car on hills, a trebuchet.
#pragma once

#include "chapters/14_joints/bar_linkages.hpp"
#include "chapters/14_joints/program/scene_loads.hpp"

namespace rigid {

/// Another speed for the motor of a joint.
inline void set_motor(JointedScene& scene, std::size_t number, Real speed)
{
    RigidJoint joint = scene.placed[number].joint;
    if (joint.motor.speed == speed) return;
    joint.motor.speed = speed;
    change_joint(scene, number, joint);
}

inline Demo crane_demo()
{
    Demo scene = joint_demo(
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
    scene.tunables.push_back(
        {"links", "", "of the rope", 30, 1, 200, true, true, false});
    scene.tunables.push_back({"ratio", "", "mass of the load over that of a link",
                              1000, 1, 1e5, false, true, false});
    scene.tunables.push_back(
        {"speed", "m/s", "of the trolley", 0.5, -2, 2, false, false, true});
    scene.columns = load_columns();
    return scene;
}

inline Demo engine_demo()
{
    Demo scene = joint_demo(
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
    scene.tunables.push_back(
        {"speed", "rad/s", "of the crank", 10, -30, 30, false, false, true});
    scene.tunables.push_back({"torque", "N m", "of its motor, at most", 1e4, 1, 1e5,
                              false, true, false});
    scene.columns = {
        {"piston", "m", "its place", true, false},
        {"exact", "m", "closed form at the crank's angle", false, false},
        {"error", "m", "their difference", true, true},
        {"omega", "rad/s", "of the crank", true, false}};
    return scene;
}

inline Demo leg_demo()
{
    Demo scene = joint_demo(
        "leg", "Jansen's leg: a crank turns, and a foot walks",
        {{-0.35, -0.25}, {0.9, 0.75}}, 1.0 / 240, [](const Settings& settings) {
            JointSetup setup;
            const Index crank =
                add_jansen_leg(setup.scene, 0.4, {settings["speed"], 1e3, 0, 0, 0});
            setup.traced = crank + 6;
            setup.traced_point =
                local_point(setup.scene, crank + 6, JansenLeg(0.4).p[5]);
            setup.measure = [crank](const JointState& s) -> std::vector<Real> {
                return {s.scene.bodies.u[3 * crank + 2],
                        largest_joint_error(s.scene), s.residual()};
            };
            return setup;
        });
    for (Tunable& tunable : scene.tunables)  // a motor has bounds, and is swept
        if (tunable.name == "sweeps") tunable.value = 200;
    scene.tunables.push_back(
        {"speed", "rad/s", "of the crank", 6, -20, 20, false, true, false});
    scene.columns = {{"omega", "rad/s", "of the crank", true, false},
                     {"gap", "m", "largest error of a joint", true, true},
                     {"residual", "m/s", "what the solver left", false, true}};
    return scene;
}

/// Balls on rods without mass: each is one body with a pin above it.
inline Demo cradle_demo()
{
    Demo scene = joint_demo(
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
                string.b = add_body(
                    setup.scene, disc(0.2), Mass{1, {0, 0}, 0.02},
                    {x + 1.5 * std::sin(swing), -1.5 * std::cos(swing)}, swing);
                add_joint(setup.scene, string);
            }
            setup.picture = [](Canvas& canvas, const JointState& s) {
                for (const PlacedJoint& placed : s.scene.placed)
                    canvas.segment(
                        placed.joint.at_a,
                        s.scene.bodies.position(placed.joint.b).head<2>(),
                        {Colour::faint, 1.5, 1, false, false});
            };
            setup.measure = [balls](const JointState& s) -> std::vector<Real> {
                return {s.scene.bodies.u[2], s.scene.bodies.u[3 * balls - 1],
                        energy(s.scene) - s.energy_at_start};
            };
            return setup;
        });
    scene.tunables.push_back({"balls", "", "how many", 5, 2, 9, true, true, false});
    scene.tunables.push_back({"restitution", "", "e", 1, 0, 1, false, true, false});
    scene.columns = {{"first", "rad/s", "swing of the first ball", true, false},
                     {"last", "rad/s", "of the last", true, false},
                     {"energy", "J", "gained since the start", true, false}};
    return scene;
}

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
    scene.methods = {"trees", "sweeps"};  // springs are rows here
    scene.tunables.push_back(
        {"speed", "m/s", "that the motor wants", 3, -6, 6, false, false, true});
    scene.tunables.push_back({"torque", "N m", "of each axle, at most", 400, 0,
                              2000, false, true, false});
    scene.tunables.push_back(
        {"stiffness", "N/m", "of a spring", 3e4, 1e3, 1e6, false, true, false});
    scene.columns = {{"x", "m", "of the chassis", true, false},
                     {"v", "m/s", "its velocity", true, false},
                     {"rear", "m", "of the spring, out of its rest", true, false},
                     {"front", "m", "of the other", true, false}};
    return scene;
}

inline Demo trebuchet_demo()
{
    Demo scene = joint_demo(
        "trebuchet", "A heavy box falls, a beam turns, a sling lets go",
        {{6, 5}, {14, 8}}, 1.0 / 240, [](const Settings& settings) {
            JointSetup setup;
            JointedScene& all = setup.scene;
            all.walls.push_back({{0, 1}, 0});
            const Real angle = -0.55;
            const Vec2 axle(0, 2.6), along(std::cos(angle), std::sin(angle));
            const Vec2 tip = axle - 4 * Vec2(along.x(), -along.y()),
                       end = axle + 1 * Vec2(along.x(), -along.y());
            const Index beam = add_bar(all, tip, end, 60),
                        weight =
                            add_body(all, box(0.8, 0.8), settings["weight"] / 0.64,
                                     end - Vec2(0, 0.6)),
                        stone = add_body(all, disc(0.15), Mass{10, {0, 0}, 0.1},
                                         tip + Vec2(2.6, -0.35));
            pin(all, world, beam, axle);
            pin(all, beam, weight, end);
            RigidJoint sling;
            sling.kind = JointKind::rope;
            sling.a = beam, sling.b = stone;
            sling.at_a = local_point(all, beam, tip);
            sling.length = (all.bodies.position(stone).head<2>() - tip).norm();
            const std::size_t rope = add_joint(all, sling);
            setup.traced = stone;
            const Real release = settings["release"] * pi / 180;
            setup.change = [rope, stone, release](JointedScene& moved,
                                                  const Settings&) {
                const Vec2 v = moved.bodies.velocity(stone).head<2>();
                // it lets go when the stone flies forward at this angle
                if (v.norm() > 5 && v.x() > 0 && std::atan2(v.y(), v.x()) < release)
                    moved.placed[rope].broken = true;
            };
            setup.measure = [stone,
                             rope](const JointState& s) -> std::vector<Real> {
                return {s.scene.bodies.x[3 * stone],
                        s.scene.bodies.x[3 * stone + 1],
                        s.scene.bodies.velocity(stone).head<2>().norm(),
                        s.scene.placed[rope].broken ? 1.0 : 0.0};
            };
            return setup;
        });
    scene.tunables.push_back(
        {"weight", "kg", "of the box", 1000, 100, 5000, false, true, false});
    scene.tunables.push_back({"release", "°", "at which the sling lets go", 40, 0,
                              90, false, true, false});
    scene.columns = {{"x", "m", "of the stone", true, false},
                     {"y", "m", "its height", true, false},
                     {"speed", "m/s", "of the stone", true, false},
                     {"free", "", "1: the sling has let go", false, false}};
    return scene;
}

}  // namespace rigid
