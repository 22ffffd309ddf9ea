/// \file hung_scenes.hpp
/// What hangs: Newton's cradle, and chains of plates on hinges or with a heavy end; with what is known of them by hand.
#pragma once

#include "chapters/18_space/joint_makers.hpp"
#include "common/elementary.hpp"

namespace rigid {

/// A thin rod between two points, both in the axes of a shape.
inline Hull rod_between(const Vec3& from, const Vec3& to, Real radius)
{
    return {{from, to}, {}, radius};
}

/// Balls of 1 kg that hang side by side, each on a rod of 1 m without mass, which a
/// hinge holds.
struct Cradle {
    int balls = 5;
    int lifted = 1;      ///< so many of them to the left
    Real lift = 0.5;     ///< [rad]
    Real gap = 0.002;    ///< between two that hang at rest [m]
    Real radius = 0.06;  ///< [m]
    Real length = 1;     ///< of a rod [m]
};

inline SpaceScene newtons_cradle(const Cradle& cradle)
{
    SpaceScene scene;
    SolidMass ball;
    ball.mass = 1;
    ball.inertia = 0.4 * cradle.radius * cradle.radius * Mat3::Identity();
    const Real apart = 2 * cradle.radius + cradle.gap;
    for (int i = 0; i < cradle.balls; ++i) {
        const Vec3 hook((i - (cradle.balls - 1) / 2.0) * apart, cradle.length, 0);
        const Real angle = i < cradle.lifted ? -cradle.lift : 0;
        std::vector<Hull> shape = {solid_ball(cradle.radius)};
        for (const Real z : {-0.2, 0.2})
            shape.push_back(rod_between({0, 0, 0}, {0, cradle.length, z}, 0.003));
        const Vec3 down(sin(angle), -cos(angle), 0);
        const Index k = add_body(scene, shape, ball, hook + cradle.length * down,
                                 {0, 0, angle});
        scene.joints.push_back(hinge(scene, world, k, hook, {0, 0, 1}));
    }
    scene.length = 0.1;
    return scene;
}

/// The speed at which a lifted ball meets the next, from ½ (m l² + I) ω² = m g l (1 − cos α) [m/s].
inline Real meeting_speed(const Cradle& cradle, Real g = 9.81)
{
    const Real l = cradle.length,
               about_hook = l * l + 0.4 * cradle.radius * cradle.radius;
    return l * std::sqrt(2 * g * l * (1 - cos(cradle.lift)) / about_hook);
}

/// Plates of 1 m, end to end on hinges across their length, from a point: the first level. What moves them across their
/// plane, the hinges hold.
/// \param aside  speed of the last across the plane of the motion [m/s]
inline SpaceScene plate_chain(int plates, Real aside)
{
    SpaceScene scene;
    for (int i = 0; i < plates; ++i) {
        const Vec3 end(i, 0, 0);
        const Index k = add_body(scene, {solid_box({0.9, 0.06, 0.5})}, 100.0,
                                 end + Vec3(0.5, 0, 0));
        scene.joints.push_back(
            hinge(scene, i == 0 ? world : k - 1, k, end, {0, 0, 1}));
    }
    scene.bodies.velocity(plates - 1).head<3>() = Vec3(0, 0, aside);
    return scene;
}

/// Links of 1 kg and 0.2 m on ball joints, and a ball of so much more at the end,
/// released at 30° from the vertical.
inline SpaceScene heavy_chain(int links, Real end_mass)
{
    SpaceScene scene;
    const Real length = 0.2;
    const Vec3 down(0.5, -std::sqrt(0.75), 0);
    const Hull link = solid_capsule(0.12, 0.03);
    const Real density = 1 / mass_of(link, 1).mass;
    for (int i = 0; i <= links; ++i) {
        const Vec3 end = i * length * down;
        Hull shape = link;
        Vec3 at = end + length / 2 * down;
        SolidMass mass = mass_of(link, density);
        if (i == links) {
            shape = solid_ball(0.4);
            mass = mass_of(shape, 1);
            mass.inertia *= end_mass / mass.mass, mass.mass = end_mass;
            at = end + 0.4 * down;
        }
        const Index k = add_body(scene, {shape}, mass, at, frame_along(down));
        scene.joints.push_back(ball_joint(scene, i == 0 ? world : k - 1, k, end));
    }
    scene.length = 0.1;
    return scene;
}

}  // namespace rigid
