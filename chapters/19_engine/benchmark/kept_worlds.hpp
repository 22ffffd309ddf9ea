/// \file kept_worlds.hpp
/// Worlds whose motion is known: what swings or spins on joints and touches nothing, what bounces, what slides.
///
/// Nothing of it damps: no spring, no drag; friction only where a box slides or stands on a platform.
#pragma once

#include "chapters/14_joints/bar_linkages.hpp"
#include "chapters/19_engine/benchmark/kept_motion.hpp"
#include "chapters/19_engine/world_scenes.hpp"

#include <algorithm>
#include <utility>

namespace rigid::kept {

/// Rods of 1 m and 1 kg in a row from a pin, at rest.
/// \param angles  from straight down [rad]
inline JointedScene rods(const std::vector<Real>& angles)
{
    JointedScene scene;
    Vec2 end(0, 0);
    for (const Real angle : angles) {
        const Vec2 next = end + Vec2(rigid::sin(angle), -rigid::cos(angle));
        const Index k = add_bar(scene, end, next, 1);
        pin(scene, k - 1, k, end);
        end = next;
    }
    return scene;
}

/// One body of 1 kg on a pin of the world.
inline JointedScene on_a_pin(const Polygon& shape, Real inertia, const Vec2& at,
                             Real spin)
{
    JointedScene scene;
    const Index k = add_body(scene, shape, Mass{1, {0, 0}, inertia}, at);
    scene.bodies.velocity(k) << spin * perpendicular(at), spin;
    pin(scene, world, k, {0, 0});
    return scene;
}

/// A load half a metre below 0.1 kg half a metre below a hook, on two joints of a kind; pins hold two rods of 0.1 kg.
inline JointedScene beads(JointKind kind, Real load)
{
    JointedScene scene;
    const Vec2 along = Vec2(0.01, -0.5), end = 2 * along;
    const Mass heavy{load, {0, 0}, 0.02 * load};
    if (kind == JointKind::revolute) {
        const Index a = add_bar(scene, {0, 0}, along, 0.1),
                    b = add_bar(scene, along, end, 0.1),
                    c = add_body(scene, disc(0.2), heavy, end);
        pin(scene, world, a, {0, 0}), pin(scene, a, b, along);
        pin(scene, b, c, end);
        return scene;
    }
    RigidJoint joint;
    joint.kind = kind;
    joint.length = along.norm();
    joint.b = add_body(scene, disc(0.05), Mass{0.1, {0, 0}, 1e-3}, along);
    add_joint(scene, joint);
    joint.a = joint.b;
    joint.b = add_body(scene, disc(0.2), heavy, end);
    add_joint(scene, joint);
    return scene;
}

/// Two boxes of 1 × 0.2 m, welded end to end, that spin without weight.
inline World welded_world(Real spin)
{
    WorldSettings weightless;
    weightless.gravity = {0, 0};
    World made(weightless);
    BodyId both[2];
    for (const int i : {0, 1}) {
        BodyDefinition half = body_of(box(1, 0.2), {i - 0.5, 0});
        half.velocity = {0, spin * (i - 0.5)};
        half.spin = spin;
        half.filter = meets_no_twin;
        both[i] = made.add_body(half);
    }
    made.add_joint(both[0], both[1],
                   made.joint_at(JointKind::weld, both[0], both[1], {0, 0}));
    return made;
}

/// Five balls of 0.2 m on rods of 1.5 m without mass, 1 mm apart, the first one drawn aside.
inline World cradle_world()
{
    World made;
    for (int i = 0; i < 5; ++i) {
        const Real x = 0.401 * i, swing = i == 0 ? -0.8 : 0;
        BodyDefinition ball =
            body_of(disc(0.2),
                    {x + 1.5 * rigid::sin(swing), -1.5 * rigid::cos(swing)}, swing);
        ball.mass = Mass{1, {0, 0}, 0.02};
        ball.surface = {0, 1, 0, 0};
        RigidJoint rod;
        rod.at_a = {x, 0}, rod.at_b = {0, 1.5};
        made.add_joint({}, made.add_body(ball), rod);
    }
    return made;
}

/// Bodies one above the other over a floor, the lowest a fall above it, a gap between two.
inline World falling_world(const std::vector<std::pair<Polygon, Real>>& shapes,
                           Real fall, Real gap, Real e)
{
    World made;
    BodyDefinition ground = body_of(box(20, 1), {0, -0.5}, 0, 0);
    ground.surface = {0, e, 0, 0};
    made.add_body(ground);
    Real y = fall;
    for (const auto& [shape, mass] : shapes) {
        const Real half =
            -box_of(PlacedShape(shape, Vec<3>::Zero()).view()).low.y();
        BodyDefinition body = body_of(shape, {0, y + half});
        body.mass = Mass{mass,
                         {0, 0},
                         mass_of(shape, 1).inertia * mass / mass_of(shape, 1).mass};
        body.surface = ground.surface;
        made.add_body(body);
        y += 2 * half + gap;
    }
    return made;
}

/// What slides to the right over two floors: μ is 0.5 left of the origin and 0.1 right of it.
/// \param bevel  how far each floor goes down within a metre behind the seam, below the other one; 0: flush boxes, whose
///               edges may catch [m]
inline World seam_world(const Polygon& shape, const Mass& mass, const Vec2& from,
                        Real speed, Real bevel)
{
    World made;
    for (const Real side : {-1.0, 1.0}) {
        Polygon floor{{{-side, -bevel},
                       {0, 0},
                       {20 * side, 0},
                       {20 * side, -1},
                       {-side, -1}}};
        if (bevel == 0)
            floor.vertices = {{0, -1}, {0, 0}, {20 * side, 0}, {20 * side, -1}};
        if (side > 0) std::ranges::reverse(floor.vertices);
        const Vec2 middle = mass_of(floor, 1).centroid;
        BodyDefinition ground = body_of(floor, middle, 0, 0);
        const Real mu = side < 0 ? 0.5 : 0.1;
        ground.surface = {mu * mu, 0, 0, 0};  // of two, the root of the product
        made.add_body(ground);
    }
    BodyDefinition sled = body_of(shape, from);
    sled.mass = mass;
    sled.velocity = {speed, 0};
    sled.surface = {1, 0, 0, 0};
    made.add_body(sled);
    return made;
}

/// A box on a platform whose velocity is raised before each step.
inline World platform_world(Real acceleration)
{
    World made;
    BodyDefinition platform = body_of(box(8, 0.5), {0, -0.25}, 0, 0),
                   load = body_of(box(0.5, 0.5), {0, 0.25});
    platform.velocity = load.velocity = {acceleration * frame, 0};
    made.add_body(platform);
    made.add_body(load);
    return made;
}

}  // namespace rigid::kept
