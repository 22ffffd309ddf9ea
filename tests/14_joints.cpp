/// Chapter 14: every kind of joint as rows, on the step of Part I.

#include "chapters/14_joints/joint_method.hpp"
#include "chapters/14_joints/joint_scenes.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/joint_run.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

#include <functional>
#include <set>

using namespace rigid;

namespace {

using Exact = ExactJoints<AllBodies>;

/// Two bodies somewhere, and a joint of this kind with all that it may have.
JointedScene random_joint(Random& random, JointKind kind, bool on_world)
{
    JointedScene scene;
    for (int k = 0; k < 2; ++k) {
        const Real x = random.uniform(-2, 2), y = random.uniform(-2, 2), angle = random.uniform(-3, 3),
                   density = random.uniform(0.5, 3);
        add_body(scene, box(1, 0.5), density, {x, y}, angle);
    }
    RigidJoint joint;
    joint.kind = kind;
    joint.a = on_world ? world : 0, joint.b = 1;
    const Real turn = random.uniform(-3, 3), p = random.uniform(-1, 1), q = random.uniform(-1, 1);
    joint.axis = {std::cos(turn), std::sin(turn)};
    joint.at_a = {p, q}, joint.at_b = {q, 0.3};
    joint.angle = p, joint.length = 1.5, joint.ratio = 0.7;
    joint.over_a = {-4, 6}, joint.over_b = {4, 7};
    if (has_coordinate(kind)) {
        joint.lower = -1, joint.upper = 2;
        joint.motor = {0.5, 3, 0, 0, 0};
        joint.spring = {0, 0, 40, 2, 0.3};
    } else {
        if (kind == JointKind::friction) joint.motor.force = 5;
        if (kind == JointKind::mouse || kind == JointKind::motor) joint.spring = {0, 7, 40, 2, 0};
        if (kind == JointKind::friction || kind == JointKind::motor) joint.torque = 3;
    }
    add_joint(scene, joint);
    for (Index i = 0; i < 6; ++i) scene.bodies.u[i] = random.uniform(-2, 2);
    return scene;
}

}  // namespace

// ---- identities of the scheme

TEST_CASE("a door on a pin with a motor and a stop takes the impulses of (14.1) and (14.2)", "[idea]")
{
    for (const bool near : {false, true}) {
        JointedScene scene;
        scene.gravity = {0, 0};
        add_body(scene, capsule(1, 0), thin_rod(1, 3), {0.5, 0});
        RigidJoint hinge = joint_at(scene, JointKind::revolute, world, 0, {0, 0});
        hinge.upper = near ? 0.005 : 1;
        hinge.motor.speed = 1, hinge.motor.force = 1;
        add_joint(scene, hinge);
        Exact method;
        method.contacts.skip_far_limits = false;
        StepData<3> now;
        step(scene, {.h = 0.1}, method, now);
        const VecX& lambda = now.solution.lambda;
        REQUIRE(lambda.size() == 4);  // x, y, the stop, the motor
        // a solve of four rows to rounding
        CHECK((lambda - (near ? VecX{{0, 0.075, 0.05, 0.1}} : VecX{{0, 0.15, 0, 0.1}})).norm() <= 1e-14);
        CHECK(std::abs(scene.bodies.u[2] - (near ? 0.05 : 0.1)) <= 1e-14);
    }
}

TEST_CASE("J of every kind of joint is the derivative of its C", "[idea]")
{
    Random random(14);
    std::set<std::pair<int, int>> seen;
    for (int round = 0; round < 100; ++round)
        for (int kind = 0; kind < joint_kind_count; ++kind) {
            const JointedScene scene = random_joint(random, static_cast<JointKind>(kind), round % 3 == 0);
            const VecX& x = scene.bodies.x;
            REQUIRE_FALSE(scene.joints.empty());
            for (const PointJoint& joint : scene.joints) {
                seen.insert({kind, static_cast<int>(joint.measure)});
                const Constraint<3> c = joint_constraint(x, joint);
                if (joint.measure == PointJoint::Measure::distance &&
                    std::abs(joint.sense * c.C + joint.length) < 0.1)
                    continue;  // where the points nearly meet C bends without bound
                for (Index i = 0; i < 6; ++i) {
                    const Real t = 1e-5;  // error t² C'''/6 of about 1e-9, and rounding 1e-16/t
                    VecX more = x, less = x;
                    more[i] += t, less[i] -= t;
                    const Real slope =
                        (joint_constraint(more, joint).C - joint_constraint(less, joint).C) / (2 * t);
                    const Real J = i >= 3 ? c.Jb[i - 3] : c.a == 0 ? c.Ja[i] : 0;
                    CHECK(std::abs(slope - J) <= 1e-7);
                }
            }
        }
    CHECK(seen.size() == 18);  // every kind with all its measures, counted in the table of section 14.2
}

