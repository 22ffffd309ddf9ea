/// \file scene_pendulums.hpp
/// One rod on a pin, and two.
#pragma once

#include "chapters/01_euler_integration/exact.hpp"
#include "chapters/11_rotation/program/rigid_run.hpp"
#include "common/elementary.hpp"

#include <array>

namespace rigid {

inline Demo pendulum_scene()
{
    Demo scene = rigid_demo(
        "pendulum", "A rod on a pin beside its closed form: the order is one",
        {{0, -0.15}, {1.2, 1}}, [](const Settings& settings) {
            const Real start = settings["angle"] * pi / 180;
            RigidSetup setup;
            setup.scene = rod_pendulum(std::array{start});
            // a rod swings as a point at two thirds of its length
            const auto exact = [start](Real t) {
                return exact_pendulum({.g = 9.81, .length = 2.0 / 3}, start, t)
                    .x[0];
            };
            setup.measure = [exact](const RigidState& s) -> std::vector<Real> {
                const Real angle = rod_angle(s.scene, 0), truth = exact(s.t);
                return {angle, truth, std::abs(angle - truth), energy(s.scene),
                        largest_joint_error(s.scene)};
            };
            setup.picture = [exact](Canvas& canvas, const RigidState& s) {
                const Real angle = exact(s.t);
                canvas.segment({0, 0}, {sin(angle), -cos(angle)},
                               {Colour::ink, 2, 0.7, Paint::dashed});
                canvas.text({-1.1, 0.7}, "dashed: closed form", 14, paint::label);
            };
            return setup;
        });
    scene.tunables.push_back({"angle", "°", "at the start, from straight down", 90,
                              1, 179, Numbers::real, OnChange::restarts});
    scene.columns = {{"angle", "rad", "from straight down", Plot::linear},
                     {"exact", "rad", "closed form", Plot::linear, "angle"},
                     {"error", "rad", "their difference", Plot::logarithmic},
                     {"energy", "J", "kinetic and potential", Plot::linear},
                     {"joint", "m", "largest error of the pin", Plot::logarithmic}};
    return scene;
}

inline Demo double_scene()
{
    Demo scene = rigid_demo(
        "double",
        "Two rods in a row: two starts that differ by a hair part within seconds",
        {{0, -0.2}, {2.3, 2.15}}, [](const Settings& settings) {
            const Real start = settings["angle"] * pi / 180;
            RigidSetup setup;
            const RigidScene one = rod_pendulum(std::array{start, start}),
                             two = rod_pendulum(
                                 std::array{start, start + settings["hair"]});
            setup.scene = one;  // both in one scene: they share no row
            for (Index k = 0; k < 2; ++k) {
                const Index other = add_body(
                    setup.scene, capsule(1, 0), thin_rod(1, 1),
                    two.bodies.position(k).head<2>(), two.bodies.x[3 * k + 2]);
                add_pin(setup.scene, k == 0 ? world : other - 1,
                        k == 0 ? Vec2(0, 0) : Vec2(0.5, 0), other, {-0.5, 0});
            }
            setup.picture = [](Canvas& canvas, const RigidState& s) {
                const VecX& x = s.scene.bodies.x;  // the second one over its rods
                for (const Index k : {2, 3})
                    canvas.segment(point_of(x, k, {-0.5, 0}),
                                   point_of(x, k, {0.5, 0}),
                                   {Colour::orange, 5, 1});
            };
            setup.traced = 1;
            setup.traced_point = {0.5, 0};
            setup.measure = [](const RigidState& s) -> std::vector<Real> {
                const VecX& x = s.scene.bodies.x;
                return {
                    rod_angle(s.scene, 0), rod_angle(s.scene, 1),
                    (point_of(x, 1, {0.5, 0}) - point_of(x, 3, {0.5, 0})).norm(),
                    energy(s.scene) / 2, largest_joint_error(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back({"angle", "°", "of both rods at the start", 120, 1,
                              179, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"hair", "rad", "by which the second start differs",
                              1e-3, 0, 0.1, Numbers::real, OnChange::restarts});
    scene.columns = {
        {"angle_1", "rad", "of the upper rod", Plot::linear},
        {"angle_2", "rad", "of the lower rod", Plot::linear},
        {"apart", "m", "between the ends of the two starts", Plot::logarithmic},
        {"energy", "J", "mean of the two", Plot::linear},
        {"joint", "m", "largest error of a pin", Plot::logarithmic}};
    return scene;
}

}  // namespace rigid
