/// \file scene_mechanisms.hpp
/// Ladder, seesaw, gears and crank.
#pragma once

#include "chapters/11_rotation/program/rigid_run.hpp"
#include "common/elementary.hpp"

#include <array>

namespace rigid {

inline Demo ladder_scene()
{
    Demo scene = rigid_demo(
        "ladder",
        "A ladder slides down without friction, and leaves the wall at two thirds "
        "of its height",
        {{1.3, 0.95}, {1.5, 1.1}}, [](const Settings& settings) {
            RigidSetup setup;
            setup.scene = ladder(settings["angle"] * pi / 180);
            setup.traced = 0;
            const Real start = cos(settings["angle"] * pi / 180);
            setup.measure = [start](const RigidState& s) -> std::vector<Real> {
                Real floor = 0, wall = 0;
                for (std::size_t i = 0; i < s.now.contacts.size(); ++i)
                    (s.now.contacts[i].normal.y() > 0.5 ? floor : wall) +=
                        s.now.solution.lambda[static_cast<Index>(i)] / s.now.h;
                return {s.scene.bodies.x[1] / start, floor, wall, energy(s.scene)};
            };
            setup.picture = [start](Canvas& canvas, const RigidState&) {
                canvas.segment({-0.1, 4 * start / 3}, {0.2, 4 * start / 3},
                               paint::theory);
                canvas.text({0.25, 4 * start / 3}, "leaves here", 14, paint::label);
            };
            return setup;
        });
    scene.tunables.push_back({"angle", "°", "from the wall at the start", 10, 1, 80,
                              Numbers::real, OnChange::restarts});
    scene.columns = {
        {"height", "", "of the centre, as a part of that at the start",
         Plot::linear},
        {"floor", "N", "force of the floor in the last sub-step", Plot::linear},
        {"wall", "N", "force of the wall", Plot::linear},
        {"energy", "J", "kinetic and potential", Plot::linear}};
    return scene;
}

inline Demo seesaw_scene()
{
    Demo scene = rigid_demo(
        "seesaw", "Two weights on ropes from the ends of a plank",
        {{0, -0.5}, {2.7, 1.9}}, [](const Settings& settings) {
            const Real left = settings["left"], right = settings["right"];
            RigidSetup setup;
            setup.scene = seesaw(left, right);
            setup.measure = [left,
                             right](const RigidState& s) -> std::vector<Real> {
                return {s.scene.bodies.x[2],
                        (s.scene.bodies.u[2] - s.before[2]) / s.h,
                        seesaw_by_hand(left, right), energy(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back({"left", "kg", "weight on the left", 10, 1, 50,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"right", "kg", "weight on the right", 12, 1, 50,
                              Numbers::real, OnChange::restarts});
    scene.columns = {
        {"angle", "rad", "of the plank", Plot::linear},
        {"acceleration", "rad/s²", "of the plank in the last step", Plot::linear},
        {"level", "rad/s²", "by hand, where it lies level"},
        {"energy", "J", "kinetic and potential", Plot::linear}};
    return scene;
}

inline Demo gears_scene()
{
    static constexpr std::array<Real, 4> radii = {0.2, 0.5, 0.3, 0.6};
    Demo scene = rigid_demo(
        "gears", "A motor turns a train of wheels, each held by its pin",
        {{1.4, 0}, {1.75, 0.8}}, [](const Settings& settings) {
            RigidSetup setup;
            setup.scene = gear_train(radii, settings["speed"], settings["torque"]);
            setup.change = [](RigidScene& moved, const Settings& now) {
                moved.joints.back().speed = now["speed"];
                moved.joints.back().force = now["torque"];
            };
            const Real torque = settings["torque"];
            setup.measure = [torque](const RigidState& s) -> std::vector<Real> {
                const VecX& u = s.scene.bodies.u;
                return {u[2],
                        u[5],
                        u[8],
                        u[11],
                        (u[2] - s.before[2]) / s.h,
                        torque / gear_inertia(radii)};
            };
            return setup;
        });
    scene.tunables.push_back({"speed", "rad/s", "of the motor", 10, -30, 30,
                              Numbers::real, OnChange::goes_on, Keys::up_and_down});
    scene.tunables.push_back({"torque", "N m", "of the motor, at most", 1, 0, 50});
    scene.columns = {{"omega_1", "rad/s", "of the first wheel", Plot::linear},
                     {"omega_2", "rad/s", "of the second", Plot::linear},
                     {"omega_3", "rad/s", "of the third", Plot::linear},
                     {"omega_4", "rad/s", "of the fourth", Plot::linear},
                     {"acceleration", "rad/s²",
                      "of the first wheel in the last step", Plot::linear},
                     {"by_hand", "rad/s²",
                      "while the motor pulls with the torque of the start"}};
    return scene;
}

inline Demo crank_scene()
{
    Demo scene = rigid_demo(
        "crank", "A crank, a rod and a slider beside the closed form",
        {{0.3, 0}, {0.6, 0.4}}, [](const Settings&) {
            RigidSetup setup;
            setup.scene = slider_crank();
            setup.measure = [](const RigidState& s) -> std::vector<Real> {
                const Vec2 slider = point_of(s.scene.bodies.x, 1, {0.25, 0});
                const Real truth = slider_by_hand(s.scene.bodies.x[2]);
                return {slider.x(), truth, std::abs(slider.x() - truth),
                        slider.y()};
            };
            setup.picture = [](Canvas& canvas, const RigidState& s) {
                canvas.segment({0, 0}, point_of(s.scene.bodies.x, 0, {0.2, 0}),
                               paint::link);
                canvas.segment({0.2, 0}, {0.85, 0}, paint::theory);
                canvas.box(point_of(s.scene.bodies.x, 1, {0.25, 0}), {0.04, 0.03},
                           0, paint::body);
            };
            return setup;
        });
    scene.columns = {
        {"slider", "m", "place of the slider", Plot::linear},
        {"exact", "m", "closed form at the crank's angle", Plot::linear, "slider"},
        {"error", "m", "their difference", Plot::logarithmic},
        {"off", "m", "of the slider beside its rail", Plot::linear}};
    return scene;
}

}  // namespace rigid