TEST_CASE("a joint bears what statics says", "[idea]")
{
    // A rod of 2 kg on a weld in a wall, level: the weld bears its weight and the moment of it.
    JointedScene scene;
    add_body(scene, capsule(1, 0), thin_rod(1, 2), {0.5, 0});
    RigidJoint weld = joint_at(scene, JointKind::weld, world, 0, {0, 0});
    add_joint(scene, weld);
    Exact method;
    StepData<3> now;
    for (int i = 0; i < 10; ++i) step(scene, {}, method, now);
    const Reaction bears = reaction(scene, now, 0);
    CHECK(std::abs(bears.force.x()) <= 1e-10);
    CHECK(std::abs(bears.force.y() - 2 * 9.81) <= 1e-9);  // to rounding over h
    CHECK(std::abs(bears.torque - 2 * 9.81 * 0.5) <= 1e-9);
}

TEST_CASE("a hinge bears no torque however fast its body turns", "[idea]")
{
    // The rod turns by up to 0.3 rad in a step: about the point where the pin is then, its impulses have no moment.
    for (const Real spin : {1.0, 10.0, 20.0}) {
        JointedScene scene;
        scene.gravity = {0, 0};
        add_body(scene, capsule(1, 0), thin_rod(1, 2), {0.5, 0});
        RigidJoint hinge = joint_at(scene, JointKind::revolute, world, 0, {0, 0});
        hinge.breaking_torque = 1e-6;
        add_joint(scene, hinge);
        scene.bodies.velocity(0) << 0, spin / 2, spin;
        Exact method;
        StepData<3> now;
        for (int i = 0; i < 10; ++i) {
            step(scene, {}, method, now);
            const Reaction bears = reaction(scene, now, 0);
            REQUIRE((i == 0 || bears.force.norm() > 0.5 * spin * spin));    // m r ω² is 1 kg m times ω²
            REQUIRE(std::abs(bears.torque) <= 1e-12 * bears.force.norm());  // rounding
        }
        CHECK_FALSE(scene.placed[0].broken);
    }
}

TEST_CASE("an Atwood machine whose pulley turns starts with the acceleration and the tensions by hand",
          "[idea]")
{
    JointedScene scene = atwood_scene();
    Exact method;
    StepData<3> now;
    step(scene, {}, method, now);
    // B4 of the reference values; one step from rest is exact, to rounding over h
    CHECK(std::abs(-60 * scene.bodies.u[7] - 2.802857142857143) <= 1e-12);
    CHECK(std::abs(atwood_by_hand() - 2.802857142857143) <= 1e-12);
    CHECK(std::abs(reaction(scene, now, 2).force.y() - 14.01428571428571) <= 1e-11);
    CHECK(std::abs(reaction(scene, now, 1).force.y() - 12.61285714285714) <= 1e-11);
}

TEST_CASE("a pulley of two to one holds twice the weight and moves what is not in balance by hand", "[idea]")
{
    // ‖p_a − q_a‖ + 2 ‖p_b − q_b‖ stays: T pulls at a, 2T at b. With m_a = 1 kg and a_a = −2 a_b (downwards) that is
    // T = 3g / (1/m_a + 4/m_b), a_b = g − 2T/m_b.
    for (const Real mass : {2.0, 3.0}) {
        JointedScene scene;
        add_body(scene, box(1, 1), 1, {-2, 0});
        add_body(scene, box(1, 1), mass, {2, 0});
        RigidJoint pulley;
        pulley.kind = JointKind::pulley;
        pulley.a = 0, pulley.b = 1;
        pulley.over_a = {-2, 5}, pulley.over_b = {2, 5};
        pulley.ratio = 2;
        pulley.length = 15;
        add_joint(scene, pulley);
        Exact method;
        StepData<3> now;
        step(scene, {}, method, now);
        const Real g = 9.81, T = 3 * g / (1 + 4 / mass), down = g - 2 * T / mass;
        // one step from rest is exact, to rounding over h
        CHECK(std::abs(-60 * scene.bodies.u[4] - down) <= 1e-12);
        CHECK(std::abs(-60 * scene.bodies.u[1] + 2 * down) <= 1e-12);
        CHECK((mass == 2) == (std::abs(down) < 1e-12));
    }
}

