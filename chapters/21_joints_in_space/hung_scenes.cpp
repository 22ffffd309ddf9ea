// The functions of hung_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/21_joints_in_space/hung_scenes.hpp"

namespace rigid {

Real slow_precession(Real pivot, Real axial, Real spin, Real weight_arm, Real tilt)
{
    const Real a = pivot * cos(tilt), b = axial * spin;
    const Real inside = b * b - 4 * a * weight_arm;
    if (!(inside >= 0))
        throw std::invalid_argument("a spin of " + shortest(spin) +
                                    " rad/s is too slow: no steady precession "
                                    "holds the top at this tilt");
    return 2 * weight_arm / (b + std::copysign(std::sqrt(inside), b));
}

//! [top]
JointedSolids spinning_top(const TopShape& top)
{
    JointedSolids scene;
    const Real axial = top.radius * top.radius / 2, across = axial / 2;
    SolidMass mass;
    mass.mass = 1;
    mass.inertia = Vec3(across, axial, across).asDiagonal();
    const Vec3 axis(sin(top.tilt), cos(top.tilt), 0);
    Hull disc, pin = solid_capsule(top.length, 0.008);
    for (Vec3& p : pin.vertices) p = Vec3(0, p.x() - top.length / 2, 0);
    disc = solid_capsule(0.02, 0.02);  // a hub; the rim is 24 boxes
    for (Vec3& p : disc.vertices) p = Vec3(0, p.x(), 0);
    std::vector<Hull> shape = {pin, disc};
    for (int i = 0; i < 24; ++i) {
        Hull box = solid_box({top.radius, 0.016, 0.04}, {top.radius / 2, 0, 0});
        const Mat3 R = rotation_matrix(Vec3(0, 2 * pi * i / 24, 0));
        for (Vec3& p : box.vertices) p = R * p;
        shape.push_back(box);
    }
    const Index k =
        add_body(scene, shape, mass, top.length * axis, {0, 0, -top.tilt});
    // precession about y, seen from the body, and the spin about its axis
    const Real rate = precession_of(top);
    const Mat3 R = rotation_of(scene.bodies.x, k);
    Vec3 spin = R.transpose() * Vec3(0, rate, 0);
    spin.y() = top.spin;
    scene.bodies.velocity(k).tail<3>() = spin;
    scene.bodies.velocity(k).head<3>() = cross(Vec3(0, rate, 0), top.length * axis);
    scene.joints.push_back(ball_joint(scene, world, k, {0, 0, 0}));
    return scene;
}
//! [top]

/// Throws std::invalid_argument unless a chain has something to hang.
static void require_some(int count, const std::string& what)
{
    if (count < 1)
        throw std::invalid_argument("a chain has " + std::to_string(count) + " " +
                                    what + "; it needs at least one");
}

JointedSolids rod_chain(int rods)
{
    require_some(rods, "rods");
    JointedSolids scene;
    for (int i = 0; i < rods; ++i) {
        const Vec3 end(i, 0, 0);
        const Index k =
            add_body(scene, {solid_capsule(0.8, 0.1)}, 30.0, end + Vec3(0.5, 0, 0));
        const Index before = i == 0 ? world : k - 1;
        scene.joints.push_back(
            i % 2 == 0 ? ball_joint(scene, before, k, end)
                       : constant_velocity(scene, before, k, end, {1, 0, 0}));
    }
    // a push to the side, so that it leaves the plane
    scene.bodies.velocity(rods - 1).head<3>() = Vec3(0, 0, 2);
    return scene;
}

//! [door]
JointedSolids driven_door(Real speed, Real torque, Real stop)
{
    JointedSolids scene;
    scene.gravity.setZero();
    const Vec3 size(0.8, 2, 0.04);
    const Index k =
        add_body(scene, {solid_box(size)}, 20 / size.prod(), {0.4, 0, 0});
    SpaceJoint joint = hinge(scene, world, k, {0, 0, 0}, {0, 1, 0});
    joint.lo[twist] = -stop, joint.hi[twist] = stop;
    joint.motor = twist, joint.speed = speed, joint.force = torque;
    scene.joints.push_back(joint);
    return scene;
}
//! [door]

JointedSolids plate_chain(int plates, Real aside)
{
    require_some(plates, "plates");
    JointedSolids scene;
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

JointedSolids heavy_chain(int links, Real end_mass)
{
    require_some(links, "links");
    require_positive("the mass at the end of a chain", end_mass);
    JointedSolids scene;
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
