// The functions of stacks.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/12_contact_manifolds/stacks.hpp"

namespace rigid {

RigidScene box_over_an_end()
{
    RigidScene scene;
    scene.gravity = {0, -10};
    add_body(scene, box(4, 2), Mass{}, {0, 0});
    add_body(scene, box(2, 1), 1.5, {1.5, 1.49});
    return scene;
}

RigidScene box_stack(int boxes, Real width)
{
    RigidScene scene;
    scene.walls.push_back({{0, 1}, 0});
    for (int i = 0; i < boxes; ++i)
        add_body(scene, box(width, 1), 1 / width, {0, 0.5 + i});
    return scene;
}

RigidScene box_pyramid(int base)
{
    RigidScene scene;
    scene.walls.push_back({{0, 1}, 0});
    for (int row = 0; row < base; ++row)
        for (int i = 0; i < base - row; ++i)
            add_body(scene, box(1, 1), 1,
                     {1.05 * (i - 0.5 * (base - row - 1)), 0.5 + row});
    return scene;
}

RigidScene overhang(int blocks, Real part)
{
    RigidScene scene;
    add_body(scene, box(4, 1), Mass{}, {-2, -0.5});
    Real x = -0.5;
    for (int k = blocks; k >= 1; --k) {
        x += part / (2 * k);
        add_body(scene, box(1, 0.25), 4, {x, 0.125 + 0.25 * (blocks - k)});
    }
    return scene;
}

RigidScene block_on_floor(Real half_width, Real half_height, Real tilt, bool held)
{
    RigidScene scene;
    scene.walls.push_back({{0, 1}, 0});
    const Real c = cos(tilt), s = sin(tilt);
    add_body(scene, box(2 * half_width, 2 * half_height), 1,
             {-s * half_height, s * half_width + c * half_height}, tilt);
    if (held) {
        PointJoint rail;
        rail.measure = PointJoint::Measure::along;
        rail.at_b = {0, -half_height};
        scene.joints.push_back(rail);
    }
    return scene;
}

RigidScene roller(int corners, Real speed)
{
    RigidScene scene;
    scene.walls.push_back({{0, 1}, 0});
    Polygon shape;
    for (int i = 0; i < corners; ++i) {
        const Real angle = 2 * pi * (i + 0.5) / corners - pi / 2;
        shape.vertices.push_back({cos(angle), sin(angle)});
    }
    add_body(scene, shape, 1, {0, cos(pi / corners)});
    add_turning_motor(scene, world, 0, speed, 1000);
    return scene;
}

RigidScene bullet(const Polygon& shape, Real angle, Real spin)
{
    RigidScene scene;
    scene.gravity = {0, 0};
    add_body(scene, box(0.01, 20), Mass{}, {0, 0});
    add_body(scene, shape, Mass{0.01, {0, 0}, 1e-6}, {-3, 0}, angle);
    scene.bodies.velocity(1) << 300 * cos(angle), 300 * sin(angle), spin;
    return scene;
}

RigidScene pile(int bodies)
{
    RigidScene scene;
    add_body(scene, box(8, 1), Mass{}, {0, -0.5});
    add_body(scene, box(1, 8), Mass{}, {-4, 4}, 0.2);
    add_body(scene, box(1, 8), Mass{}, {4, 4}, -0.2);
    for (int i = 0; i < bodies; ++i) {
        const Vec2 at((i % 7 - 3) * 0.9 + 0.1 * (i / 7 % 3), 1 + i / 7 * 0.9);
        Polygon shape = disc(0.3);
        if (i % 4 == 1) shape = box(0.7, 0.4);
        if (i % 4 == 2) shape = capsule(0.4, 0.15);
        if (i % 4 == 3) {
            shape = {{}, 0.05};
            for (int k = 0; k < 5; ++k)
                shape.vertices.push_back(
                    0.3 * Vec2(cos(0.4 * pi * k), sin(0.4 * pi * k)));
        }
        add_body(scene, shape, 1, at, 0.3 * i);
    }
    return scene;
}

}  // namespace rigid