TEST_CASE("a mouse pulls with its force and no more", "[idea]")
{
    JointedScene scene;
    scene.gravity = {0, 0};
    add_body(scene, box(1, 1), 2.0, {0, 0});
    RigidJoint mouse;
    mouse.kind = JointKind::mouse;
    mouse.at_a = {100, 0};
    mouse.spring = {0, 6, 1000, 10, 0};
    add_joint(scene, mouse);
    Exact method;
    StepData<3> now;
    step(scene, {.h = 0.01}, method, now);
    CHECK(std::abs(scene.bodies.u[0] - 6.0 / 2 * 0.01) <= 1e-14);  // F h / m, one operation each
    CHECK(std::abs(reaction(scene, now, 0).force.x() - 6) <= 1e-12);
}

TEST_CASE("a motor reaches its speed as far as its torque lets it", "[idea]")
{
    JointedScene scene;
    scene.gravity = {0, 0};
    add_body(scene, disc(1), Mass{1, {0, 0}, 0.5}, {0, 0});
    RigidJoint axle;
    axle.motor = {2, 3, 0, 0, 0};  // 2 rad/s, at most 3 N m
    add_joint(scene, axle);
    Exact method;
    StepData<3> now;
    for (int i = 1; i <= 50; ++i) {
        step(scene, {.h = 0.01}, method, now);
        CHECK(std::abs(scene.bodies.u[2] - std::min(2.0, 3 / 0.5 * 0.01 * i)) <= 1e-12);
    }
}

TEST_CASE("a motor and a spring reach a limit in the step in which they begin and go no farther", "[idea]")
{
    // 100 rad/s from rest, or a target beyond the limit: in a step of 1/60 s either would go well past 1 rad
    const auto after_a_step = [](const Drive& motor, const Drive& spring, int& skipped) {
        JointedScene scene;
        scene.gravity = {0, 0};
        add_body(scene, box(1, 0.1), 10.0, {0.5, 0});
        RigidJoint hinge = joint_at(scene, JointKind::revolute, world, 0, {0, 0});
        hinge.lower = -1, hinge.upper = 1;
        hinge.motor = motor, hinge.spring = spring;
        add_joint(scene, hinge);
        Exact method;
        StepData<3> now;
        step(scene, {}, method, now);
        skipped = method.contacts.limits_skipped;
        return coordinate(scene.bodies.x, hinge);
    };
    int skipped = 0;
    for (const Real way : {1.0, -1.0}) {
        // the row of the limit lets the joint come to C = 0, to rounding
        CHECK(std::abs(after_a_step({100 * way, 1e6, 0, 0, 0}, {}, skipped) - way) <= 1e-12);
        CHECK(skipped == 1);  // the other limit
        CHECK(std::abs(after_a_step({}, {0, 0, 1e6, 10, 3 * way}, skipped) - way) <= 1e-12);
        CHECK(skipped == 1);
    }
    // what the force of a motor cannot do in a step makes no row
    CHECK(std::abs(after_a_step({100, 1, 0, 0, 0}, {}, skipped)) < 0.01);
    CHECK(skipped == 2);
}

