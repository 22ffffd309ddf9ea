/// Chapter 19: what a body is and what acts on it, and that each change of it is saved, recorded and wakes what it concerns.

#include "chapters/19_engine/recording.hpp"
#include "chapters/19_engine/world.hpp"

#include "common/random.hpp"
#include "tests/catch.hpp"
#include "tests/world_run.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace rigid;
using Catch::Contains;

namespace what_bodies_are {  // sources of one target are compiled together

namespace {

using worlds::body_at;
using worlds::frame;
using worlds::run;
const Vec2 none(0, 0);

/// Two boxes on the ground that sleep, the second on the first, and a third beside them.
struct Asleep {
    World engine;
    BodyId below, above, beside;
    WallId ground;

    Asleep()
    {
        ground = engine.add_wall({{0, 1}, 0});
        below = engine.add_body(body_at({0, 0.5}));
        above = engine.add_body(body_at({0, 1.5}));
        beside = engine.add_body(body_at({5, 0.5}));
        run(engine, 90);
        REQUIRE(engine.work().awake == 0);
    }
};

}  // namespace

TEST_CASE("a body falls by its own share of gravity", "[idea]")
{
    World engine;
    std::vector<BodyId> all;
    const Real shares[] = {1, 0, 0.5, -1, 3};
    for (int i = 0; i < 5; ++i) {
        BodyDefinition ball = body_at({3.0 * i, 0}, 2, disc(0.3));
        ball.gravity_scale = shares[i];
        all.push_back(engine.add_body(ball));
    }
    run(engine, 30);
    for (std::size_t i = 0; i < 5; ++i) {
        // symplectic Euler: y = −s g h² n (n + 1)/2
        CHECK(engine.position(all[i]).y() ==
              Approx(-shares[i] * 9.81 * frame * frame * 30 * 31 / 2).margin(1e-12));
        CHECK(engine.gravity_scale(all[i]) == shares[i]);
    }
    engine.set_gravity_scale(all[1], 2);
    engine.step(frame);
    CHECK(engine.velocity(all[1]).y() == Approx(-2 * 9.81 * frame));
}

TEST_CASE("what falls faster than gravity lies on the ground no deeper", "[idea]")
{
    for (const Real share : {1.0, 10.0, 40.0}) {
        World engine;
        engine.add_wall({{0, 1}, 0});
        engine.add_body(body_at({0, 0.5}, 0));
        BodyDefinition falls = body_at({0, 1 + 0.5 + 0.4 * share * 9.81 * frame * frame});
        falls.gravity_scale = share;
        const BodyId it = engine.add_body(falls);
        Real lowest = 2;
        for (int n = 0; n < 60; ++n) {
            engine.step(frame);
            lowest = std::min(lowest, engine.position(it).y());
        }
        // it looks as far ahead as it falls in the step: no deeper than the slop
        CHECK(lowest > 1.5 - 0.0051);
    }
}

TEST_CASE("drag takes from a velocity what the implicit step says at every length of the step", "[idea]")
{
    for (const int substeps : {1, 4}) {
        World engine({.gravity = none, .substeps = substeps});
        BodyDefinition ball = body_at({0, 0}, 2, disc(0.3));
        ball.velocity = {3, 1};
        ball.spin = 5;
        ball.linear_damping = 2;
        ball.angular_damping = 30;
        const BodyId it = engine.add_body(ball);
        run(engine, 20);
        const Real part = frame / substeps;
        CHECK(engine.velocity(it).x() == Approx(3 * std::pow(1 + 2 * part, -20 * substeps)).epsilon(1e-13));
        CHECK(engine.spin(it) == Approx(5 * std::pow(1 + 30 * part, -20 * substeps)).epsilon(1e-13));
    }
    // g/d is where it does not change any more, whatever the step; explicit steps of 2/d and more would swing
    World engine;
    const BodyId it = engine.add_body(body_at({0, 0}, 2, disc(0.3)));
    engine.set_damping(it, 4, 0);
    for (int n = 0; n < 60; ++n) engine.step(0.6);
    CHECK(engine.velocity(it).y() == Approx(-9.81 / 4).epsilon(1e-12));
    CHECK(engine.linear_damping(it) == 4);
}

TEST_CASE("what drag stops falls asleep without gravity and what nothing stops does not", "[idea]")
{
    World engine({.gravity = none});
    BodyDefinition ball = body_at({0, 0}, 1, disc(0.3));
    ball.velocity = {2, 0};
    ball.spin = 3;
    ball.linear_damping = ball.angular_damping = 2;
    const BodyId slows = engine.add_body(ball);
    ball.position = {0, 5};
    ball.velocity = {5e-4, 0};  // slower than what may sleep
    ball.spin = 0;
    ball.linear_damping = ball.angular_damping = 0;
    const BodyId goes_on = engine.add_body(ball);
    run(engine, 600);
    CHECK_FALSE(engine.is_awake(slows));
    CHECK(engine.is_awake(goes_on));
    // Σ h u_n = u₀/d, the step that is not taken after sleep left out: below v_rest/d
    CHECK(engine.position(slows).x() == Approx(1).margin(1e-3 / 2));
}

TEST_CASE("a lasting force and torque act in each step until they are set again", "[idea]")
{
    World engine({.gravity = none});
    const BodyId it = engine.add_body(body_at({0, 0}, 2));  // 2 kg, 1/3 kg m²
    engine.set_force(it, {4, -1}, 0.5);
    run(engine, 60);
    CHECK(engine.velocity(it).x() == Approx(2));
    CHECK(engine.velocity(it).y() == Approx(-0.5));
    CHECK(engine.spin(it) == Approx(1.5));
    CHECK(engine.force(it) == Vec2(4, -1));
    CHECK(engine.torque(it) == 0.5);
    engine.set_force(it, none);
    run(engine, 60);
    CHECK(engine.velocity(it).x() == Approx(2));
    CHECK(engine.spin(it) == Approx(1.5));
}

TEST_CASE("a box slides under a lasting force as soon as friction cannot hold it", "[idea]")
{
    for (const Real share : {0.95, 1.05}) {
        World engine;
        engine.add_wall({{0, 1}, 0}, {0.5, 0, 0, 0});
        BodyDefinition body = body_at({0, 0.5}, 3);
        body.surface = {0.5, 0, 0, 0};
        const BodyId it = engine.add_body(body);
        run(engine, 60);
        REQUIRE_FALSE(engine.is_awake(it));
        engine.set_force(it, {share * 0.5 * 3 * 9.81, 0});
        run(engine, 60);
        // μ m g is the bound: below it nothing moves, above it the rest accelerates
        if (share < 1) CHECK(std::abs(engine.position(it).x()) < 1e-6);
        else CHECK(engine.velocity(it).x() == Approx(0.05 * 0.5 * 9.81).epsilon(1e-3));
    }
}

TEST_CASE("a body of fixed rotation is pushed and never turned", "[idea]")
{
    World engine;
    engine.add_wall({{0, 1}, 0});
    BodyDefinition tall = body_at({0, 1}, 1, box(0.4, 2));
    tall.fixed_rotation = true;
    const BodyId it = engine.add_body(tall);
    for (int n = 0; n < 60; ++n) {
        engine.push(it, {0.05, 0}, {0, 2});
        engine.step(frame);
        REQUIRE(engine.angle(it) == 0);
    }
    CHECK(engine.velocity(it).x() != 0);
    CHECK(engine.inertia(it) == infinity);
    CHECK(engine.mass(it) == Approx(0.8));
    engine.set_fixed_rotation(it, false);  // now it topples
    engine.push(it, {3, 0}, {0, 2});
    run(engine, 60);
    CHECK(std::abs(engine.angle(it)) > 0.5);
    CHECK(engine.inertia(it) < 1);
    engine.set_fixed_rotation(it, true);
    CHECK(engine.spin(it) == 0);
}

TEST_CASE("joints hold bodies of fixed rotation as far as anything can move", "[idea]")
{
    for (const JointKind kind : {JointKind::revolute, JointKind::weld, JointKind::prismatic, JointKind::wheel,
                                 JointKind::distance}) {
        World engine;
        BodyDefinition hung = body_at({1, 0});
        hung.fixed_rotation = true;
        const BodyId first = engine.add_body(hung);
        hung.position = {2, 0};
        const BodyId second = engine.add_body(hung);
        RigidJoint to_world = engine.joint_at(kind, {}, first, {1, 0}),
                   between = engine.joint_at(kind, first, second, {1.5, 0});
        for (RigidJoint* joint : {&to_world, &between}) {
            joint->collide_connected = false;
            if (kind == JointKind::revolute)
                joint->lower = -0.1, joint->upper = 0.1, joint->motor = {1, 5, 0, 0, 0};
            if (kind == JointKind::distance) joint->at_b.x() += 0.5, joint->length = 0.5;
        }
        const JointId a = engine.add_joint({}, first, to_world);
        const JointId b = engine.add_joint(first, second, between);
        run(engine, 120);
        INFO(to_string(kind));
        for (const BodyId it : {first, second}) {
            CHECK(engine.position(it).allFinite());
            CHECK(engine.angle(it) == 0);
        }
        CHECK(engine.error(a) < 1e-3);
        CHECK(engine.error(b) < 1e-3);
        CHECK(engine.work().held == 0);
    }
}

TEST_CASE("a kinematic body is at its target after the step whatever the number of sub-steps", "[idea]")
{
    for (const int substeps : {1, 3, 4, 16}) {
        World engine({.substeps = substeps});
        const BodyId it = engine.add_body(body_at({0, 0}, 0, box(4, 0.2)));
        Random random(3);
        Vec2 at = none;
        for (int n = 0; n < 40; ++n) {
            const Real x = random.uniform(-0.05, 0.05), y = random.uniform(-0.05, 0.05),
                       angle = random.uniform(-0.1, 0.1);
            at += Vec2(x, y);
            engine.set_target(it, at, angle, frame);
            engine.step(frame);
            REQUIRE((engine.position(it) - at).norm() < 1e-14);
            REQUIRE(engine.angle(it) == Approx(angle).margin(1e-14));
        }
        World other = World::load(engine.save());
        for (World* one : {&engine, &other}) {
            one->set_target(it, at + Vec2(0.1, 0.2), 0.3, frame);
            if (one == &other) other = World::load(other.save());
            one->step(frame);
        }
        CHECK(engine.hash() == other.hash());
        at = engine.position(it);
        const Vec2 u = engine.velocity(it);
        engine.step(frame);  // and goes on as it went
        CHECK((engine.position(it) - (at + frame * u)).norm() < 1e-14);
    }
}

TEST_CASE("a block does not slip on a platform whose targets accelerate it", "[idea]")
{
    for (const int substeps : {1, 4, 16}) {
        World engine({.substeps = substeps});
        BodyDefinition body = body_at({0, -0.1}, 0, box(8, 0.2));
        const BodyId platform = engine.add_body(body);
        const BodyId block = engine.add_body(body_at({0, 0.5}));
        run(engine, 30);
        Real worst = 0;
        const Real start = engine.position(block).x();
        for (int n = 1; n <= 240; ++n) {
            const Real t = n * frame;
            engine.set_target(platform, {1.25 * t * t, -0.1}, 0,
                              frame);  // 2.5 m/s² of 5.9 that friction bears
            engine.step(frame);
            const Real slip = engine.position(block).x() - engine.position(platform).x() - start;
            worst = std::max(worst, std::abs(slip));
        }
        // the first step begins at rest with half the slope of those after it: it and the
        // second have a jump of a h/4 between them, and a slip of a h²/2 at most
        CHECK(worst < 2.5 * frame * frame / 2);
    }
}

TEST_CASE("a body that is switched off is met and found by nobody and goes on as it was", "[idea]")
{
    Asleep scene;
    World& engine = scene.engine;
    const BodyId sees = engine.add_body([] {
        BodyDefinition gate = body_at({0, 0.5}, 0, box(3, 3));
        gate.sensor = true;
        return gate;
    }());
    engine.step(frame);
    REQUIRE(engine.events().entered.size() == 2);
    engine.set_enabled(scene.below, false);
    CHECK_FALSE(engine.is_enabled(scene.below));
    CHECK(engine.mass(scene.below) == Approx(1));
    engine.set_velocity(scene.below, {7, 0}, 1);  // it waits
    run(engine, 1);
    CHECK(std::count(engine.events().left.begin(), engine.events().left.end(), Seen{sees, scene.below}) == 1);
    CHECK(engine.events().ended.size() >= 2);
    run(engine, 89);
    CHECK(engine.position(scene.above).y() == Approx(0.5).margin(0.006));  // it fell through
    CHECK((engine.position(scene.below) - Vec2(0, 0.5)).norm() < 0.006);
    CHECK_FALSE(engine.is_awake(scene.below));
    CHECK(engine.at({0.1, 0.45}).size() == 1);
    CHECK(engine.velocity(scene.below) == Vec2(7, 0));
    engine.move(scene.below, {0, 4}, 0);
    engine.set_enabled(scene.below, true);
    engine.step(frame);
    CHECK(engine.velocity(scene.below).x() == 7);
    CHECK(engine.spin(scene.below) == 1);
    CHECK(engine.is_awake(scene.below));

    // the ground that others lie on
    const BodyId slab = engine.add_body(body_at({20, 0.9}, 0, box(3, 0.2)));
    const BodyId lies = engine.add_body(body_at({20, 1.5}));
    run(engine, 120);
    REQUIRE_FALSE(engine.is_awake(lies));
    engine.set_enabled(slab, false);
    run(engine, 60);
    CHECK(engine.position(lies).y() == Approx(0.5).margin(0.006));
    engine.set_enabled(slab, true);
    CHECK(engine.at({20, 0.95}).size() == 2);
    engine.step(frame);
    CHECK(engine.is_awake(lies));  // the slab is in it
}

TEST_CASE("a joint of a body that is switched off holds nothing and holds again", "[idea]")
{
    World engine;
    const BodyId hook = engine.add_body(body_at({0, 0}, 1, disc(0.1)));
    const JointId nail = engine.add_joint({}, hook, engine.joint_at(JointKind::weld, {}, hook, {0, 0}));
    const BodyId hangs = engine.add_body(body_at({0, -1}, 1, disc(0.1)));
    const JointId pin =
        engine.add_joint(hook, hangs, engine.joint_at(JointKind::revolute, hook, hangs, {0, 0}));
    run(engine, 90);
    CHECK(engine.position(hangs).y() == Approx(-1).margin(1e-6));
    engine.set_enabled(hook, false);
    CHECK_FALSE(engine.is_broken(pin));
    run(engine, 30);
    CHECK(engine.position(hangs).y() < -2);
    CHECK(engine.events().broken.empty());
    CHECK(engine.force(pin) == none);
    engine.move(hangs, {0, -1}, 0);
    engine.set_velocity(hangs, none, 0);
    engine.set_enabled(hook, true);
    CHECK_FALSE(engine.is_broken(nail));
    run(engine, 60);
    CHECK(engine.position(hangs).y() == Approx(-1).margin(1e-6));
    CHECK(engine.force(pin).y() == Approx(engine.mass(hangs) * 9.81).epsilon(1e-6));
}

TEST_CASE("a joint of a body that is switched off is changed and added as if it were on", "[idea]")
{
    World engine;
    const BodyId bob = engine.add_body(body_at({0.5, 0}, 1, box(1, 0.1)));
    const JointId pin = engine.add_joint({}, bob, engine.joint_at(JointKind::revolute, {}, bob, {0, 0}));
    engine.step(frame);
    engine.set_enabled(bob, false);
    RigidJoint how = engine.joint(pin);
    how.lower = -0.5;
    engine.change(pin, how);
    RigidJoint rod;
    rod.kind = JointKind::rope;
    rod.at_a = {1, 10}, rod.at_b = {0.5, 0}, rod.length = 20;
    const JointId slack = engine.add_joint({}, bob, rod);
    CHECK_FALSE(engine.is_broken(slack));
    const Real q = engine.coordinate(pin);
    run(engine, 10);
    CHECK(engine.coordinate(pin) == q);
    engine.set_enabled(bob, true);
    run(engine, 120);
    CHECK(engine.coordinate(pin) == Approx(-0.5).margin(1e-4));
    // what cannot move when it is on needs another body that can
    engine.set_enabled(bob, false);
    engine.set_kind(bob, BodyKind::fixed);
    CHECK_THROWS_WITH(engine.add_joint({}, bob, rod), Contains("which cannot move"));
}

TEST_CASE("what stops being pushed stands at once and the hand lets go of it", "[idea]")
{
    World engine({.gravity = none, .substeps = 4});
    const BodyId it = engine.add_body(body_at({0, 0}));
    engine.set_velocity(it, {3, 1}, 2);
    run(engine, 3);
    const Vec2 at = engine.position(it);
    engine.set_kind(it, BodyKind::fixed);
    run(engine, 3);
    CHECK(engine.position(it) == at);
    CHECK(engine.velocity(it) == none);
    engine.set_kind(it, BodyKind::dynamic);
    engine.pull(it, {9, 9});
    run(engine, 3);
    CHECK(engine.velocity(it).x() > 0);
    engine.set_enabled(it, false);
    engine.set_enabled(it, true);
    const Vec2 u = engine.velocity(it);
    run(engine, 3);
    CHECK(engine.velocity(it) == u);
}

TEST_CASE("a body becomes another one in its place and under its name", "[idea]")
{
    Asleep scene;
    World& engine = scene.engine;
    SECTION("another shape")
    {
        engine.set_shape(scene.below, {{{3, 3}, {4, 3}, {4, 3.5}, {3, 3.5}}, 0});
        CHECK((engine.position(scene.below) - Vec2(0, 0.5)).norm() < 0.006);
        CHECK(engine.mass(scene.below) == Approx(1));
        run(engine, 120);
        CHECK(engine.position(scene.below).y() == Approx(0.25).margin(0.006));
        CHECK(engine.position(scene.above).y() == Approx(1).margin(0.011));
        CHECK_FALSE(engine.is_awake(scene.above));
        engine.set_density(scene.below, 4);
        CHECK(engine.mass(scene.below) == Approx(2));
        CHECK(engine.inertia(scene.below) == Approx(2 * (1 + 0.25) / 12));
    }
    SECTION("another mass")
    {
        engine.set_mass(scene.above, 50, 3);
        engine.step(frame);
        CHECK(engine.is_awake(scene.below));  // what bears it wakes
        CHECK_FALSE(engine.is_awake(scene.beside));
        CHECK(engine.mass(scene.above) == 50);
        CHECK(engine.inertia(scene.above) == 3);
        engine.set_velocity(scene.above, {0, 3}, 0);
        engine.push(scene.above, {50, 0}, engine.position(scene.above));
        CHECK(engine.velocity(scene.above).x() == 1);
    }
    SECTION("another kind")
    {
        CHECK(engine.kind(scene.above) == BodyKind::dynamic);
        engine.set_kind(scene.above, BodyKind::fixed);
        engine.remove(scene.below);
        run(engine, 30);
        CHECK(engine.position(scene.above).y() == Approx(1.5).margin(0.006));
        CHECK(engine.mass(scene.above) == infinity);
        CHECK(engine.kind(scene.above) == BodyKind::fixed);
        engine.set_velocity(scene.above, {1, 0}, 0);
        CHECK(engine.kind(scene.above) == BodyKind::kinematic);
        run(engine, 60);
        CHECK(engine.position(scene.above).x() == Approx(1).margin(1e-12));
        engine.set_kind(scene.above, BodyKind::dynamic);
        CHECK(engine.mass(scene.above) == Approx(1));
        run(engine, 60);
        CHECK(engine.position(scene.above).y() == Approx(0.5).margin(0.006));
        const BodyId wall = engine.add_body(body_at({20, 5}, 0));
        CHECK(engine.kind(wall) == BodyKind::fixed);
        CHECK_THROWS_WITH(engine.set_kind(wall, BodyKind::dynamic), Contains("no mass"));
        engine.set_density(wall, 2);
        run(engine, 90);
        CHECK(engine.position(wall).y() == Approx(0.5).margin(0.006));
    }
    SECTION("another surface of a wall")
    {
        engine.set_surface(scene.ground, {0.1, 0, 2, 0});  // a belt
        CHECK(engine.surface(scene.ground).belt == 2);
        run(engine, 60);
        CHECK(std::abs(engine.velocity(scene.beside).x()) > 0.1);
    }
}

TEST_CASE("bodies that have a filter each meet as their 64 bits say", "[idea]")
{
    World engine;
    std::vector<BodyId> ledges, balls;
    // 200 filters: ball i is let through by ledge i alone
    for (int i = 0; i < 200; ++i) {
        const std::uint64_t bit = std::uint64_t{1} << (i % 60 + 4);
        BodyDefinition ledge = body_at({2.0 * i, 0}, 0, box(1, 0.2));
        ledge.filter = {bit, ~std::uint64_t{0}, i + 1};
        ledges.push_back(engine.add_body(ledge));
        BodyDefinition ball = body_at({2.0 * i, 0.5}, 1, disc(0.2));
        ball.filter = {2, i % 2 ? ~bit : bit, -i - 1};
        balls.push_back(engine.add_body(ball));
    }
    run(engine, 60);
    for (std::size_t i = 0; i < 200; ++i) {
        INFO(i);
        CHECK((engine.position(balls[i]).y() < 0) == (i % 2 == 1));
    }
}

TEST_CASE("each change of a body is in saved worlds and recordings and wakes what it concerns", "[house]")
{
    using Change = std::function<void(World&, const Asleep&)>;
    const std::pair<const char*, Change> changes[] = {
        {"gravity scale", [](World& e, const Asleep& s) { e.set_gravity_scale(s.above, 0.5); }},
        {"damping", [](World& e, const Asleep& s) { e.set_damping(s.above, 1, 2); }},
        {"force",
         [](World& e, const Asleep& s) {
             e.set_force(s.above, {0.3, 1}, 0.2);
         }},
        {"fixed rotation", [](World& e, const Asleep& s) { e.set_fixed_rotation(s.above, true); }},
        {"switched off", [](World& e, const Asleep& s) { e.set_enabled(s.below, false); }},
        {"kind", [](World& e, const Asleep& s) { e.set_kind(s.below, BodyKind::fixed); }},
        {"mass", [](World& e, const Asleep& s) { e.set_mass(s.above, 9, 2); }},
        {"density", [](World& e, const Asleep& s) { e.set_density(s.above, 7); }},
        {"shape", [](World& e, const Asleep& s) { e.set_shape(s.below, disc(0.5)); }},
        {"surface of the ground", [](World& e, const Asleep& s) {
             e.set_surface(s.ground, {0.2, 0, 1, 0});
         }}};
    for (const auto& [name, change] : changes) {
        INFO(name);
        Asleep scene;
        World& engine = scene.engine;
        Recording film;
        engine.record(&film);
        change(engine, scene);
        World other = World::load(engine.save());
        for (int n = 0; n < 40; ++n) {
            engine.step(frame);
            other.step(frame);
            if (n == 0) CHECK(engine.is_awake(scene.above));
            if (n == 20) {
                engine.push(scene.above, {0.7, 2}, {0.2, 1.7});
                other.push(scene.above, {0.7, 2}, {0.2, 1.7});
                other = World::load(other.save());
            }
            REQUIRE(engine.hash() == other.hash());
        }
        CHECK(film.replay().differs_at == -1);
        CHECK(Recording::load(film.save()).replay().world.hash() == engine.hash());
        CHECK(engine.save() == other.save());
    }
}

TEST_CASE("any changes of any bodies in any order go on to the same bits after loading", "[house]")
{
    Random random(7);
    for (int trial = 0; trial < 6; ++trial) {
        World engine({.substeps = trial % 2 ? 4 : 1});
        engine.add_wall({{0, 1}, 0}), engine.add_wall({{1, 0}, -3}), engine.add_wall({{-1, 0}, -3});
        std::vector<BodyId> all;
        for (int i = 0; i < 12; ++i)
            all.push_back(
                engine.add_body(body_at({-2 + 1.3 * (i % 4), 0.6 + 1.1 * (i / 4)}, i % 5 == 4 ? 0.0 : 1.0,
                                        i % 3 ? box(0.8, 0.6) : disc(0.4))));
        for (std::size_t i = 0; i + 1 < 4; ++i)
            engine.add_joint(
                all[i], all[i + 1],
                engine.joint_at(JointKind::revolute, all[i], all[i + 1], engine.position(all[i])));
        Recording film;
        engine.record(&film);
        for (int n = 0; n < 120; ++n) {
            const BodyId it = all[static_cast<std::size_t>(random.index(12))];
            const Index what = random.index(10);
            const Real x = random.uniform(-1, 1), y = random.uniform(0, 2);
            World other = World::load(engine.save());
            for (World* one : {&engine, &other}) {
                const bool dynamic = one->kind(it) == BodyKind::dynamic;
                switch (n % 3 ? Index{99} : what) {
                case 0:
                    one->set_gravity_scale(it, x);
                    break;
                case 1:
                    one->set_damping(it, y, 3 * y);
                    break;
                case 2:
                    one->set_force(it, {4 * x, y}, x);
                    break;
                case 3:
                    one->set_fixed_rotation(it, x > 0);
                    break;
                case 4:
                    one->set_enabled(it, x > 0);
                    break;
                case 5:
                    one->set_kind(it,
                                  x > 0 || one->mass(it) == infinity ? BodyKind::kinematic : BodyKind::fixed);
                    break;
                case 6:
                    one->set_mass(it, 0.1 + y, 0.1 + y);
                    break;
                case 7:
                    one->set_shape(it, x > 0 ? box(0.5, 0.3 + y / 4) : disc(0.2 + y / 8));
                    break;
                case 8:
                    if (!dynamic) one->set_target(it, {x, y}, x, frame);
                    break;
                case 9:
                    one->set_bullet(it, x > 0);
                    break;
                default:
                    break;
                }
                one->step(frame);
            }
            INFO("trial " << trial << ", step " << n << ", change " << what);
            REQUIRE(engine.hash() == other.hash());
            for (const BodyId body : all) REQUIRE(engine.position(body).allFinite());
        }
        CHECK(film.replay().differs_at == -1);
    }
}

TEST_CASE("a change of a body that makes no sense gets a sentence and changes nothing", "[house]")
{
    Asleep scene;
    World& engine = scene.engine;
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const BodyId slab = engine.add_body(body_at({20, 1}, 0));
    const BodyId edge = engine.add_chain(std::vector<Vec2>{{32, 0}, {30, 0}});
    const BodyId it = scene.above;
    BodyDefinition gate = body_at({50, 1}, 0);
    gate.sensor = true;
    const BodyId sensor = engine.add_body(gate);
    engine.step(frame);
    const std::string before = engine.save();
    CHECK_THROWS_WITH(engine.set_gravity_scale(it, nan), Contains("gravity scale of the body is nan"));
    CHECK_THROWS_WITH(engine.set_damping(it, -1, 0), Contains("linear damping of the body is -1 1/s"));
    CHECK_THROWS_WITH(engine.set_damping(it, 0, infinity), Contains("angular damping"));
    CHECK_THROWS_WITH(engine.set_force(it, {nan, 0}), Contains("lasting force"));
    CHECK_THROWS_WITH(engine.set_force(it, {0, 0}, 1e76), Contains("1e+76 N m"));
    CHECK_THROWS_WITH(engine.set_target(it, {0, 0}, 0, frame), Contains("pushed by forces"));
    CHECK_THROWS_WITH(engine.set_target(slab, {nan, 0}, 0, frame), Contains("after the step"));
    CHECK_THROWS_WITH(engine.set_target(slab, {0, 0}, 0, 0), Contains("time step"));
    CHECK_THROWS_WITH(engine.set_target(edge, {0, 0}, 0, frame), Contains("edge of a chain"));
    CHECK_THROWS_WITH(engine.move(edge, {0, 5}, 0), Contains("edge of a chain"));
    CHECK_THROWS_WITH(engine.set_target(slab, {1e75, 0}, 0, 1e-300), Contains("not finite"));
    CHECK_THROWS_WITH(engine.set_mass(it, 0, 1), Contains("the mass 0 kg"));
    CHECK_THROWS_WITH(engine.set_mass(it, 1, nan), Contains("inertia nan"));
    CHECK_THROWS_WITH(engine.set_mass(sensor, 1, 1), Contains("sensor"));
    CHECK_THROWS_WITH(engine.set_mass(edge, 1, 1), Contains("edge of a chain"));
    CHECK_THROWS_WITH(engine.set_density(it, -2), Contains("density of the body is -2"));
    CHECK_THROWS_WITH(engine.set_shape(it, Polygon{{}, 1}), Contains("no vertex"));
    CHECK_THROWS_WITH(engine.set_shape(edge, box(1, 1)), Contains("edge of a chain"));
    CHECK_THROWS_WITH(engine.set_kind(slab, BodyKind::dynamic), Contains("no mass"));
    CHECK_THROWS_WITH(engine.set_kind(it, static_cast<BodyKind>(7)), Contains("kind of the body is 7"));
    CHECK_THROWS_WITH(engine.set_surface(scene.ground, {-1, 0, 0, 0}), Contains("the wall"));
    BodyDefinition wrong = body_at({0, 9});
    wrong.linear_damping = nan;
    CHECK_THROWS_WITH(engine.add_body(wrong), Contains("linear damping"));
    wrong = body_at({0, 9});
    wrong.gravity_scale = infinity;
    CHECK_THROWS_WITH(engine.add_body(wrong), Contains("gravity scale"));
    CHECK(engine.save() == before);
}

}  // namespace what_bodies_are
