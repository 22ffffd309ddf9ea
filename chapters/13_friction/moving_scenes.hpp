/// \file moving_scenes.hpp
/// Scenes that friction keeps busy: a run of dominoes, the break of a pool game, a wall of bricks and a ball, rubble that falls.
#pragma once

#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/13_friction/friction_solver.hpp"
#include "common/random.hpp"

namespace rigid {

//! [dominoes]
/// Dominoes of 1 m by 0.15 m in a row on a floor, the first of them pushed.
/// \param gap      between two of them [m]
/// \param floor    μ of a foot on the floor
/// \param between  μ of two dominoes
struct Domino {
    static constexpr Real height = 1, thickness = 0.15;
};
inline RoughScene domino_run(int count, Real gap, Real floor, Real between)
{
    RoughScene scene;
    scene.walls.push_back({{0, 1}, 0});
    for (int i = 0; i < count; ++i)
        add_body(scene, box(Domino::thickness, Domino::height),
                 1 / (Domino::thickness * Domino::height),
                 {i * (gap + Domino::thickness), Domino::height / 2});
    cover(scene, {between, 0, 0, 0});
    // √(μ_a μ_b) of a foot is `floor`
    scene.wall_surfaces[0].friction = floor * floor / between;
    // about its lower right corner
    const Real spin = -1.0;
    scene.bodies.velocity(0) << -spin * Domino::height / 2,
        spin * -Domino::thickness / 2, spin;
    return scene;
}
//! [dominoes]

//! [throw]
/// What two equal discs give each other when they graze: P_n along the line of
/// centres, P_t across it, (13.18) [N s].
/// \param closing, sliding  speeds of their surfaces before it, along and across
/// \param kappa             I / (m r²)
struct Throw {
    Real normal, tangent;
};
inline Throw throw_by_hand(Real mass, Real kappa, Real closing, Real sliding,
                           Real mu, Real e)
{
    const Real normal = mass * (1 + e) * closing / 2;
    const Real sticking = mass * sliding / (2 * (1 + 1 / kappa));
    return {normal, std::clamp(sticking, -mu * normal, mu * normal)};
}
//! [throw]

/// A pool table from above: fifteen balls of 57 mm in a triangle, and one that comes from the left.
/// \param spin  of that one [rad/s]
inline RoughScene pool_break(Real speed, Real spin, Real mu, Real cloth)
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

/// A wall of bricks of 0.5 m by 0.25 m, a heavy ball in front of it.
inline RoughScene brick_wall(int rows, int columns, Real mu, Real speed)
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

/// Discs, boxes, capsules and triangles of random size, place and velocity above a trough.
inline RoughScene random_heap(Random& random, int bodies, Real mu)
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
