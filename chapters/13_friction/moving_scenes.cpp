// The functions of moving_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/13_friction/moving_scenes.hpp"

namespace rigid {

RoughScene pool_break(Real speed, Real spin, Real mu, Real cloth)
{
    const Real r = 0.0286, mass = 0.17;
    RoughScene scene;
    scene.gravity = {0, 0};
    scene.walls = {
        {{1, 0}, -1.27}, {{-1, 0}, -1.27}, {{0, 1}, -0.635}, {{0, -1}, -0.635}};
    const Mass ball{mass, {0, 0}, 0.4 * mass * r * r};
    add_body(scene, disc(r), ball, {-0.7, 0.004});
    scene.bodies.velocity(0) << speed, 0, spin;
    for (int row = 0; row < 5; ++row)
        for (int i = 0; i <= row; ++i)
            add_body(scene, disc(r), ball,
                     {0.635 + row * std::sqrt(3.0) * r * 1.0001,
                      (2 * i - row) * r * 1.0001});
    cover(scene, {mu, 0.9, 0, 0});
    scene.cloth = {cloth, 9.81, 0.3 * r};
    return scene;
}

RoughScene brick_wall(int rows, int columns, Real mu, Real speed)
{
    RoughScene scene;
    scene.walls.push_back({{0, 1}, 0});
    const Real length = 0.5, height = 0.25;
    for (int row = 0; row < rows; ++row) {
        const bool shifted = row % 2 == 1;
        for (int i = 0; i < columns; ++i) {
            const Real x = (i + (shifted ? 0.5 : 0)) * (length + 0.002);
            // half bricks at the ends
            const bool half = shifted && i + 1 == columns;
            add_body(scene, box(half ? length / 2 : length, height), 10,
                     {half ? x - length / 4 : x, height * (row + 0.5)});
        }
        if (shifted)
            add_body(scene, box(length / 2, height), 10,
                     {-length / 4, height * (row + 0.5)});
    }
    const Index ball =
        add_body(scene, disc(0.4), 40, {-2.5, 0.6 * rows * height}, 0);
    scene.bodies.velocity(ball) << speed, 0, 0;
    cover(scene, {mu, 0, 0, 0});
    return scene;
}

RoughScene random_heap(Random& random, int bodies, Real mu)
{
    RoughScene scene;
    scene.walls = {{{0, 1}, 0}, {Vec2(0.8, 0.6), -0.8}, {Vec2(-0.8, 0.6), -0.8}};
    for (int k = 0; k < bodies; ++k) {
        const Real size = random.uniform(0.2, 0.5), slim = random.uniform(0.3, 1),
                   left = random.uniform(-0.1, 0.1), angle = random.uniform(0, 6),
                   density = random.uniform(0.5, 5);
        Polygon shape = disc(size / 2);
        if (k % 4 == 1) shape = box(size, slim * size);
        if (k % 4 == 2) shape = capsule(size, slim * size / 4);
        if (k % 4 == 3) {
            shape = {{{0, 0}, {size, 0}, {slim * size, size}}, 0};
            for (Vec2& vertex : shape.vertices)
                vertex -= Vec2((1 + slim) / 3, 1.0 / 3) * size;
        }
        const Vec2 at((k % 3 - 1) * 0.95 + left, 0.9 + 0.95 * (k / 3));
        const Index body = add_body(scene, shape, density, at, angle);
        for (Index d = 0; d < 3; ++d)
            scene.bodies.u[3 * body + d] = 2 * random.uniform(-1, 1);
    }
    cover(scene, {mu, 0, 0, 0});
    return scene;
}

}  // namespace rigid