TEST_CASE("a limit holds where a belt begins to turn a wheel", "[idea]")
{
    // a wheel of 1 kg under a frame of 100 kg that only goes up and down stands on a belt of 20 m/s, at rest: friction can make
    // it turn at 40 rad/s within a step of 1/60 s, which is 0.67 rad
    for (const Real way : {1.0, -1.0}) {
        JointedScene scene;
        add_body(scene, box(0.2, 0.2), Mass{100, {0, 0}, 1}, {0, 0.5});
        add_body(scene, disc(0.5), Mass{1, {0, 0}, 0.125}, {0, 0.5});
        scene.walls.push_back({{0, 1}, 0});
        cover(scene, {1, 0, 0, 0});
        scene.wall_surfaces[0].belt = 20 * way;
        RigidJoint guide = joint_at(scene, JointKind::prismatic, world, 0, {0, 0.5});
        guide.axis = {0, 1};
        add_joint(scene, guide);
        RigidJoint axle = joint_at(scene, JointKind::revolute, 0, 1, {0, 0.5});
        axle.lower = -0.3, axle.upper = 0.3;
        add_joint(scene, axle);
        Exact method;
        StepData<3> now;
        step(scene, {}, method, now);
        REQUIRE(now.solution.status == Status::solved);
        CHECK(std::abs(std::abs(coordinate(scene.bodies.x, axle)) - 0.3) <= 1e-12);
    }
}

TEST_CASE("a damper alone lets a distance change and slows it down as it says", "[idea]")
{
    JointedScene scene;
    scene.gravity = {0, 0};
    add_body(scene, disc(0.1), Mass{2, {0, 0}, 0.1}, {1, 0});
    scene.bodies.u[0] = 1;
    RigidJoint damper;
    damper.kind = JointKind::distance;
    damper.length = 1;
    damper.spring.damping = 3;
    add_joint(scene, damper);
    CHECK(scene.placed[0].count == 1);
    Exact method;
    StepData<3> now;
    for (int i = 1; i <= 60; ++i) {
        step(scene, {.h = 0.01}, method, now);
        // m Δv = −h c v at the end of each step: rounding of a few operations a step
        REQUIRE(std::abs(scene.bodies.u[0] - std::pow(1 + 0.01 * 3 / 2, -i)) <= 1e-13);
    }
}

TEST_CASE("a pendulum between its limits moves the same to the bit when far limits have no rows", "[house]")
{
    const auto swing = [](auto method, bool skip, int& skipped) {
        JointedScene scene = chain_scene({3, 0.5, 1, 2, 1.2});
        for (std::size_t i = 0; i < 3; ++i) {
            RigidJoint joint = scene.placed[i].joint;
            joint.kind = JointKind::revolute;
            joint.angle = i == 0 ? -pi / 2 : 0;
            joint.lower = -1.3, joint.upper = 0.9;
            add_joint(scene, joint);
        }
        method.contacts.skip_far_limits = skip;
        StepData<3> now;
        skipped = 0;
        for (int i = 0; i < 600; ++i) {
            step(scene, {.h = 1.0 / 120}, method, now);
            skipped += method.contacts.limits_skipped;
        }
        // the limits hold: to the slop of an overlap, and what a step swings beyond
        for (std::size_t i = 0; i < 3; ++i) {
            const Real q = coordinate(scene.bodies.x, scene.placed[4 + i].joint);
            CHECK(q > -1.4);
            CHECK(q < 1.0);
        }
        return scene.bodies.x;
    };
    int some = 0, none = 0;
    JointSweeps<AllBodies> sweeps;
    sweeps.solver.sweeps.max_sweeps = 100;
    const VecX lean = swing(sweeps, true, some), full = swing(sweeps, false, none);
    CHECK(lean == full);
    CHECK(some > 1000);
    CHECK(none == 0);
    // found exactly, their rows are factored in another order: rounding, that five seconds of a triple pendulum grow
    CHECK((swing(Exact{}, true, some) - swing(Exact{}, false, none)).cwiseAbs().maxCoeff() <= 1e-8);
}

