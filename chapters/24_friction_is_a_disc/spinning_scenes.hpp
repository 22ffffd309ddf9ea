/// \file spinning_scenes.hpp
/// What spins on a floor: a top on its tip, a ball with its mass low, which turns over, and a rattleback, which turns back.
#pragma once

#include "chapters/21_joints_in_space/hung_scenes.hpp"
#include "chapters/24_friction_is_a_disc/rolling_solid.hpp"
#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"

namespace rigid {

/// The top of section 21.B without its joint: the tip is a point that stands on a
/// floor, and friction holds it.
RoughSolids top_on_table(const TopShape& top, Real mu);

//! [low_ball]
/// A ball whose centroid is below its centre, and which spins about the vertical.
struct LowBall {
    Real radius = 0.02, low = 0.004;  ///< [m]
    Real mass = 0.02;                 ///< [kg], with the moments of a full ball
    Real spin = 150;                  ///< [rad/s]
    Real tilt = 0.1;                  ///< of its axis from upright [rad]
};

inline RoughSolids spinning_low_ball(const LowBall& ball, Real mu)
{
    require_positive("the radius of a ball", ball.radius);
    require_positive("the mass of a ball", ball.mass);
    RoughSolids scene;
    SolidMass mass;
    mass.mass = ball.mass;
    mass.inertia = 0.4 * ball.mass * ball.radius * ball.radius * Mat3::Identity();
    Hull hull = solid_ball(ball.radius);
    hull.vertices[0] = {0, ball.low, 0};
    const Vec3 axis(sin(ball.tilt), cos(ball.tilt), 0);
    add_body(scene, {hull}, mass, Vec3(0, ball.radius, 0) - ball.low * axis,
             {0, 0, -ball.tilt});
    const Mat3 R = rotation_of(scene.bodies.x, 0);
    scene.bodies.velocity(0).tail<3>() = R.transpose() * Vec3(0, ball.spin, 0);
    scene.length = 0.1;
    add_floor(scene, mu);
    return scene;
}

/// The ball's axis now: from the centroid to the centre.
inline Vec3 axis_of(const RoughSolids& scene)
{
    return (rotation_of(scene.bodies.x, 0) * scene.shapes[0][0].vertices[0])
        .normalized();
}

/// (24.13): −L·r, r from the centroid to the lowest point, which stays however the
/// ball slides [kg m³/s].
inline Real jellett(const RoughSolids& scene)
{
    const Bodies<6>& bodies = scene.bodies;
    const Vec3 L =
        rotation_of(bodies.x, 0) *
        bodies.u.segment<3>(3).cwiseQuotient(bodies.inverse_mass.segment<3>(3));
    const Hull& ball = scene.shapes[0][0];
    const Vec3 r =
        rotation_of(bodies.x, 0) * ball.vertices[0] - ball.radius * Vec3(0, 1, 0);
    return -L.dot(r);
}
//! [low_ball]

//! [rattleback]
/// A boat of 1 kg and the length 30 cm, whose masses lie askew to its keel.
struct Rattleback {
    Vec3 semi_axes = {0.15, 0.02, 0.03};    ///< along, down, across [m]
    Real low = 0.01;                        ///< of the centroid under the deck [m]
    Vec3 moments = {2e-4, 2.6e-3, 2.5e-3};  ///< about the same axes [kg m²]
    Real askew = 0.05;  ///< of the keel against them, about the vertical [rad]
};

/// At rest on a floor but for a spin about the vertical and a tilt.
/// \param spin  [rad/s]
/// \param tilt  about its length [rad]
inline RoughSolids spinning_rattleback(const Rattleback& boat, Real spin, Real tilt,
                                       Real mu)
{
    RoughSolids scene;
    SolidMass mass;
    mass.mass = 1;
    mass.inertia = boat.moments.asDiagonal();
    scene.length = 0.1;
    const Index k = add_body(scene, {}, mass, {0, 0, 0}, {tilt, 0, 0});
    SolidEllipsoid keel;
    keel.at = {0, boat.low, 0};
    keel.stretch =
        rotation_matrix(Vec3(0, boat.askew, 0)) * boat.semi_axes.asDiagonal();
    scene.ellipsoids.push_back(keel);
    const Mat3 R = rotation_of(scene.bodies.x, k);
    const Vec3 up = R.transpose() * Vec3(0, 1, 0);
    const Vec3 r = lowest_point(keel, up);
    scene.bodies.x[1] = -up.dot(r);
    scene.bodies.velocity(k).tail<3>() = spin * up;
    scene.bodies.velocity(k).head<3>() = R * cross(r, Vec3(spin * up));
    add_floor(scene, mu);
    return scene;
}

/// The same body for (24.12), and where it is.
inline RollingSolid rolling_solid(const RoughSolids& scene)
{
    return {1 / scene.bodies.inverse_mass[0],
            scene.bodies.inverse_mass.segment<3>(3).cwiseInverse(),
            scene.ellipsoids[0], -scene.gravity.y()};
}
inline Vec<6> rolling_state(const RoughSolids& scene)
{
    Vec<6> y;
    y << rotation_of(scene.bodies.x, 0).transpose() * Vec3(0, 1, 0),
        scene.bodies.u.segment<3>(3);
    return y;
}
//! [rattleback]

}  // namespace rigid
