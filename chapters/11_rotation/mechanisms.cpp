// The functions of mechanisms.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/11_rotation/mechanisms.hpp"

namespace rigid {

RigidScene struck_rod(Real angle)
{
    RigidScene scene;
    scene.gravity = {0, 0};
    scene.walls.push_back({{0, 1}, 0});
    add_body(scene, capsule(1, 0), thin_rod(1, 1), {0, sin(angle) / 2}, angle);
    scene.bodies.u[1] = -1;
    return scene;
}

RigidScene rod_pendulum(std::span<const Real> angles)
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

RigidScene ladder(Real angle)
{
    RigidScene scene;
    scene.walls = {{{0, 1}, 0}, {{1, 0}, 0}};
    add_body(scene, capsule(2, 0), thin_rod(2, 10), Vec2(sin(angle), cos(angle)),
             angle + pi / 2);
    return scene;
}

RigidScene seesaw(Real left, Real right)
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

RigidScene gear_train(std::span<const Real> radii, Real speed, Real torque)
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

RigidScene slider_crank()
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

}  // namespace rigid
