// The functions of bar_linkages.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/14_joints/bar_linkages.hpp"

namespace rigid {

//! [cranks]
JointedScene cranks_scene(int cranks, Real angle, Real spin)
{
    if (cranks < 2)
        throw std::invalid_argument("there are " + std::to_string(cranks) +
                                    " cranks; a bar needs two or more");
    JointedScene scene;
    const Vec2 arm(cos(angle), sin(angle)), v = spin * perpendicular(arm);
    const Real width = 2.0 * (cranks - 1);
    const Index bar = add_bar(scene, arm, arm + Vec2(width, 0), 1);
    scene.bodies.velocity(bar).head<2>() = v;
    for (int i = 0; i < cranks; ++i) {
        const Vec2 pivot(2.0 * i, 0);
        const Index crank = add_bar(scene, pivot, pivot + arm, 1);
        scene.bodies.velocity(crank) << v / 2, spin;
        pin(scene, world, crank, pivot);
        pin(scene, crank, bar, pivot + arm);
    }
    return scene;
}
//! [cranks]

JointedScene engine_scene(Real speed, Real torque)
{
    JointedScene scene;
    scene.gravity = {0, 0};
    const Index crank = add_bar(scene, {0, 0}, {0.2, 0}, 1),
                rod = add_bar(scene, {0.2, 0}, {0.7, 0}, 1),
                piston = add_body(scene, box(0.2, 0.18), 10, {0.7, 0});
    RigidJoint axle = joint_at(scene, JointKind::revolute, world, crank, {0, 0});
    axle.motor.speed = speed, axle.motor.force = torque;
    add_joint(scene, axle);
    pin(scene, crank, rod, {0.2, 0});
    pin(scene, rod, piston, {0.7, 0});
    RigidJoint cylinder =
        joint_at(scene, JointKind::prismatic, world, piston, {0.7, 0});
    add_joint(scene, cylinder);
    // the velocities that go with the crank's
    scene.bodies.velocity(crank) << 0, 0.1 * speed, speed;
    scene.bodies.velocity(rod) << 0, 0.1 * speed, -0.4 * speed;
    return scene;
}

JointedScene trebuchet_scene(Real weight, JointKind sling)
{
    JointedScene scene;
    const Real angle = -0.55;
    const Vec2 axle(0, 2.6), along(cos(angle), -sin(angle));
    const Vec2 tip = axle - 4 * along, end = axle + along;
    const Index beam = add_bar(scene, tip, end, 60),
                load = add_body(scene, box(0.8, 0.8), weight / 0.64,
                                end - Vec2(0, 0.6)),
                stone = add_body(scene, disc(0.15), Mass{10, {0, 0}, 0.1},
                                 tip + Vec2(2.6, -0.35));
    pin(scene, world, beam, axle);
    pin(scene, beam, load, end);
    RigidJoint joint;
    joint.kind = sling;
    joint.a = beam, joint.b = stone;
    joint.at_a = local_point(scene, beam, tip);
    joint.length = (scene.bodies.position(stone).head<2>() - tip).norm();
    add_joint(scene, joint);
    return scene;
}

Index add_jansen_leg(JointedScene& scene, Real angle, const Drive& motor)
{
    const JansenLeg leg(angle);
    const Index crank = add_bar(scene, {0, 0}, leg.p[0], 2 * leg.p[0].norm());
    RigidJoint axle = joint_at(scene, JointKind::revolute, world, crank, {0, 0});
    axle.motor = motor;
    add_joint(scene, axle);
    hang_jansen_leg(scene, world, crank, leg, [](const Vec2& p) { return p; });
    return crank;
}

}  // namespace rigid
