/// Chapter 15: linkages with loops, and dolls.

#include "chapters/14_joints/bar_linkages.hpp"
#include "chapters/14_joints/ragdoll.hpp"
#include "chapters/15_trees/tree_method.hpp"

#include "tests/catch.hpp"
#include "tests/joint_run.hpp"
#include "tests/sentence.hpp"

using namespace rigid;

TEST_CASE("a four-bar linkage keeps its energy for ten seconds also through the line of all its bars",
          "[idea]")
{
    for (const int cranks : {2, 3})  // with three a row and a half too many hold the bar at all times
        for (const Real angle : {0.0, 1.0}) {
            JointedScene scene = cranks_scene(cranks, angle, 8);
            JointRattle<AllBodies> method;
            // near the line of all bars: more than 3 (h ω / 2)², half a step's angle (section 15.B)
            method.solver.joints.rank_tolerance = 1e-5;
            const Real before = energy(scene);
            Real largest = 0;
            StepData<3> now;
            for (int i = 0; i < 10 * 4000; ++i) {
                step(scene, {.h = 1.0 / 4000}, method, now);
                largest = std::max(largest, std::abs(energy(scene) - before));
                REQUIRE(scene.bodies.x.allFinite());
            }
            INFO("cranks " << cranks << ", angle " << angle);
            // of the kinetic energy at the start
            const Real kinetic = 64.0 / 2 * (1 + cranks / 3.0);
            CHECK(largest <= 1e-3 * kinetic);
        }
}

TEST_CASE("parallel cranks have as many rows too many as the exercise says", "[house]")
{
    for (const int cranks : {2, 3, 4, 6}) {
        const JointedScene scene = cranks_scene(cranks, 1, 0);
        std::vector<Row<3>> rows;
        for (const PointJoint& joint : scene.joints)
            rows.push_back(bilateral(joint_constraint(scene.bodies.x, joint), scene.bodies.inverse_mass));
        const RowsAnswer answer = solve_rows(rows, scene.bodies.u);
        CHECK(static_cast<int>(rows.size()) - answer.rank == cranks - 2);
    }
}

TEST_CASE("the piston of an engine is where its crank says", "[idea]")
{
    JointedScene scene = engine_scene(10, 1e4);
    JointTrees<AllBodies> method;
    method.correction.tolerance = 1e-12;
    StepData<3> now;
    for (int i = 0; i < 480; ++i) {
        step(scene, {.h = 1.0 / 240}, method, now);
        const Real theta = scene.bodies.x[2];
        CHECK(std::abs(scene.bodies.x[6] - piston_by_hand(theta)) <= 1e-10);  // B6: joints to 1e-12 of 0.1 m
    }
    CHECK(scene.bodies.x[2] > 10);  // it turns
}

