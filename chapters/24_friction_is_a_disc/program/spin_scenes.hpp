/// \file spin_scenes.hpp
/// What spins on a floor: a top, a ball that turns over, a boat that turns back.
#pragma once

#include "chapters/24_friction_is_a_disc/program/touch_scenes.hpp"
#include "chapters/24_friction_is_a_disc/spinning_scenes.hpp"

namespace rigid {

/// How far an axis leans from the vertical [°].
inline Real lean_of(const Vec3& axis)
{
    return atan2(Vec2(axis.x(), axis.z()).norm(), axis.y()) * 180 / pi;
}

inline Demo table_scene()
{
    Demo scene = rough_demo(
        "table", "A top on a table: friction alone holds its tip",
        {{0, 0.05}, {0.45, 0.3}}, 1.0 / 960, ways_to_drag,
        [](const Settings& settings) {
            RoughSetup setup;
            TopShape top;
            top.spin = settings["spin"];
            top.tilt = settings["tilt"] * pi / 180;
            setup.scene = top_on_table(top, settings["mu"]);
            setup.camera.target = {0, 0.12, 0};
            setup.camera.distance = 1;
            setup.traces = true;
            setup.ground = 0.3;
            setup.slop = 0;
            const Real exact = precession_of(top);
            setup.measure = [exact](const RoughState& s) -> std::vector<Real> {
                const Vec3 tip = point_of_solid(s.scene.bodies.x, 0,
                                                s.scene.shapes[0][0].vertices[0]);
                const Vec3 axis = centre_of(s.scene.bodies.x, 0) - tip;
                const Vec3 way = cross(world_spin(s.scene.bodies, 0), axis);
                const Real round = axis.x() * axis.x() + axis.z() * axis.z();
                return {lean_of(axis), cross(axis, way).y() / round, exact,
                        Vec2(tip.x(), tip.z()).norm()};
            };
            setup.picture = [](SolidPicture& picture, const RoughState& s) {
                const Hull& pin = s.scene.shapes[0][0];
                picture.line({point_of_solid(s.scene.bodies.x, 0, pin.vertices[0]),
                              centre_of(s.scene.bodies.x, 0)},
                             {Colour::ink, 3, 1});
            };
            return setup;
        });
    scene.tunables.push_back({"spin", "rad/s", "about its axis", 60, 40, 400,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"tilt", "°", "of the axis from upright", 30, 1, 45,
                              Numbers::real, OnChange::restarts});
    add_touch_tunables(scene, 1, 200);
    scene.columns = {
        {"tilt", "°", "of the axis from upright", Plot::linear},
        {"precession", "rad/s", "about the vertical", Plot::linear},
        {"precession_exact", "rad/s", "(21.8)"},
        {"wandered", "m", "how far the tip is from where it stood", Plot::linear}};
    return scene;
}

inline Demo low_ball_scene()
{
    Demo scene = rough_demo(
        "low_ball", "A ball whose mass lies low spins, and turns over",
        {{0, 0}, {0.09, 0.06}}, 1.0 / 2000, ways_to_drag,
        [](const Settings& settings) {
            RoughSetup setup;
            LowBall ball;
            ball.spin = settings["spin"];
            setup.scene = spinning_low_ball(ball, settings["mu"]);
            setup.camera.target = {0, 0.02, 0};
            setup.camera.distance = 0.3;
            setup.ground = 0.08;
            setup.slop = 0;
            const Real start = jellett(setup.scene);
            setup.measure = [start](const RoughState& s) -> std::vector<Real> {
                return {lean_of(axis_of(s.scene)),
                        world_spin(s.scene.bodies, 0).y(),
                        energy(s.scene) - s.energy, jellett(s.scene) / start - 1};
            };
            setup.picture = [](SolidPicture& picture, const RoughState& s) {
                const Vec3 middle = point_of_solid(
                    s.scene.bodies.x, 0, s.scene.shapes[0][0].vertices[0]);
                picture.arrow(middle, middle + 0.03 * axis_of(s.scene),
                              {Colour::red, 2, 1});
            };
            return setup;
        });
    scene.tunables.push_back({"spin", "rad/s", "about the vertical", 150, 1, 500,
                              Numbers::real, OnChange::restarts});
    add_touch_tunables(scene, 0.3, 200);
    scene.columns = {{"axis", "°", "from upright", Plot::linear},
                     {"spin", "rad/s", "about the vertical", Plot::linear},
                     {"energy", "J", "less that of the start", Plot::linear},
                     {"jellett_error", "",
                      "(24.13) over that of the start, minus 1", Plot::linear}};
    return scene;
}

inline Demo rattleback_scene()
{
    Demo scene = rough_demo(
        "rattleback", "A boat that spins one way, rattles, and spins the other",
        {{0, 0}, {0.36, 0.24}}, 1.0 / 2000, ways_to_drag,
        [](const Settings& settings) {
            RoughSetup setup;
            Rattleback boat;
            boat.askew = settings["askew"];
            setup.scene =
                spinning_rattleback(boat, settings["spin"], 0.01, settings["mu"]);
            setup.camera.distance = 1;
            setup.camera.height = 0.6;
            setup.ground = 0.3;
            setup.slop = 0;
            // the equation beside it, from where it was at the last look
            struct Beside {
                RollingSolid solid;
                Vec<6> y;
                Real t = 0;
            };
            const auto beside = std::make_shared<Beside>();
            beside->solid = rolling_solid(setup.scene);
            beside->y = rolling_state(setup.scene);
            setup.measure = [beside](const RoughState& s) -> std::vector<Real> {
                const auto parts =
                    static_cast<int>(std::ceil((s.t - beside->t) / 5e-4 - 1e-9));
                for (int i = 0; i < parts; ++i)
                    beside->y =
                        roll(beside->solid, beside->y, (s.t - beside->t) / parts);
                beside->t = s.t;
                return {world_spin(s.scene.bodies, 0).y(),
                        beside->y.head<3>().dot(beside->y.tail<3>()),
                        lean_of(rotation_of(s.scene.bodies.x, 0).col(1)),
                        energy(s.scene) - s.energy};
            };
            return setup;
        });
    scene.tunables.push_back({"spin", "rad/s", "about the vertical", 3, -20, 20,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"askew", "rad", "of its masses to its keel", 0.05,
                              -0.5, 0.5, Numbers::real, OnChange::restarts});
    add_touch_tunables(scene, 1, 200);
    scene.columns = {{"spin", "rad/s", "about the vertical", Plot::linear},
                     {"spin_exact", "rad/s", "by (24.12)"},
                     {"tilt", "°", "of its deck", Plot::linear},
                     {"energy", "J", "less that of the start", Plot::linear}};
    return scene;
}

}  // namespace rigid