TEST_CASE("a limit holds where the motor of another joint begins", "[idea]")
{
    // an upper arm at rest is turned at 50 rad/s at once: by its inertia the forearm turns back by 2.5 times as much
    for (const bool spring : {false, true})
        for (const bool skip : {true, false}) {
            CAPTURE(spring, skip);
            JointedScene scene;
            scene.gravity = {0, 0};
            for (const Real x : {0.5, 1.5}) add_body(scene, capsule(1, 0), thin_rod(1, 1), {x, 0});
            RigidJoint shoulder = joint_at(scene, JointKind::revolute, world, 0, {0, 0});
            if (spring) shoulder.spring = {0, 0, 1e5, 0, 1};
            else shoulder.motor.speed = 50, shoulder.motor.force = 1e6;
            add_joint(scene, shoulder);
            RigidJoint elbow = joint_at(scene, JointKind::revolute, 0, 1, {1, 0});
            elbow.lower = -0.3, elbow.upper = 0.3;
            add_joint(scene, elbow);
            Exact method;
            method.contacts.skip_far_limits = skip;
            StepData<3> now;
            step(scene, {}, method, now);
            CHECK(now.solution.status == Status::solved);
            CHECK(scene.bodies.velocity(0)[2] > 10);
            // an angle is linear in x: to rounding
            CHECK(coordinate(scene.bodies.x, scene.placed[1].joint) >= -0.3 - 1e-9);
            CHECK(method.contacts.limits_skipped == 0);
        }
    // at rest, without a motor that begins, far limits have no rows
    JointedScene scene;
    scene.gravity = {0, 0};
    for (const Real x : {0.5, 1.5}) add_body(scene, capsule(1, 0), thin_rod(1, 1), {x, 0});
    RigidJoint shoulder = joint_at(scene, JointKind::revolute, world, 0, {0, 0});
    shoulder.motor.force = 1e6;  // its speed is 0
    add_joint(scene, shoulder);
    RigidJoint elbow = joint_at(scene, JointKind::revolute, 0, 1, {1, 0});
    elbow.lower = -0.3, elbow.upper = 0.3;
    add_joint(scene, elbow);
    Exact method;
    StepData<3> now;
    step(scene, {}, method, now);
    CHECK(method.contacts.limits_skipped == 2);
}

TEST_CASE("a knock counts as its impulse over the sub-step and a load as what it is", "[idea]")
{
    // a body that moves at 2 m/s is caught by its pin in one step; then it hangs there
    for (const int substeps : {1, 2, 8}) {
        JointedScene scene;
        add_body(scene, box(1, 1), Mass{3, {0, 0}, 0.5}, {0, 0});
        add_joint(scene, joint_at(scene, JointKind::revolute, world, 0, {0, 0}));
        const Vec2 g = scene.gravity;
        scene.bodies.u[0] = 2;
        Exact method;
        StepData<3> now;
        const Real h = 1.0 / 60 / substeps;
        step(scene, {.h = h}, method, now);
        CHECK(reaction(scene, now, 0).force.x() == Approx(-3 * 2 / h).epsilon(1e-12));
        step(scene, {.h = h}, method, now);
        CHECK(reaction(scene, now, 0).force.y() == Approx(-3 * g.y()).epsilon(1e-9));  // rounding over h
    }
}

TEST_CASE("the bound of a friction joint holds along x and along y each", "[idea]")
{
    for (const Vec2& way : {Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)}) {
        JointedScene scene;
        scene.gravity = {0, 0};
        add_body(scene, box(1, 1), 2, {0, 0});  // 2 kg
        RigidJoint brake = joint_at(scene, JointKind::friction, world, 0, {0, 0});
        brake.motor.force = 10;
        brake.torque = 1;
        add_joint(scene, brake);
        scene.bodies.velocity(0) << 5 * way, 0;
        Exact method;
        StepData<3> now;
        step(scene, {.h = 0.01}, method, now);
        // a solve to rounding over h
        CHECK((reaction(scene, now, 0).force + 10 * way).norm() <= 1e-9);
    }
}

TEST_CASE("a joint that bears too much breaks and its rows are gone", "[house]")
{
    JointedScene scene;
    add_body(scene, box(1, 1), 1.0, {0, 0});
    RigidJoint hook = joint_at(scene, JointKind::revolute, world, 0, {0, 0.5});
    hook.breaking_force = 9.7;  // it weighs 9.81 N
    add_joint(scene, hook);
    Exact method;
    StepData<3> now;
    step(scene, {}, method, now);
    CHECK(scene.placed[0].broken);
    CHECK(method.contacts.broken == 1);
    for (int i = 0; i < 60; ++i) step(scene, {}, method, now);
    CHECK(now.rows.empty());
    CHECK(scene.bodies.x[1] < -4.8);  // half of g after a second
}

