/// \file scenes.hpp
/// What is tossed, a top, rods on joints, and a door.
#pragma once

#include "chapters/20_turning_in_space/exact_tumbling.hpp"
#include "chapters/20_turning_in_space/tossed.hpp"
#include "chapters/25_world_in_space/program/hung_demo.hpp"
#include "chapters/25_world_in_space/program/space_run.hpp"
#include "common/elementary.hpp"

namespace rigid {

inline const std::vector<std::string> ways_to_tumble = {"middle", "explicit",
                                                        "implicit", "momentum"};

/// A free spin: how far energy and angular momentum are from what they were.
inline std::vector<Real> free_spin(const SpaceState& s)
{
    const Bodies<6>& bodies = s.scene.bodies;
    const Vec3 L = momenta(bodies).tail<3>();
    return {energy(s.scene) / s.energy - 1,
            (L - s.spin_momentum).norm() / s.spin_momentum.norm(), bodies.u[3],
            bodies.u[4], bodies.u[5]};
}

inline std::vector<Column> spin_columns()
{
    return {{"energy_error", "", "energy over that of the start, minus 1",
             Plot::linear},
            {"momentum_error", "", "how far L has moved, as a part of it",
             Plot::linear},
            {"omega_1", "rad/s", "in the body's axes", Plot::linear},
            {"omega_2", "rad/s", "in the body's axes", Plot::linear},
            {"omega_3", "rad/s", "in the body's axes", Plot::linear}};
}

/// The angular momentum, which stays, and the angular velocity, which does not.
inline void draw_spin(SolidPicture& picture, const SpaceState& s, Real length)
{
    const Vec3 L = momenta(s.scene.bodies).tail<3>(),
               omega = world_spin(s.scene.bodies, 0);
    if (L.norm() > 0)
        picture.arrow({0, 0, 0}, length * L.normalized(), {Colour::red, 2.5, 1});
    if (omega.norm() > 0)
        picture.arrow({0, 0, 0}, length * omega.normalized(),
                      {Colour::green, 2, 1});
}

inline Demo tossed_demo(const std::string& name, const std::string& summary,
                        SpaceScene (*make)(Real, Real), Real omega, Real size,
                        const Vec3& traced)
{
    Demo scene = space_demo(
        name, summary, {{0, 0}, {1.6 * size, 1.1 * size}}, 1.0 / 240,
        ways_to_tumble, [make, size, traced](const Settings& settings) {
            SpaceSetup setup;
            setup.scene = make(settings["spin"], settings["tilt"]);
            setup.camera.distance = 5 * size;
            setup.traces = true;
            setup.traced = traced;
            setup.measure = free_spin;
            setup.picture = [size](SolidPicture& picture, const SpaceState& s) {
                draw_spin(picture, s, size);
            };
            return setup;
        });
    scene.tunables.push_back({"spin", "rad/s", "about the middle axis", omega, 1,
                              60, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"tilt", "", "part of it about the other axes", 0.01,
                              0.0001, 0.5, Numbers::real, OnChange::restarts});
    scene.columns = spin_columns();
    return scene;
}

inline Demo book_scene()
{
    return tossed_demo("book",
                       "A book is tossed about its middle axis: it turns over",
                       tossed_book, 12, 0.2, {0, 0.12, 0});
}

inline Demo handle_scene()
{
    return tossed_demo("handle",
                       "A T-shaped handle spins, and turns about again and again",
                       t_handle, 20, 0.09, {0, 0, 0.05});
}

inline Demo spin_scene()
{
    Demo scene = space_demo(
        "spin", "A free body beside its closed form, by four ways",
        {{0, 0}, {2.2, 1.5}}, 1.0 / 60, ways_to_tumble, [](const Settings&) {
            SpaceSetup setup;
            setup.scene = spinning_plate();
            setup.camera.distance = 6;
            setup.traces = true;
            setup.traced = {1.2, 0, 0};
            setup.measure = [](const SpaceState& s) {
                const Vec3 exact = exact_spin({1, 2, 3}, 0.5, 1, s.t),
                           omega = s.scene.bodies.u.segment<3>(3);
                std::vector<Real> numbers = free_spin(s);
                numbers.push_back((omega - exact).norm());
                return numbers;
            };
            setup.picture = [](SolidPicture& picture, const SpaceState& s) {
                draw_spin(picture, s, 1.2);
            };
            return setup;
        });
    scene.columns = spin_columns();
    scene.columns.push_back(
        {"error", "rad/s", "of omega, beside (25.16)", Plot::logarithmic});
    return scene;
}

inline Demo top_scene()
{
    Demo scene = space_demo(
        "top", "A top on its tip: steady precession beside its closed form",
        {{0, 0.16}, {0.42, 0.28}}, 1.0 / 960, {"exact", "islands"},
        [](const Settings& settings) {
            SpaceSetup setup;
            TopShape top;
            top.spin = settings["spin"];
            top.tilt = settings["tilt"] * pi / 180;
            setup.scene = spinning_top(top);
            setup.camera.target = {0, 0.12, 0};
            setup.camera.distance = 1;
            setup.traces = true;
            const Real exact = precession_of(top);
            setup.measure = [exact](const SpaceState& s) -> std::vector<Real> {
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
        {"precession_exact", "rad/s", "(25.28)"},
        {"joint_error", "m", "how far the tip has moved", Plot::logarithmic}};
    return scene;
}

inline Demo chain_scene()
{
    return hung_demo(
        "chain",
        "Rods on ball joints and constant-velocity joints swing out of the plane",
        {{0, -1.6}, {4.6, 3.2}},
        [](const Settings& settings) {
            SpaceSetup setup;
            setup.scene = rod_chain(static_cast<int>(settings["rods"]));
            setup.camera.target = {0, -1.6, 0};
            setup.camera.distance = 14;
            setup.traces = true;
            setup.traced = {0.4, 0, 0};
            return setup;
        },
        {{"rods", "", "rods of the chain", 4, 1, 12, Numbers::whole,
          OnChange::restarts}});
}

inline Demo door_scene()
{
    Demo scene = space_demo(
        "door", "A motor on a hinge drives a door from stop to stop",
        {{0, 0}, {2.1, 1.4}}, 1.0 / 240, {"exact", "islands"},
        [](const Settings& settings) {
            SpaceSetup setup;
            setup.scene = driven_door(settings["speed"], settings["torque"],
                                      settings["stop"] * pi / 180);
            setup.camera.distance = 5;
            setup.change = [](SpaceScene& moved, const Settings& now, Real t) {
                SpaceJoint& joint = moved.joints[0];
                const bool back = std::fmod(t, 4.0) >= 2;
                joint.speed = back ? -now["speed"] : now["speed"];
                joint.force = now["torque"];
            };
            setup.measure = [](const SpaceState& s) -> std::vector<Real> {
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

}  // namespace rigid