TEST_CASE("a walking leg of seven bodies moves as its inertia about the crank says", "[idea]")
{
    const Real start = 0.4, spin = 6;
    const auto built = [](Real angle) {
        JointedScene scene;
        scene.gravity = {0, 0};
        add_jansen_leg(scene, angle);
        return scene;
    };
    // dx/dθ of all bodies from the geometry alone, by differences
    const auto slopes = [&](Real angle) -> VecX {
        const Real d = 1e-5;
        VecX change = built(angle + d).bodies.x - built(angle - d).bodies.x;
        for (Index k = 0; k < change.size() / 3; ++k)
            change[3 * k + 2] = std::remainder(change[3 * k + 2], 2 * pi);
        return change / (2 * d);
    };
    const VecX masses = built(start).bodies.inverse_mass.cwiseInverse();
    const auto inertia = [&](Real angle) { return slopes(angle).cwiseAbs2().dot(masses); };
    // without gravity ½ I(θ) ω² stays: dθ/dt = ω₀ √(I₀ / I(θ)), by Runge-Kutta
    const Real first = inertia(start);
    const auto rate = [&](Real angle) { return spin * std::sqrt(first / inertia(angle)); };
    Real theta = start;
    for (int i = 0; i < 200; ++i) {
        const Real h = 1.0 / 200, k1 = rate(theta), k2 = rate(theta + h / 2 * k1),
                   k3 = rate(theta + h / 2 * k2), k4 = rate(theta + h * k3);
        theta += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    JointedScene scene = built(start);
    scene.bodies.u = spin * slopes(start);
    JointRattle<AllBodies> method;
    run(scene, method, 1.0 / 2000, 2000);
    CHECK(method.correction.not_converged == 0);
    CHECK(std::abs(scene.bodies.x[2] - theta) <= 1e-4);  // asked for
}

TEST_CASE("dolls on stairs stay together and finite", "[idea]")
{
    JointedScene scene;
    add_stairs(scene, 8);
    std::vector<std::pair<Index, Index>> pairs;
    for (int i = 0; i < 3; ++i)
        forbid_itself(add_ragdoll(scene, {-0.1 + 0.15 * i, 3.4 + 1.8 * i}), [&pairs](Index a, Index b) {
            pairs.push_back({a, b});
        });
    cover(scene, {0.6, 0, 0, 0});
    JointTrees<Manifolds> method;
    method.contacts.finder.filter = forbid_pairs(scene.bodies.count(), pairs);
    never_stop(method.contacts);
    const Real worst = run(scene, method, 1.0 / 60, 600, 2);
    CHECK(worst <= 0.01 * 0.22);  // 1 % of the shortest limb
    CHECK(scene.bodies.x.allFinite());
}

TEST_CASE("an overstepped limit is corrected as fast in a world of kilometres", "[idea]")
{
    for (const Real length : {1.0, 1000.0}) {
        JointedScene scene;
        scene.gravity = {0, 0};
        scene.length = length;
        add_body(scene, box(0.5 * length, 0.1 * length), 1.0, {0.25 * length, 0});
        RigidJoint pin = joint_at(scene, JointKind::revolute, world, 0, {0, 0});
        pin.lower = 0.5;  // radians, whatever a metre is
        add_joint(scene, pin);
        JointTrees<AllBodies> method;
        StepData<3> now;
        for (int i = 0; i < 40; ++i) step(scene, {}, method, now);
        // 0.5 · 0.8⁴⁰ is less than a thousandth, and the slop is 0.005
        CHECK(coordinate(scene.bodies.x, pin) > 0.494);
    }
}

TEST_CASE("joints that contradict each other leave bodies where they are or at least finite", "[house]")
{
    JointedScene scene;
    add_body(scene, box(1, 1), 1.0, {0, 0});
    add_body(scene, box(1, 1), 1.0, {3, 0});
    // one body welded to two places, the other on motors that want different speeds and a link of no length
    add_joint(scene, joint_at(scene, JointKind::weld, world, 0, {0, 0}));
    RigidJoint elsewhere = joint_at(scene, JointKind::weld, world, 0, {0, 0});
    elsewhere.at_a = {0.1, 0};
    add_joint(scene, elsewhere);
    for (const Real speed : {1.0, -2.0}) {
        RigidJoint axle = joint_at(scene, JointKind::revolute, world, 1, {3, 0});
        axle.motor = {speed, 5, 0, 0, 0};
        axle.lower = -0.5, axle.upper = 0.5;
        add_joint(scene, axle);
    }
    RigidJoint link = joint_at(scene, JointKind::distance, 0, 1, {1.5, 0});
    link.length = 0;
    add_joint(scene, link);
    JointTrees<AllBodies> method;
    StepData<3> now;
    for (int i = 0; i < 300; ++i) {
        step(scene, {}, method, now);
        REQUIRE(scene.bodies.x.allFinite());
        CHECK(scene.bodies.u.norm() < 100);
        CHECK((scene.bodies.position(0).head<2>()).norm() < 1);
    }
}

TEST_CASE("limbs that are never stopped have their rows before they come", "[idea]")
{
    // dolls strike a fixed box at 6 m/s: 5 cm in half a step of 1/60 s
    const auto deepest = [](Real ahead, Real height) {
        JointedScene scene;
        add_body(scene, box(4, 1), Mass{}, {0, -0.5});
        std::vector<std::pair<Index, Index>> pairs;
        const Index first = add_ragdoll(scene, {0.1, height});
        for (Index k = first; k < scene.bodies.count(); ++k) scene.bodies.velocity(k) << 2, -6, 0;
        forbid_itself(first, [&pairs](Index a, Index b) { pairs.push_back({a, b}); });
        cover(scene, {0.6, 0, 0, 0});
        JointTrees<Manifolds> method;
        auto& touching = method.contacts;
        touching.finder.filter = forbid_pairs(scene.bodies.count(), pairs);
        never_stop(touching);
        if (ahead == 0) touching.ahead = 0;
        StepData<3> now;
        Real most = 0;
        for (int i = 0; i < 60; ++i) {
            step(scene, {.h = 1.0 / 60, .substeps = 2}, method, now);
            // body 0 is the box: rows that push at it are its contacts
            for (const Constraint<3>& c : now.constraints)
                if (c.kind == ConstraintKind::unilateral && c.a == 0) most = std::max(most, -c.C);
        }
        return most;
    };
    Real without = 0, with = 0;
    for (const Real height : {1.5, 1.52, 1.54, 1.56, 1.58}) {
        without = std::max(without, deepest(0, height));
        with = std::max(with, deepest(1, height));
    }
    CHECK(without > 0.03);
    // what swings farther in a step than its inner radius of 4 or 5 cm still comes too deep, but by less: 2.0 and 5.7 cm
    CHECK(with < without / 2);
}