TEST_CASE("a joint breaks by what it bears in any sub-step of a step", "[idea]")
{
    // a body at 2 m/s is caught by its pin in the first sub-step, which takes 3 kg · 2 m/s; then it hangs there
    for (const int substeps : {1, 4})
        for (const Real share : {0.9, 1.1}) {
            CAPTURE(substeps, share);
            JointedScene scene;
            add_body(scene, box(1, 1), Mass{3, {0, 0}, 0.5}, {0, 0});
            RigidJoint pin = joint_at(scene, JointKind::revolute, world, 0, {0, 0});
            const Real h = 1.0 / 60, knock = 3 * 2 / (h / substeps);
            pin.breaking_force = share * knock;
            add_joint(scene, pin);
            scene.bodies.u[0] = 2;
            Exact method;
            StepData<3> now;
            step(scene, {.h = h, .substeps = substeps}, method, now);
            CHECK(scene.placed[0].broken == (share < 1));
            CHECK(method.contacts.broken == (share < 1 ? 1 : 0));
            CHECK(scene.bodies.x[0] == Approx(0).margin(1e-9));  // it held to the end of the step
            if (substeps > 1)  // what is read is the last sub-step's; rounding over h
                CHECK(reaction(scene, now, 0).force.norm() == Approx(3 * 9.81).epsilon(1e-6));
            step(scene, {.h = h, .substeps = substeps}, method, now);
            CHECK(method.contacts.broken == 0);
            CHECK(now.rows.empty() == (share < 1));
        }
}

// ---- exercises

TEST_CASE("a door that is caught at two thirds of its width spares its pin", "[idea]")
{
    for (const Real share : {1.0 / 3, 2.0 / 3, 1.0}) {
        JointedScene scene;
        scene.gravity = {0, 0};
        add_body(scene, capsule(1, 0), thin_rod(1, 3), {0.5, 0});
        add_joint(scene, joint_at(scene, JointKind::revolute, world, 0, {0, 0}));
        RigidJoint rope;
        rope.kind = JointKind::rope;
        rope.at_a = {share, -1}, rope.at_b = {share - 0.5, 0};
        rope.length = 1;
        add_joint(scene, rope);
        scene.bodies.velocity(0) << 0, 0.5, 1;
        Exact method;
        StepData<3> now;
        step(scene, {.h = 0.01}, method, now);
        // the rope has m L² ω/3 about the hinge, and the pin what that is short of m ω L/2; to rounding over h
        CHECK(std::abs(scene.bodies.u[2]) <= 1e-12);
        CHECK(std::abs(reaction(scene, now, 0).force.y() - (1 / share - 1.5) / 0.01) <= 1e-10);
    }
}

TEST_CASE("two pins are a weld and have one row too many", "[idea]")
{
    for (const bool weld : {true, false}) {
        JointedScene scene;
        for (int k = 0; k < 2; ++k) add_body(scene, box(1, 1), 1.0, {1.0 * k, 0});
        if (weld) add_joint(scene, joint_at(scene, JointKind::weld, 0, 1, {0.5, 0}));
        else
            for (const Real y : {-0.3, 0.4})
                add_joint(scene, joint_at(scene, JointKind::revolute, 0, 1, {0.5, y}));
        std::vector<Row<3>> rows;
        for (const PointJoint& joint : scene.joints)
            rows.push_back(bilateral(joint_constraint(scene.bodies.x, joint), scene.bodies.inverse_mass));
        CHECK(solve_rows(rows, scene.bodies.u).rank == 3);
        CHECK(static_cast<int>(rows.size()) == (weld ? 3 : 4));
    }
}

// ---- order

TEST_CASE("what floats on joints keeps its momentum to rounding and its angular momentum to first order in h",
          "[idea]")
{
    std::vector<Real> drifts;
    for (const Real h : {0.01, 0.005, 0.0025, 0.00125, 0.000625}) {
        JointedScene scene;
        scene.gravity = {0, 0};
        for (int k = 0; k < 4; ++k) {
            add_body(scene, box(0.8, 0.3), 2, {static_cast<Real>(k), 0.1 * k});
            scene.bodies.velocity(k) << 0.3 * k, 0.5 - 0.2 * k, 0.7 * k - 1;
        }
        for (Index k = 1; k < 4; ++k)
            add_joint(scene, joint_at(scene, k == 2 ? JointKind::prismatic : JointKind::revolute, k - 1, k,
                                      {static_cast<Real>(k) - 0.5, 0}));
        RigidJoint motor = scene.placed[0].joint;  // an inner torque
        motor.motor.speed = 1, motor.motor.force = 3;
        add_joint(scene, motor);
        ExactJoints<AllBodies> method;
        method.correction.method = Stabilizer::none;  // to repay errors changes it as well
        const Vec<3> before = momenta(scene.bodies);
        run(scene, method, h, std::lround(0.5 / h));
        const Vec<3> change = momenta(scene.bodies) - before;
        // rounding of momenta of about 1 in up to 800 steps
        CHECK(change.head<2>().cwiseAbs().maxCoeff() <= 1e-12);
        drifts.push_back(std::abs(change[2]));
    }
    for (const Real drift : drifts) UNSCOPED_INFO(drift);
    CHECK(drifts.front() > 1e-9);
    CHECK(std::abs(order_of(drifts) - 1) <= 0.15);  // 1.01 was measured
}

