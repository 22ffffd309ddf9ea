// The functions of mesh_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/mesh_scenes.hpp"

namespace rigid {

SpaceScene car_on_hills(const Car& car, Real height, Real mu, int balls)
{
    // level where the car stands, then waves of 6 m along the track and of 8 m across
    // it; sides that keep all of it in
    const auto ground = [height](Real x, Real z) {
        const Real wave = x < 2.5 ? 0
                                  : height / 2 * (1 - cos(2 * pi * (x - 2.5) / 6)) *
                                        (1 + 0.5 * sin(2 * pi * (z + x / 2) / 8));
        return wave + std::max({Real{0}, std::abs(z) - 3.5, std::abs(x) - 19});
    };
    SpaceScene scene = car_on_floor(car, mu);
    const auto mesh = height_field(42, 8, 1, ground);
    for (int i = 0; i < balls; ++i) {
        const Real x = 4 + 15.0 * i / std::max(balls, 1),
                   z = i % 2 == 0 ? 2.4 : -2.4;
        add_body(scene, {solid_ball(0.3)}, 300.0, {x, ground(x, z) + 0.6, z});
    }
    add_ground(scene, mesh, mu);
    return scene;
}

}  // namespace rigid
