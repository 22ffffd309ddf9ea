/// \file solid_scenes.hpp
/// The scenes of solids that touch: a block that slides, a stack of boxes, a heap; with what is known of them by hand.
#pragma once

#include "chapters/18_space/convex_hull.hpp"
#include "chapters/18_space/space_scene.hpp"
#include "common/elementary.hpp"
#include "common/random.hpp"

namespace rigid {

/// A floor at height zero, and the same μ for it and for all bodies that there are.
inline void add_floor(SpaceScene& scene, Real mu)
{
    scene.walls.push_back({{0, 1, 0}, 0});
    scene.wall_friction.assign(scene.walls.size(), mu);
    scene.friction.assign(scene.shapes.size(), mu);
}

//! [slide]
/// A flat block of 1 kg on a floor, 1 × 0.2 × 1 m, that slides.
/// \param direction  of its velocity, from x towards −z [rad]
inline SpaceScene sliding_block(Real speed, Real direction, Real mu)
{
    SpaceScene scene;
    const Vec3 size(1, 0.2, 1);
    add_body(scene, {solid_box(size)}, 1 / size.prod(), {0, size.y() / 2, 0});
    scene.bodies.u.head<3>() = speed * Vec3(cos(direction), 0, -sin(direction));
    add_floor(scene, mu);
    return scene;
}

/// How far it slides: v²/(2 μ g) − h v/2, (18.41).
inline Real stopping_distance(Real speed, Real mu, Real h, Real g = 9.81)
{
    return speed * speed / (2 * mu * g) - h * speed / 2;
}
//! [slide]

/// A block on a slope: gravity leans by `degrees` towards the direction, counted as above.
inline SpaceScene block_on_slope(Real degrees, Real direction, Real mu)
{
    SpaceScene scene = sliding_block(0, 0, mu);
    const Real a = degrees * pi / 180;
    scene.gravity =
        9.81 * Vec3(sin(a) * cos(direction), -cos(a), -sin(a) * sin(direction));
    return scene;
}

/// A ball of radius ½ m on a floor, at the speed v₀ without spin.
inline SpaceScene thrown_ball(Real speed, Real mu)
{
    SpaceScene scene;
    add_body(scene, {solid_ball(0.5)}, 1.0, {0, 0.5, 0});
    scene.bodies.u[0] = speed;
    add_floor(scene, mu);
    return scene;
}

/// Cubes of 1 m, one on the other, each turned a little against the one below.
inline SpaceScene box_stack(int boxes, Real turn, Real mu)
{
    SpaceScene scene;
    for (int i = 0; i < boxes; ++i)
        add_body(scene, {solid_box({1, 1, 1})}, 1000.0, {0, i + 0.5, 0},
                 {0, i * turn, 0});
    add_floor(scene, mu);
    return scene;
}

//! [heap]
/// Balls, capsules, boxes and hulls of about half a metre, in layers of side² above
/// a pit with sloping sides.
inline SpaceScene mixed_heap(int bodies, Real mu, std::uint64_t seed, int side = 3)
{
    SpaceScene scene;
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