// ---- properties

TEST_CASE("a joint that makes no sense is refused with a sentence that names it", "[house]")
{
    const auto says = [](const std::function<void(RigidJoint&)>& change) {
        JointedScene scene;
        for (int k = 0; k < 2; ++k) add_body(scene, box(1, 1), 1.0, {2.0 * k, 0});
        add_body(scene, box(1, 1), Mass{}, {5, 0});
        RigidJoint joint;
        joint.a = 0, joint.b = 1;
        change(joint);
        return sentence_of([&] { add_joint(scene, joint); });
    };
    CHECK(says([](RigidJoint&) {}) == "accepted");
    CHECK(says([](RigidJoint& joint) { joint.at_a.x() = NAN; }) ==
          "the revolute joint 0 has a frame, a length, a ratio, a speed or a target that is not finite");
    CHECK(says([](RigidJoint& joint) { joint.b = 0; }) ==
          "the revolute joint 0 joins body 0 to itself; it needs two bodies");
    CHECK(says([](RigidJoint& joint) { joint.b = 3; }) ==
          "the revolute joint 0 joins bodies 0 and 3 among 3; only its a may be the world (-1)");
    CHECK(says([](RigidJoint& joint) { joint.a = world, joint.b = 2; }) ==
          "the revolute joint 0 joins bodies -1 and 2, which cannot move; one of them must have a mass");
    CHECK(says([](RigidJoint& joint) { joint.lower = 1, joint.upper = 0.5; }) ==
          "the revolute joint 0 has the lower limit 1 and the upper 0.5; lower must not be above upper");
    CHECK(says([](RigidJoint& joint) { joint.lower = joint.upper = infinity; }) ==
          "the revolute joint 0 has the limits inf and inf; no number is between them");
    CHECK(says([](RigidJoint& joint) {
              joint.at_b = {0, 1e76};
          }) == "the revolute joint 0 has a frame, a length or a ratio of 1e+76; none may be beyond 1e75");
    for (const auto beyond : {&RigidJoint::lower, &RigidJoint::upper})
        CHECK(says([beyond](RigidJoint& joint) {
                  joint.*beyond = beyond == &RigidJoint::upper ? 1e80 : -1e80;
              }).find("the revolute joint 0 has a limit or a target of ") == 0);
    CHECK(says([](RigidJoint& joint) { joint.spring.target = 1e80; }) ==
          "the revolute joint 0 has a limit or a target of 1e+80; none may be beyond 1e75, but a "
          "limit that "
          "is infinite");
    CHECK(says([](RigidJoint& joint) { joint.kind = JointKind::distance, joint.upper = -1; }) ==
          "the distance joint 0 has the upper limit -1; no distance is below 0");
    CHECK(says([](RigidJoint& joint) { joint.spring.stiffness = -2; }) ==
          "the revolute joint 0 has the stiffness -2; it must be zero or positive and finite");
    CHECK(says([](RigidJoint& joint) {
              joint.axis = {1, 1};
          }) == "the revolute joint 0 has an axis of the length 1.4142135623730951; it must be 1");
    CHECK(says([](RigidJoint& joint) {
              joint.kind = JointKind::weld;
              joint.upper = 1;
          }) ==
          "the weld joint 0 has limits, a motor or a spring; it has no coordinate that they could act on");
    CHECK(says([](RigidJoint& joint) { joint.kind = JointKind::mouse; }) ==
          "the mouse joint 0 pulls by a spring of no stiffness and no damping; give it one");
    const auto idle = [&](JointKind kind, const std::function<void(RigidJoint&)>& set) {
        return says([&](RigidJoint& joint) {
            joint.kind = kind;
            if (kind != JointKind::friction) joint.spring.stiffness = 1;
            set(joint);
        });
    };
    const std::string pull =
        " that does nothing; it has the stiffness, the damping and the force of its spring";
    CHECK(idle(JointKind::mouse, [](RigidJoint& joint) { joint.torque = 3; }) ==
          "the mouse joint 0 has a setting of 3" + pull);
    CHECK(idle(JointKind::motor, [](RigidJoint& joint) { joint.spring.target = -1; }) ==
          "the motor joint 0 has a setting of -1" + pull + ", and a torque");
    CHECK(idle(JointKind::friction, [](RigidJoint& joint) { joint.motor.speed = 2; }) ==
          "the friction joint 0 has a setting of 2 that does nothing; it has the force of its motor, and a "
          "torque");
    for (const auto& set :
         {+[](RigidJoint& joint) { joint.motor.speed = 2; },
          +[](RigidJoint& joint) { joint.spring.target = 2; },
          +[](RigidJoint& joint) { joint.motor.force = 2; },
          +[](RigidJoint& joint) { joint.spring.force = 2; },
          +[](RigidJoint& joint) { joint.spring.stiffness = 2; },
          +[](RigidJoint& joint) { joint.spring.damping = 2; }, +[](RigidJoint& joint) { joint.torque = 2; }})
        for (const JointKind kind : {JointKind::mouse, JointKind::motor, JointKind::friction}) {
            RigidJoint alone;
            set(alone);
            const bool pulls = alone.spring.force + alone.spring.stiffness + alone.spring.damping > 0,
                       acts = kind == JointKind::friction
                                  ? alone.motor.force + alone.torque > 0
                                  : pulls || (kind == JointKind::motor && alone.torque > 0);
            CHECK((idle(kind, set).find("that does nothing") == std::string::npos) == acts);
        }
}

