/// \file mesh_demo.hpp
/// A car and balls on hills of triangles.
#pragma once

#include "chapters/24_friction_is_a_disc/program/touch_scenes.hpp"
#include "chapters/25_world_in_space/car.hpp"
#include "chapters/25_world_in_space/mesh_scenes.hpp"
#include "chapters/25_world_in_space/program/space_run.hpp"

namespace rigid {

inline Demo hills_scene()
{
    Demo scene = space_demo(
        "hills", "A car drives over hills of triangles, balls roll down them",
        {{0, 0}, {6.6, 4.4}}, 1.0 / 240,
        {"cone", "one_by_one", "box", "exact_cone"}, [](const Settings& settings) {
            SpaceSetup setup;
            Car car;
            car.speed = settings["speed"];
            setup.scene = car_on_hills(car, settings["height"], settings["mu"],
                                       static_cast<int>(settings["balls"]));
            setup.camera = {{0.6, 0.6, 0}, 15, 0.6, 0.4};
            setup.skin = Skin::opaque;
            setup.followed = 0;
            setup.change = [car](SpaceScene& moved, const Settings& now, Real) {
                push_struts(moved, car, now.h);
            };
            setup.measure = [](const SpaceState& s) -> std::vector<Real> {
                return {s.scene.bodies.u[0], s.scene.bodies.x[1],
                        static_cast<Real>(s.now.contacts.size()),
                        deepest_overlap(s.now)};
            };
            return setup;
        });
    scene.tunables.push_back({"speed", "m/s", "that the motors drive at", 4, -10,
                              20, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"height", "m", "of the hills", 0.5, 0, 2,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"balls", "", "on the hills", 12, 0, 40,
                              Numbers::whole, OnChange::restarts});
    add_touch_tunables(scene, 0.8, 100);
    scene.columns = {{"speed", "m/s", "of the car", Plot::linear},
                     {"car_height", "m", "of its middle", Plot::linear},
                     {"contacts", "", "points where solids touch", Plot::linear},
                     {"overlap", "m", "the deepest", Plot::linear}};
    return scene;
}

}  // namespace rigid
