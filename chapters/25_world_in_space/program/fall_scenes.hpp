/// \file fall_scenes.hpp
/// What is knocked over, what falls down stairs, and what drives.
#pragma once

#include "chapters/24_friction_is_a_disc/program/touch_scenes.hpp"
#include "chapters/25_world_in_space/built_scenes.hpp"
#include "chapters/25_world_in_space/car.hpp"
#include "chapters/25_world_in_space/doll_scenes.hpp"
#include "chapters/25_world_in_space/program/space_run.hpp"

namespace rigid {

/// Energy, joints, limits, contacts: what all of these scenes show.
inline std::vector<Real> measure_fall(const SpaceState& s)
{
    return {energy(s.scene) - s.energy, largest_joint_error(s.scene),
            largest_limit_error(s.scene), deepest_overlap(s.now),
            static_cast<Real>(s.now.solution.iterations)};
}

inline Demo fall_demo(const std::string& name, const std::string& summary,
                      const View& view, Real h,
                      const std::function<SpaceSetup(const Settings&)>& make,
                      const std::vector<Tunable>& tunables)
{
    Demo scene = space_demo(name, summary, view, h, ways_to_drag,
                            [make](const Settings& settings) {
                                SpaceSetup setup = make(settings);
                                setup.measure = measure_fall;
                                return setup;
                            });
    scene.tunables.insert(scene.tunables.end(), tunables.begin(), tunables.end());
    scene.tunables.push_back({"parts", "", "of a step that look for contacts", 1, 1,
                              64, Numbers::whole});
    scene.tunables.push_back(
        {"substeps", "", "of a part, with its contacts", 4, 1, 64, Numbers::whole});
    add_touch_tunables(scene, 0.6, 50);
    scene.columns = {
        {"energy", "J", "less that of the start", Plot::linear},
        {"joint_error", "m", "largest of a locked coordinate", Plot::logarithmic},
        {"limit_error", "rad", "that limits are overstepped by", Plot::logarithmic},
        {"overlap", "m", "the deepest", Plot::linear},
        {"sweeps", "", "of the last part of the step", Plot::linear}};
    return scene;
}

inline Demo wall_scene()
{
    return fall_demo(
        "wall", "A brick wall stands until a wrecking ball comes",
        {{0, 0}, {5.2, 3.6}}, 1.0 / 60,
        [](const Settings& settings) {
            SpaceSetup setup;
            setup.scene =
                brick_wall(static_cast<int>(settings["rows"]), 7, settings["mu"]);
            WreckingBall ball;
            ball.lift = settings["lift"] * pi / 180;
            add_wrecking_ball(setup.scene, ball, settings["mu"]);
            setup.camera = {{0, 1.6, -0.5}, 14, 0.9, 0.25};
            setup.ground = 4;
            return setup;
        },
        {{"rows", "", "of the wall", 7, 1, 12, Numbers::whole, OnChange::restarts},
         {"lift", "°", "of the ball", 60, 0, 85, Numbers::real,
          OnChange::restarts}});
}

inline Demo cards_scene()
{
    return fall_demo(
        "cards", "A tower of cards stands by friction", {{0, 0}, {4, 3}}, 1.0 / 60,
        [](const Settings& settings) {
            SpaceSetup setup;
            setup.scene = card_tower(static_cast<int>(settings["storeys"]),
                                     settings["lean"] * pi / 180, settings["mu"]);
            setup.camera = {{0, 1.3, 0}, 12, 0.35, 0.2};
            setup.ground = 3;
            return setup;
        },
        {{"storeys", "", "of the tower", 3, 1, 6, Numbers::whole,
          OnChange::restarts},
         {"lean", "°", "of a card from upright", 17, 5, 40, Numbers::real,
          OnChange::restarts}});
}

inline Demo dolls_scene()
{
    return fall_demo("dolls", "Dolls on ball joints and hinges fall down stairs",
                     {{0, 0}, {6.4, 4.4}}, 1.0 / 60,
                     [](const Settings& settings) {
                         SpaceSetup setup;
                         setup.scene =
                             dolls_on_stairs(static_cast<int>(settings["dolls"]),
                                             settings["speed"]);
                         setup.camera = {{1.5, 1.2, 0}, 15, 0.7, 0.35};
                         setup.ground = 6;
                         return setup;
                     },
                     {{"dolls", "", "on the landing", 3, 1, 10, Numbers::whole,
                       OnChange::restarts},
                      {"speed", "m/s", "towards the stairs", 2, 0, 10,
                       Numbers::real, OnChange::restarts}});
}

inline Demo car_scene()
{
    Demo scene = space_demo(
        "car", "A car on struts drives over bumps by the motors of its wheels",
        {{0, 0}, {4.4, 3}}, 1.0 / 240, ways_to_drag, [](const Settings& settings) {
            SpaceSetup setup;
            Car car;
            car.speed = settings["speed"], car.torque = settings["torque"];
            car.sink = settings["sink"] / 100;
            setup.scene = car_on_floor(car, settings["mu"]);
            add_bumps(setup.scene, static_cast<int>(settings["bumps"]),
                      settings["bump"] / 100, settings["mu"]);
            setup.camera = {{0, 0.4, 0}, 12, 0.6, 0.3};
            setup.ground = 30;
            setup.followed = 0;
            setup.change = [car](SpaceScene& moved, const Settings& now, Real) {
                push_struts(moved, car, now.h);
            };
            setup.measure = [car](const SpaceState& s) -> std::vector<Real> {
                Real pressed = 0;
                for (const SpaceJoint& joint : s.scene.joints)
                    pressed += coordinate_of(frames_of(s.scene.bodies.x, joint),
                                             joint, along_y)
                                   .C /
                               4;
                return {s.scene.bodies.u[0], car.speed, pressed, car.sink,
                        largest_joint_error(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back({"speed", "m/s", "that the motors drive at", 5, -10,
                              20, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"torque", "N m", "of each motor", 120, 0, 1000,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"sink", "cm", "of the struts under its weight", 8, 4,
                              15, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"bumps", "", "across its way", 6, 0, 12,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"bump", "cm", "height of a bump", 6, 1, 20,
                              Numbers::real, OnChange::restarts});
    add_touch_tunables(scene, 0.8, 100);
    scene.columns = {
        {"speed", "m/s", "of the car", Plot::linear},
        {"speed_exact", "m/s", "of the motors"},
        {"pressed", "m", "struts, on average", Plot::linear},
        {"pressed_exact", "m", "m g over 4 k"},
        {"joint_error", "m", "largest of a locked coordinate", Plot::logarithmic}};
    return scene;
}

inline Demo pour_scene()
{
    Demo scene = poured_demo<SpaceScene, SpaceSteps>(
        "pour", "Hundreds of solids fall into a wide pit", 8, 300, 1000);
    scene.tunables.push_back({"parts", "", "of a step that look for contacts", 1, 1,
                              64, Numbers::whole});
    return scene;
}

}  // namespace rigid
