/// \file solid_scenes.hpp
/// The scenes of solids that touch: a block that slides, a stack of boxes, a heap; with what is known of them by hand.
#pragma once

#include "chapters/22_distance_of_solids/convex_hull.hpp"
#include "chapters/24_friction_is_a_disc/rough_solids.hpp"
#include "common/elementary.hpp"
#include "common/random.hpp"

namespace rigid {

/// A floor at height zero, and the same μ for it and for all bodies that there are.
inline void add_floor(RoughSolids& scene, Real mu)
{
    scene.walls.push_back({{0, 1, 0}, 0});
    scene.wall_friction.assign(scene.walls.size(), mu);
    scene.friction.assign(scene.shapes.size(), mu);
}

/// μ of the bodies from `first` on. Where nothing had friction, those before have none.
inline void give_friction(RoughSolids& scene, Index first, Real mu)
{
    scene.friction.resize(static_cast<std::size_t>(first), 0);
    scene.friction.resize(scene.shapes.size(), mu);
}

//! [slide]
/// A flat block of 1 kg on a floor, 1 × 0.2 × 1 m, that slides.
/// \param direction  of its velocity, from x towards −z [rad]
inline RoughSolids sliding_block(Real speed, Real direction, Real mu)
{
    RoughSolids scene;
    const Vec3 size(1, 0.2, 1);
    add_body(scene, {solid_box(size)}, 1 / size.prod(), {0, size.y() / 2, 0});
    scene.bodies.u.head<3>() = speed * Vec3(cos(direction), 0, -sin(direction));
    add_floor(scene, mu);
    return scene;
}

/// How far it slides: v²/(2 μ g) − h v/2, (24.5).
inline Real stopping_distance(Real speed, Real mu, Real h, Real g = 9.81)
{
    return speed * speed / (2 * mu * g) - h * speed / 2;
}
//! [slide]

/// A block on a slope: gravity leans by `degrees` towards the direction, counted as above.
RoughSolids block_on_slope(Real degrees, Real direction, Real mu);

/// A ball of radius ½ m on a floor, at the speed v₀ without spin.
RoughSolids thrown_ball(Real speed, Real mu);

/// Cubes of 1 m, one on the other, each turned a little against the one below.
RoughSolids box_stack(int boxes, Real turn, Real mu);

/// Balls, capsules, boxes and hulls of about half a metre, in layers of side² above
/// a pit with sloping sides. \throws std::invalid_argument  for a side below 1
RoughSolids mixed_heap(int bodies, Real mu, std::uint64_t seed, int side = 3);

}  // namespace rigid
