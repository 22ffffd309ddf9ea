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
/// centres, P_t across it, (13.21) [N s].
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
RoughScene pool_break(Real speed, Real spin, Real mu, Real cloth);

/// A wall of bricks of 0.5 m by 0.25 m, a heavy ball in front of it.
RoughScene brick_wall(int rows, int columns, Real mu, Real speed);

/// Discs, boxes, capsules and triangles of random size, place and velocity above a trough.
RoughScene random_heap(Random& random, int bodies, Real mu);

}  // namespace rigid
