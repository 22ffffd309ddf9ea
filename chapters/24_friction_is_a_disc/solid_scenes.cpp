// The functions of solid_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"

namespace rigid {

RoughSolids block_on_slope(Real degrees, Real direction, Real mu)
{
    RoughSolids scene = sliding_block(0, 0, mu);
    const Real a = degrees * pi / 180;
    scene.gravity =
        9.81 * Vec3(sin(a) * cos(direction), -cos(a), -sin(a) * sin(direction));
    return scene;
}

RoughSolids thrown_ball(Real speed, Real mu)
{
    RoughSolids scene;
    add_body(scene, {solid_ball(0.5)}, 1.0, {0, 0.5, 0});
    scene.bodies.u[0] = speed;
    add_floor(scene, mu);
    return scene;
}

RoughSolids box_stack(int boxes, Real turn, Real mu)
{
    RoughSolids scene;
    for (int i = 0; i < boxes; ++i)
        add_body(scene, {solid_box({1, 1, 1})}, 1000.0, {0, i + 0.5, 0},
                 {0, i * turn, 0});
    add_floor(scene, mu);
    return scene;
}

//! [heap]
RoughSolids mixed_heap(int bodies, Real mu, std::uint64_t seed, int side)
{
    if (side < 1)
        throw std::invalid_argument("a heap has layers of " + std::to_string(side) +
                                    " by as many bodies; it must be 1 or more");
    RoughSolids scene;
    Random random(seed);
    const auto draw = [&random](Real low, Real high) {
        const Real x = random.uniform(low, high), y = random.uniform(low, high),
                   z = random.uniform(low, high);
        return Vec3(x, y, z);
    };
    for (int i = 0; i < bodies; ++i) {
        Hull hull;
        if (i % 4 == 0) hull = solid_box(draw(0.3, 0.6));
        if (i % 4 == 1) hull = solid_ball(random.uniform(0.2, 0.3));
        if (i % 4 == 2) hull = solid_capsule(0.4, random.uniform(0.12, 0.2));
        if (i % 4 == 3) {
            std::vector<Vec3> points;
            for (int k = 0; k < 12; ++k)
                points.push_back(0.3 * draw(-1, 1).normalized());
            hull = solid_hull(points);
        }
        const Real middle = (side - 1) / 2.0;
        const Vec3 place(i % side - middle, i / (side * side),
                         i / side % side - middle),
            shift = draw(-0.05, 0.05);
        add_body(scene, {hull}, 1000.0, 0.8 * place + shift + Vec3(0, 1.2, 0),
                 draw(-1.5, 1.5));
    }
    const Real c = std::sqrt(0.5), d = c * (1 + 0.4 * (side - 3));
    scene.walls = {{{0, 1, 0}, 0},
                   {{c, c, 0}, -d},
                   {{-c, c, 0}, -d},
                   {{0, c, c}, -d},
                   {{0, c, -c}, -d}};
    scene.wall_friction.assign(scene.walls.size(), mu);
    scene.friction.assign(scene.shapes.size(), mu);
    return scene;
}
//! [heap]

}  // namespace rigid
