/// \file moving_worlds.hpp
/// Worlds to look at and to measure: what falls, what is poured, what turns, what is shot.
#pragma once

#include "chapters/13_friction/moving_scenes.hpp"
#include "chapters/14_joints/ragdoll.hpp"
#include "chapters/19_engine/world_scenes.hpp"
#include "common/elementary.hpp"

namespace rigid {

/// Dolls that fall down a staircase.
inline World dolls_world(int dolls)
{
    World made;
    JointedScene stairs;
    add_stairs(stairs, 8);
    cover(stairs, {0.6, 0, 0, 0});
    put_in(made, stairs);
    for (int i = 0; i < dolls; ++i) {
        JointedScene doll;
        add_ragdoll(doll, {-0.1 + 0.15 * (i % 3), 3.5 + 1.8 * i});
        cover(doll, {0.6, 0, 0, 0});
        for (Index k = 0; k < 10; ++k) doll.bodies.velocity(k)[0] = 0.8;
        put_in(made, doll, {1, 0xffff'ffff, -1 - i % 50});
    }
    return made;
}

/// Boxes and discs that are poured into a trough.
/// \param rolling  resistance of the discs [m]
inline World poured_world(int bodies, Real rolling = 0)
{
    World made;
    const int wide = width_of_pour(bodies);
    for (const HalfSpace& wall : trough_of_pour(wide)) made.add_wall(wall);
    for (int i = 0; i < bodies; ++i) {
        const PouredBody it(i, wide);
        BodyDefinition body = body_of(it.shape, it.at, it.angle);
        if (it.rolls) body.surface.rolling = rolling;
        made.add_body(body);
    }
    return made;
}

/// A drum of four walls that turns, with boxes in it.
inline World tumbler_world(int bodies, Real spin)
{
    World made;
    const Vec2 sides[] = {{0, -2.1}, {0, 2.1}, {-2.1, 0}, {2.1, 0}};
    for (const Vec2& side : sides) {
        // about one centre: each wall has the velocity that goes with its place
        BodyDefinition wall = body_of(
            box(side.x() == 0 ? 4.4 : 0.2, side.x() == 0 ? 0.2 : 4.4), side, 0, 0);
        wall.filter = meets_no_twin;
        wall.velocity = spin * perpendicular(side);
        wall.spin = spin;
        made.add_body(wall);
    }
    for (int i = 0; i < bodies; ++i)
        made.add_body(body_of(box(0.25, 0.25),
                              {-1.2 + 0.35 * (i % 8), -1.2 + 0.35 * (i / 8)}));
    return made;
}

/// The walls of a drum go on along a circle: in a step each moves along the chord to where it is to be.
inline void turn_tumbler(World& made, Real spin, Real h)
{
    const Real c = cos(spin * h), s = sin(spin * h);
    const std::vector<BodyId> all = made.bodies();
    for (std::size_t i = 0; i < 4 && i < all.size(); ++i) {
        const Vec2 p = made.position(all[i]);
        const Vec2 next(c * p.x() - s * p.y(), s * p.x() + c * p.y());
        made.set_velocity(all[i], (next - p) / h, spin);
    }
}

/// Many small piles, far from each other.
inline World piles_world(int piles)
{
    World made;
    made.add_wall({{0, 1}, 0});
    for (int p = 0; p < piles; ++p)
        for (int i = 0; i < 5; ++i)
            made.add_body(body_of(box(0.5, 0.5), {2.0 * p, 0.25 + 0.5 * i}));
    return made;
}

/// Dominoes, the first of them pushed.
inline World domino_world(int count)
{
    World made;
    put_in(made, domino_run(count, 0.5, 0.6, 0.2));
    return made;
}

/// A wall of bricks and a ball of iron.
inline World bricks_world(int rows, int columns)
{
    World made;
    put_in(made, brick_wall(rows, columns, 0.6, 8));
    return made;
}

/// An arch of stones.
inline World arch_world(int stones)
{
    World made;
    put_in(made, stone_arch(stones, 0.2, 0.7));
    return made;
}

/// A ball of iron on a chain that swings into a wall of bricks.
inline World wrecker_world(int rows)
{
    World made;
    made.add_wall({{0, 1}, 0});
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < 3; ++i)
            made.add_body(body_of(box(0.5, 0.3),
                                  {0.51 * i + 0.25 * (row % 2), 0.15 + 0.3 * row}));
    constexpr int links = 8;
    const Vec2 hook(-1, 5);
    BodyId last;
    for (int i = 0; i < links; ++i) {  // pulled back to the left, level
        const Vec2 at = hook - Vec2(0.4 * i, 0);
        BodyDefinition link =
            body_of(box(0.4, 0.05, 0.01), at - Vec2(0.2, 0), 0, 40);
        link.filter = meets_no_twin;
        const BodyId id = made.add_body(link);
        made.add_joint(last, id, made.joint_at(JointKind::revolute, last, id, at));
        last = id;
    }
    const Vec2 end = hook - Vec2(0.4 * links, 0);
    BodyDefinition iron = body_of(disc(0.5), end, 0, 60);
    iron.filter = meets_no_twin;  // the chain ends inside it
    const BodyId ball = made.add_body(iron);
    made.add_joint(last, ball, made.joint_at(JointKind::revolute, last, ball, end));
    return made;
}

/// A plank on a pin, light boxes at one end, and a heavy one that falls on the other.
inline World seesaw_world(Real ratio)
{
    World made;
    made.add_wall({{0, 1}, 0});
    const BodyId plank = made.add_body(body_of(box(5, 0.1), {0, 0.6}));
    RigidJoint pin = made.joint_at(JointKind::revolute, {}, plank, {0, 0.6});
    pin.lower = -0.2, pin.upper = 0.2;
    made.add_joint({}, plank, pin);
    for (int i = 0; i < 3; ++i)
        made.add_body(body_of(box(0.4, 0.4), {-2.2, 0.85 + 0.4 * i}));
    made.add_body(body_of(box(0.8, 0.8), {2, 4.5}, 0, ratio / 4));
    return made;
}

/// Rubble in a trough.
inline World rubble_world(int bodies, std::uint64_t seed)
{
    World made;
    Random random(seed);
    put_in(made, random_heap(random, bodies, 0.5));
    return made;
}

/// A cart on two sprung rollers with tracks, on a ground of many edges.
inline World cart_world()
{
    World made;
    std::vector<Vec2> ground;
    for (int i = 60; i >= -10; --i)
        ground.push_back({0.5 * i, 0.35 * sin(0.45 * i) + 0.1 * sin(1.3 * i)});
    made.add_chain(ground, false, {0.9, 0, 0, 0});
    const BodyId cart =
        made.add_body(body_of(box(1.6, 0.3, 0.05), {0, 1.6}, 0, 30));
    for (const Real side : {-0.6, 0.6}) {
        BodyDefinition wheel = body_of(disc(0.3), {side, 1.2}, 0, 20);
        wheel.surface = {0.9, 0, 3, 0};  // tracks run round it
        const BodyId id = made.add_body(wheel);
        RigidJoint axle = made.joint_at(JointKind::wheel, cart, id, {side, 1.2});
        axle.axis = {0, 1};
        axle.spring.stiffness = 4000;
        axle.spring.damping = 300;
        made.add_joint(cart, id, axle);
    }
    return made;
}

/// Balls of two kinds, a ledge for each, and a gate that sees what comes through.
inline World gates_world()
{
    World made;
    made.add_wall({{0, 1}, -3});
    for (int kind = 0; kind < 2; ++kind) {
        BodyDefinition ledge =
            body_of(box(4, 0.2), {-2.0 + 4 * kind, 1}, kind ? -0.3 : 0.3, 0);
        ledge.filter = {4u << kind, 1u << kind, 0};
        made.add_body(ledge);
    }
    for (int i = 0; i < 16; ++i) {
        BodyDefinition ball =
            body_of(disc(0.2), {-3.0 + 0.4 * i, 3 + 0.3 * (i % 3)});
        ball.filter.category = i % 2 ? 2 : 1;
        made.add_body(ball);
    }
    BodyDefinition gate = body_of(box(6, 0.5), {0, -1}, 0, 0);
    gate.sensor = true;
    made.add_body(gate);
    return made;
}

/// Bullets against thin walls.
inline World bullets_world()
{
    World made;
    made.add_wall({{0, 1}, 0});
    made.add_body(body_of(box(0.05, 4), {4, 2}, 0, 0));
    for (int i = 0; i < 8; ++i)
        made.add_body(body_of(box(0.05, 0.5), {2, 0.25 + 0.5 * i}, 0, 10));
    for (int i = 0; i < 5; ++i) {
        BodyDefinition bullet = body_of(disc(0.05), {-3.0 - 3 * i, 0.5 + 0.6 * i});
        bullet.velocity = {150, 0};
        bullet.bullet = true;
        made.add_body(bullet);
    }
    return made;
}

}  // namespace rigid
