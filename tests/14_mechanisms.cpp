/// Chapter 14: gears, racks, limits that are struck, and bodies that touch.

#include "chapters/14_joints/joint_method.hpp"
#include "chapters/14_joints/joint_scenes.hpp"

#include "tests/catch.hpp"
#include "tests/joint_run.hpp"
#include "tests/sentence.hpp"

using namespace rigid;

TEST_CASE("a gear turns the other wheel back by its ratio", "[idea]")
{
    JointedScene scene;
    scene.gravity = {0, 0};
    for (int k = 0; k < 2; ++k) {
        add_body(scene, disc(1), Mass{1, {0, 0}, 0.5}, {3.0 * k, 0});
        RigidJoint axle = joint_at(scene, JointKind::revolute, world, k, {3.0 * k, 0});
        if (k == 0) axle.motor = {4, 1, 0, 0, 0};
        add_joint(scene, axle);
    }
    RigidJoint gear;
    gear.kind = JointKind::gear;
    gear.a = 0, gear.b = 1;
    gear.ratio = 2;
    add_joint(scene, gear);
    ExactJoints<AllBodies> method;
    StepData<3> now;
    step(scene, {.h = 0.01}, method, now);
    // 1 N m on 0.5 + 0.5/4 kg m²
    CHECK(std::abs(scene.bodies.u[2] - 0.01 / 0.625) <= 1e-12);
    for (int i = 0; i < 500; ++i) step(scene, {.h = 0.01}, method, now);
    CHECK(std::abs(scene.bodies.u[2] - 4) <= 1e-9);  // what the motor wants, to rounding
    CHECK(std::abs(scene.bodies.u[5] + 2) <= 1e-9);
}

TEST_CASE("a rack follows its pinion on a car that drives and turns", "[idea]")
{
    // a pinion on a pin of the car, and under it a rack that slides along the car
    const auto after_a_second = [](const Vec2& velocity, Real spin, Real motor) {
        JointedScene scene;
        scene.gravity = {0, 0};
        const Real angle = 0.3, r = 0.5;
        const Vec2 along(std::cos(angle), std::sin(angle));
        add_body(scene, box(4, 1), Mass{10, {0, 0}, 14}, {0, 0}, angle);
        add_body(scene, disc(r), Mass{1, {0, 0}, 0.125}, {-0.8, 0.2});
        const Vec2 under = Vec2(-0.8, 0.2) - r * perpendicular(along);
        add_body(scene, box(2, 0.2), Mass{1, {0, 0}, 0.3}, under, angle);
        RigidJoint axle = joint_at(scene, JointKind::revolute, 0, 1, {-0.8, 0.2});
        if (motor != 0) axle.motor = {motor, 1e3, 0, 0, 0};
        add_joint(scene, axle);
        const RigidJoint slide = joint_at(scene, JointKind::prismatic, 0, 2, under);
        add_joint(scene, slide);
        RigidJoint rack;
        rack.kind = JointKind::rack;
        rack.a = 1, rack.b = 2;
        rack.ratio = -r;  // what is under the pinion goes along with its lowest point
        rack.length = r * angle;
        add_joint(scene, rack);
        for (Index k = 0; k < 3; ++k) {
            const Vec2 place = scene.bodies.position(k).head<2>();
            scene.bodies.velocity(k) << velocity + spin * perpendicular(place), spin;
        }
        ExactJoints<AllBodies> method;
        StepData<3> now;
        for (int i = 0; i < 240; ++i) step(scene, {.h = 1.0 / 240}, method, now);
        const VecX& x = scene.bodies.x;
        return std::pair{x[5] - x[2] + angle, coordinate(x, slide)};
    };
    // the joints are off by 1e-9 of a metre
    const auto [still, stays] = after_a_second({3, 1}, 0, 0);
    CHECK(std::abs(still) < 1e-8);
    CHECK(std::abs(stays) < 1e-8);
    for (const Real spin : {0.0, 2.0}) {
        const auto [turned, slid] = after_a_second({3, 1}, spin, 1.5);
        CHECK(turned == Approx(1.5).epsilon(0.01));  // a step or two until the motor is at its speed
        CHECK(slid == Approx(0.5 * turned).margin(1e-7));
    }
}

TEST_CASE("a limb that is struck stops at its limit in the very step of the blow", "[idea]")
{
    // a rod of 0.5 m on a pin, at rest in the middle of its 0.6 rad; a ball of ten times its mass comes at 20 m/s: it would
    // turn by h v / l = 0.67 rad
    JointedScene scene;
    scene.gravity = {0, 0};
    add_body(scene, box(0.5, 0.1), 1.0, {0.25, 0});
    RigidJoint pin = joint_at(scene, JointKind::revolute, world, 0, {0, 0});
    pin.lower = -0.3, pin.upper = 0.3;
    add_joint(scene, pin);
    add_body(scene, disc(0.1), 10.0, {0.45, 0.16});
    scene.bodies.velocity(1)[1] = -20;
    cover(scene, {0, 0, 0, 0});
    ExactJoints<Manifolds> method;
    never_stop(method.contacts);
    StepData<3> now;
    for (int i = 0; i < 30; ++i) {
        step(scene, {}, method, now);
        // the slop, and what the arc of a step is beside its chord
        CHECK(coordinate(scene.bodies.x, pin) > -0.3 - 0.01);
        if (i == 0) CHECK(coordinate(scene.bodies.x, pin) < -0.25);  // it was struck
    }
}

TEST_CASE("joined bodies touch only if their joint lets them", "[house]")
{
    for (const bool may : {false, true}) {
        JointedScene scene;
        for (int k = 0; k < 2; ++k) add_body(scene, box(1, 1), 1.0, {0.9 * k, 0});
        RigidJoint joint = joint_at(scene, JointKind::revolute, 0, 1, {0.45, 0.5});
        joint.collide_connected = may;
        add_joint(scene, joint);
        ExactJoints<Manifolds> method;
        StepData<3> now;
        step(scene, {}, method, now);
        CHECK(now.contacts.empty() != may);
    }
}

TEST_CASE("bridges and catenaries of any number of parts begin with closed joints", "[house]")
{
    for (const int parts : {2, 3, 4, 5, 20, 21}) {
        INFO(parts << " parts");
        // rounding of places of a few metres
        CHECK(largest_joint_error(bridge_scene(parts)) <= 1e-14);
        CHECK(largest_joint_error(catenary_scene(parts)) <= 1e-14);
    }
    CHECK(sentence_of([] { catenary_scene(1); }) == "the catenary has 1 rods; it needs two or more");
}