TEST_CASE("bad joints and changes of joints are refused with a sentence and leave the scene as it was",
          "[house]")
{
    JointedScene scene = chain_scene({3, 1, 1, 1, 0});
    const auto refused = [&](const std::function<void()>& act) {
        const std::size_t joints = scene.joints.size(), placed = scene.placed.size();
        const std::string said = sentence_of(act);
        CHECK(scene.joints.size() == joints);
        CHECK(scene.placed.size() == placed);
        return said;
    };
    RigidJoint joint = scene.placed[1].joint;
    joint.motor.force = 1;
    CHECK(
        refused([&] { change_joint(scene, 1, joint); }) ==
        "joint 1 has 2 rows and would have 3; a joint keeps its kind, its bodies and the number of its rows");
    // no place in a body that there is not
    CHECK(refused([&] {
              joint_at(scene, JointKind::revolute, 0, 9, {0, 0});
          }) == "there is no body 9 among 4");
    CHECK(refused([&] { local_point(scene, -2, {0, 0}); }) == "there is no body -2 among 4");
    CHECK(refused([&] {
              add_joint(scene, joint_at(scene, JointKind::revolute, 0, world, {0, 0}));
          }) == "the revolute joint 4 joins bodies 0 and -1 among 4; only its a may be the world (-1)");
    joint = scene.placed[1].joint;
    joint.upper = NAN;
    CHECK(refused([&] { change_joint(scene, 1, joint); }) ==
          "the revolute joint 1 has the lower limit -inf and the upper nan; lower must not be above upper");
    joint = scene.placed[1].joint;
    joint.motor.force = -2;
    CHECK(refused([&] { add_joint(scene, joint); }) ==
          "the revolute joint 4 has the motor force -2; it must be zero or positive");
    joint.motor = {NAN, 1, 0, 0, 0};
    CHECK(refused([&] { add_joint(scene, joint); }) ==
          "the revolute joint 4 has a frame, a length, a ratio, a speed or a target that is not finite");
    joint = scene.placed[1].joint;
    joint.kind = JointKind::distance;
    joint.length = -1;
    CHECK(refused([&] { add_joint(scene, joint); }) ==
          "the distance joint 4 has the length -1; it must be zero or positive and finite");
    joint.length = 1;
    joint.breaking_force = NAN;
    CHECK(refused([&] { add_joint(scene, joint); }) ==
          "the distance joint 4 has the breaking force nan; it must be zero or positive");
}
