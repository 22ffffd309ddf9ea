/// \file mechanisms.hpp
/// The scenes of this chapter, with the closed forms that they are measured against.
#pragma once

#include "chapters/11_rotation/rigid_method.hpp"
#include "common/elementary.hpp"

#include <span>

namespace rigid {

/// A thin rod of 1 m and 1 kg, its lower left end on the floor, falling at 1 m/s without turning; no gravity.
/// \param angle  to the floor [rad], more than 0 and at most π/2
inline RigidScene struck_rod(Real angle)
{
    RigidScene scene;
    scene.gravity = {0, 0};
    scene.walls.push_back({{0, 1}, 0});
    add_body(scene, capsule(1, 0), thin_rod(1, 1), {0, sin(angle) / 2}, angle);
    scene.bodies.u[1] = -1;
    return scene;
}

/// λ, v′ and ω′ of that impact by hand, (11.8).
inline Vec<3> struck_rod_by_hand(Real angle, Real e)
{
    const Real arm = -cos(angle) / 2, lambda = (1 + e) / (1 + 12 * arm * arm);
    return {lambda, lambda - 1, 12 * arm * lambda};
}

/// Rods of 1 m and 1 kg in a row, pinned to the origin and to each other, at rest.
/// \param angles  of each from straight down [rad]
inline RigidScene rod_pendulum(std::span<const Real> angles)
{
    RigidScene scene;
    Vec2 end(0, 0);
    for (const Real angle : angles) {
        const Vec2 along(sin(angle), -cos(angle));
        const Index k = add_body(scene, capsule(1, 0), thin_rod(1, 1),
                                 end + along / 2, angle - pi / 2);
        add_pin(scene, k - 1, k == 0 ? Vec2(0, 0) : Vec2(0.5, 0), k, {-0.5, 0});
        end += along;
    }
    return scene;
}

/// The angle of rod k of such a row from straight down [rad].
inline Real rod_angle(const RigidScene& scene, Index k)
{
    return scene.bodies.x[3 * k + 2] + pi / 2;
}

/// A ladder of 2 m and 10 kg between a wall and a floor, both without friction, at rest.
/// \param angle  from the wall [rad]
inline RigidScene ladder(Real angle)
{
    RigidScene scene;
    scene.walls = {{{0, 1}, 0}, {{1, 0}, 0}};
    add_body(scene, capsule(2, 0), thin_rod(2, 10), Vec2(sin(angle), cos(angle)),
             angle + pi / 2);
    return scene;
}

/// A plank of 4 m and 20 kg pinned in its middle, and two weights on ropes of 0.5 m from its ends.
inline RigidScene seesaw(Real left, Real right)
{
    RigidScene scene;
    add_body(scene, box(4, 0.1), 20 / 0.4, {0, 0});
    add_pin(scene, world, {0, 0}, 0, {0, 0});
    for (const Real side : {-1.0, 1.0}) {
        const Real mass = side < 0 ? left : right;
        const Index k =
            add_body(scene, box(0.4, 0.4), mass / 0.16, {2 * side, -0.7});
        PointJoint rope;
        rope.a = 0, rope.b = k;
        rope.at_a = {2 * side, 0}, rope.at_b = {0, 0.2};
        rope.length = 0.5;
        rope.sense = -1;
        rope.kind = ConstraintKind::unilateral;
        scene.joints.push_back(rope);
    }
    return scene;
}

/// The angular acceleration of that plank where it lies level, by hand [rad/s²].
inline Real seesaw_by_hand(Real left, Real right)
{
    const Real inertia = 20 * (16 + 0.01) / 12;
    return 9.81 * 2 * (left - right) / (inertia + 4 * (left + right));
}

/// Wheels in a row on pins, each meshing with the next; a motor turns the first. Discs of 10 kg/m².
inline RigidScene gear_train(std::span<const Real> radii, Real speed, Real torque)
{
    RigidScene scene;
    scene.gravity = {0, 0};
    Real at = 0;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        if (i > 0) at += radii[i - 1] + radii[i];
        const Index k = add_body(scene, disc(radii[i]), 10, {at, 0});
        add_pin(scene, world, {at, 0}, k, {0, 0});
        if (k > 0) add_gears(scene, k - 1, radii[i - 1], k, radii[i]);
    }
    add_turning_motor(scene, world, 0, speed, torque);
    return scene;
}

/// What the first wheel feels of all of them, (11.15): Σ I (r₁/r)² [kg m²].
inline Real gear_inertia(std::span<const Real> radii)
{
    Real sum = 0;
    for (const Real r : radii)
        sum += mass_of(disc(r), 10).inertia * (radii[0] / r) * (radii[0] / r);
    return sum;
}

/// A crank of 0.2 m that turns at 10 rad/s whatever happens, a rod of 0.5 m and 1 kg, and a slider on the x axis.
inline RigidScene slider_crank()
{
    RigidScene scene;
    add_body(scene, capsule(0.2, 0), Mass{}, {0, 0});
    scene.bodies.u[2] = 10;
    add_body(scene, capsule(0.5, 0), thin_rod(0.5, 1), {0.45, 0});
    scene.bodies.u.tail<3>() << 0, 1, -4;
    add_pin(scene, 0, {0.2, 0}, 1, {-0.25, 0});
    PointJoint rail;
    rail.measure = PointJoint::Measure::along;
    rail.b = 1;
    rail.at_b = {0.25, 0};
    rail.direction = {0, 1};
    scene.joints.push_back(rail);
    return scene;
}

/// x = r cos θ + √(l² − r² sin² θ)
inline Real slider_by_hand(Real theta)
{
    const Real s = 0.2 * sin(theta);
    return 0.2 * cos(theta) + std::sqrt(0.25 - s * s);
}

}  // namespace rigid
