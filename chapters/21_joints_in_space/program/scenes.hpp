/// \file scenes.hpp
/// A top, rods and plates on joints, a door, a gyroscope.
#pragma once

#include "chapters/21_joints_in_space/gyroscope.hpp"
#include "chapters/21_joints_in_space/program/hung_demo.hpp"
#include "chapters/21_joints_in_space/program/space_run.hpp"

namespace rigid {

inline Demo top_scene()
{
    Demo scene = joint_demo(
        "top", "A top on its tip: steady precession beside its closed form",
        {{0, 0.02}, {0.42, 0.28}}, 1.0 / 960, {"exact", "islands"},
        [](const Settings& settings) {
            JointSetup setup;
            TopShape top;
            top.spin = settings["spin"];
            top.tilt = settings["tilt"] * pi / 180;
            setup.scene = spinning_top(top);
            setup.camera.target = {0, 0.12, 0};
            setup.camera.distance = 1;
            setup.traces = true;
            setup.picture = [](SolidPicture& picture, const JointState& s) {
                const Vec3 tip(0, 0, 0), up(0, 0.33, 0);
                const Vec3 end = 0.36 * centre_of(s.scene.bodies.x, 0).normalized();
                picture.line({tip, up}, {Colour::ink, 1.5, 1, Paint::dashed});
                picture.arrow(tip, end, {Colour::red, 2.5, 1});
                picture.label(up + Vec3(-0.03, 0.01, 0), "vertical");
                picture.label(end + Vec3(0.01, 0.01, 0), "spin ω", Colour::red);
                picture.label(Vec3(-0.38, 0.15, 0), "way of the centre",
                              Colour::purple);
            };
            const Real exact = precession_of(top);
            setup.measure = [exact](const JointState& s) -> std::vector<Real> {
                const Vec3 p = centre_of(s.scene.bodies.x, 0);
                const Vec3 v = s.scene.bodies.u.head<3>();
                const Real round = p.x() * p.x() + p.z() * p.z();
                return {atan2(std::sqrt(round), p.y()) * 180 / pi,
                        cross(p, v).y() / round, exact,
                        largest_joint_error(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back({"spin", "rad/s", "about its axis", 60, 40, 400,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"tilt", "°", "of the axis from upright", 30, 1, 80,
                              Numbers::real, OnChange::restarts});
    scene.columns = {
        {"tilt", "°", "of the axis from upright", Plot::linear},
        {"precession", "rad/s", "about the vertical", Plot::linear},
        {"precession_exact", "rad/s", "(21.8)"},
        {"joint_error", "m", "how far the tip has moved", Plot::logarithmic}};
    return scene;
}

inline Demo chain_scene()
{
    return hung_demo<JointedSolids, JointSteps>(
        "chain",
        "Rods on ball joints and constant-velocity joints swing out of the plane",
        {{0, 0}, {4.6, 3.2}},
        [](const Settings& settings) {
            JointSetup setup;
            const Real length = settings["rods"];  // of 1 m each
            setup.scene = rod_chain(static_cast<int>(settings["rods"]));
            setup.camera.target = {0, -1.6, 0};
            setup.camera.distance = 14;
            setup.traces = true;
            setup.traced = {0.4, 0, 0};
            setup.picture = [length](SolidPicture& picture, const JointState&) {
                const Vec3 pin(0, 0, 0), end(length, 0, 0);
                picture.line({pin, end}, {Colour::ink, 1.5, 1, Paint::dashed});
                picture.line({{-0.4, 0, 0}, {0.4, 0, 0}}, {Colour::ink, 4, 1});
                picture.label({-1.1, 0, 0}, "pin");
                picture.label({0.4 * length, 0.1, 0}, "at the start");
            };
            return setup;
        },
        {{"rods", "", "rods of the chain", 4, 1, 12, Numbers::whole,
          OnChange::restarts}});
}

inline Demo door_scene()
{
    Demo scene = joint_demo(
        "door", "A motor on a hinge drives a door from stop to stop",
        {{0, 0}, {2.1, 1.4}}, 1.0 / 240, {"exact", "islands"},
        [](const Settings& settings) {
            JointSetup setup;
            setup.scene = driven_door(settings["speed"], settings["torque"],
                                      settings["stop"] * pi / 180);
            setup.camera.distance = 5;
            setup.change = [](JointedSolids& moved, const Settings& now, Real t) {
                SpaceJoint& joint = moved.joints[0];
                const bool back = std::fmod(t, 4.0) >= 2;
                joint.speed = back ? -now["speed"] : now["speed"];
                joint.force = now["torque"];
            };
            setup.measure = [](const JointState& s) -> std::vector<Real> {
                const JointFrames f =
                    frames_of(s.scene.bodies.x, s.scene.joints[0]);
                return {turn_of(twist, f.q).value * 180 / pi,
                        world_spin(s.scene.bodies, 0).y(),
                        largest_joint_error(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back({"speed", "rad/s", "of the motor", 1.5, -5, 5});
    scene.tunables.push_back(
        {"torque", "N m", "of the motor, at most", 20, 0, 500});
    scene.tunables.push_back({"stop", "°", "stops at this to either side", 75, 5,
                              170, Numbers::real, OnChange::restarts});
    scene.columns = {
        {"angle", "°", "of the door", Plot::linear},
        {"omega", "rad/s", "of the door", Plot::linear},
        {"joint_error", "m", "largest of a locked coordinate", Plot::logarithmic}};
    return scene;
}

inline Demo gyroscope_scene()
{
    Demo scene = joint_demo(
        "gyroscope", "A wheel in a gimbal: a weight on its axis turns it about",
        {{0, 0}, {0.6, 0.45}}, 1.0 / 960, {"exact", "islands"},
        [](const Settings& settings) {
            JointSetup setup;
            Gyroscope gyroscope;
            gyroscope.spin = settings["spin"];
            gyroscope.weight = settings["weight"];
            setup.scene = gyroscope_in_gimbal(gyroscope);
            setup.camera.distance = 2;
            setup.camera.azimuth = 1.1;
            setup.skin = Skin::opaque;
            const Real exact = precession_of(gyroscope);
            setup.measure = [exact](const JointState& s) -> std::vector<Real> {
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
    return hung_demo<JointedSolids, JointSteps>(
        "plates", "Plates on hinges swing in one plane, however they are pushed",
        {{0, 0}, {6.4, 4.8}},
        [](const Settings& settings) {
            JointSetup setup;
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

}  // namespace rigid
