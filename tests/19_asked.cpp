/// Chapter 19: what a world is asked, by one thread and by several, what it asks its caller, and joints that change.

#include "chapters/19_engine/moving_worlds.hpp"
#include "chapters/19_engine/recording.hpp"
#include "chapters/19_engine/resting_forces.hpp"
#include "chapters/19_engine/world.hpp"

#include "common/random.hpp"
#include "tests/catch.hpp"
#include "tests/world_run.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <thread>
#include <tuple>

using namespace rigid;
using Catch::Contains;

namespace what_is_asked {  // sources of one target are compiled together

namespace {

using worlds::body_at;
using worlds::frame;
using worlds::run;

/// A rod on a pin at the origin, level.
struct Hung {
    World engine;
    BodyId rod;
    JointId pin;
    explicit Hung(int substeps = 1) : engine({.substeps = substeps})
    {
        rod = engine.add_body(body_at({0.5, 0}, 1, capsule(0.8, 0.1)));
        pin = engine.add_joint({}, rod, engine.joint_at(JointKind::revolute, {}, rod, {0, 0}));
    }
};

}  // namespace

TEST_CASE("a joint gets a limit and a motor and a spring while it moves and loses them again", "[idea]")
{
    Hung hung;
    World& engine = hung.engine;
    RigidJoint how = engine.joint(hung.pin);
    const RigidJoint free = how;
    how.lower = -0.5;
    engine.change(hung.pin, how);
    run(engine, 120);
    CHECK(engine.coordinate(hung.pin) == Approx(-0.5).margin(1e-4));
    CHECK_FALSE(engine.is_awake(hung.rod));
    engine.change(hung.pin, free);
    run(engine, 20);
    CHECK(engine.coordinate(hung.pin) < -0.6);  // it woke, and nothing holds it
    how = free;
    how.motor.speed = 2, how.motor.force = 100;
    engine.change(hung.pin, how);
    run(engine, 30);
    CHECK(engine.spin(hung.rod) == Approx(2));
    how = free;
    how.spring = {0, 0, 400, 60, 0.3};
    how.upper = 0.29;
    engine.change(hung.pin, how);
    run(engine, 240);
    CHECK(engine.coordinate(hung.pin) < 0.2901);
    CHECK(engine.coordinate(hung.pin) > 0.2);
    CHECK(engine.error(hung.pin) < 1e-3);
    CHECK_THROWS_WITH(
        [&] {
            RigidJoint other = free;
            other.kind = JointKind::weld;
            engine.change(hung.pin, other);
        }(),
        Contains("is a revolute joint and would be a weld joint"));
}

TEST_CASE("joints that change often do not grow and stay what they are for others", "[house]")
{
    World engine;
    std::vector<BodyId> links;
    std::vector<JointId> pins;
    BodyId above;
    for (int i = 0; i < 6; ++i) {
        links.push_back(engine.add_body(body_at({i + 0.5, 0}, 1, capsule(0.8, 0.1))));
        pins.push_back(engine.add_joint(
            above, links.back(), engine.joint_at(JointKind::revolute, above, links.back(), {1.0 * i, 0})));
        above = links.back();
    }
    Recording film;
    engine.record(&film);
    Random random(5);
    std::size_t largest = 0;
    for (int n = 0; n < 300; ++n) {
        const JointId pin = pins[static_cast<std::size_t>(random.index(6))];
        RigidJoint how = engine.joint(pin);
        const Index what = random.index(4);
        if (what == 0) how.lower = std::isfinite(how.lower) ? -infinity : -1.5;
        if (what == 1) how.upper = std::isfinite(how.upper) ? infinity : 1.5;
        if (what == 2) how.motor = {0.5, how.motor.force > 0 ? 0.0 : 3.0, 0, 0, 0};
        if (what == 3) how.spring.stiffness = how.spring.stiffness > 0 ? 0 : 5;
        World other = World::load(engine.save());
        for (World* one : {&engine, &other}) {
            if (n % 2) one->change(pin, how);
            one->step(frame);
        }
        REQUIRE(engine.hash() == other.hash());
        for (const JointId each : pins) REQUIRE(engine.error(each) < 0.1);
        if (n == 150) largest = engine.save().size();
    }
    // of each number of rows from 2 to 6 no more places than joints
    CHECK(engine.save().size() < largest + 6 * 5 * 6 * 30 * 8);
    CHECK(film.replay().differs_at == -1);
    engine.remove(pins[2]);
    run(engine, 5);
    CHECK(engine.joints().size() == 5);
    // no row that was left somewhere keeps its two bodies from touching
    engine.move(links[2], {0, 9}, 0);
    engine.move(links[1], {0, 9.01}, 0);
    engine.step(frame);
    CHECK(std::any_of(engine.events().began.begin(), engine.events().began.end(),
                      [&](const Touch& it) { return it.a == links[1] && it.b == links[2]; }));
}

TEST_CASE("a joint in the place of another one starts from none of its impulses", "[idea]")
{
    constexpr Real tilt = -pi / 4;
    // a weight on a pin that is awake, or asleep; then a rod that has just been pinned there, at 45°
    for (const bool sleep : {false, true}) {
        CAPTURE(sleep);
        const auto rod_of = [](World& engine) {
            BodyDefinition rod =
                body_at(Vec2(5, 0) + 0.5 * Vec2(rigid::cos(tilt), rigid::sin(tilt)), 1, box(1, 0.1));
            rod.angle = tilt;
            return engine.add_body(rod);
        };
        const auto pin_of = [](World& engine, BodyId rod) {
            return engine.add_joint({}, rod, engine.joint_at(JointKind::revolute, {}, rod, {5, 0}));
        };
        World engine({.sleep = sleep}), plain;
        const BodyId weight = engine.add_body(body_at({0, 0}, 1000));
        const JointId first =
            engine.add_joint({}, weight, engine.joint_at(JointKind::revolute, {}, weight, {0, 0.5}));
        run(engine, 60);
        CHECK(engine.force(first).y() == Approx(9810));
        CHECK(engine.is_awake(weight) == !sleep);
        engine.remove(first);
        const BodyId rod = rod_of(engine), alone = rod_of(plain);
        const JointId second = pin_of(engine, rod);
        pin_of(plain, alone);
        CHECK(second.place == first.place);
        CHECK(engine.force(second) == Vec2(0, 0));  // it has borne nothing yet
        World other = World::load(engine.save());
        for (int n = 0; n < 10; ++n) {
            for (World* one : {&engine, &other, &plain}) one->step(frame);
            CHECK(engine.spin(rod) == Approx(plain.spin(alone)).epsilon(1e-12));  // to rounding
            CHECK(engine.hash() == other.hash());
        }
    }
}

TEST_CASE("a joint that gets a limit bears on what it bore", "[idea]")
{
    // rods of 1 kg under a load of a tonne: by their inertia alone they are thrown
    const auto largest_spin = [](int every) {
        World engine;
        std::vector<BodyId> rods;
        JointId middle;
        for (int k = 0; k < 50; ++k) {
            BodyDefinition rod = body_at({0, -k - 0.5}, 1, box(0.1, 1));
            const Real m = k == 49 ? 1000 : 1;
            rod.mass = Mass{m, {0, 0}, m / 12};
            rod.velocity = {0.2, 0};
            const BodyId above = rods.empty() ? BodyId{} : rods.back(), here = engine.add_body(rod);
            const JointId pin = engine.add_joint(
                above, here, engine.joint_at(JointKind::revolute, above, here, {0, -1.0 * k}));
            if (k == 25) middle = pin;
            rods.push_back(here);
        }
        run(engine, 30);
        Real largest = 0;
        for (int n = 0; n < 60; ++n) {
            if (every > 0 && n % every == 0) {
                RigidJoint how = engine.joint(middle);
                how.lower = std::isfinite(how.lower) ? -infinity : -3;
                how.upper = -how.lower;
                const Vec2 bears = engine.force(middle);
                CHECK(bears.y() > 9000);
                engine.change(middle, how);
                CHECK(engine.force(middle) == bears);
            }
            engine.step(frame);
            for (const BodyId rod : rods) largest = std::max(largest, std::abs(engine.spin(rod)));
        }
        return largest;
    };
    const Real never = largest_spin(0);
    CHECK(never < 0.2);
    // a limit that is far is no row of the problem: the same to rounding, and what a second of a chain makes of it
    for (const int every : {60, 2}) CHECK(largest_spin(every) == Approx(never).epsilon(1e-6));
}

TEST_CASE("a limit that becomes a motor in one change leaves it none of its impulse", "[idea]")
{
    // a rod that points to the left lies on its upper limit, which turns it by −½ m g r; a motor acts the other way round
    for (const bool sleep : {false, true}) {
        CAPTURE(sleep);
        World engine({.sleep = sleep});
        const BodyId rod = engine.add_body(body_at({-0.5, 0}, 1, box(1, 0.1)));
        RigidJoint how = engine.joint_at(JointKind::revolute, {}, rod, {0, 0});
        how.upper = 0;
        const JointId pin = engine.add_joint({}, rod, how);
        run(engine, 60);
        CHECK(engine.is_awake(rod) == !sleep);
        const Real moment = -0.5 * 0.1 * 9.81;
        CHECK(engine.torque(pin) == Approx(moment).epsilon(1e-6));
        const Vec2 force = engine.force(pin);
        CHECK(force.y() == Approx(0.1 * 9.81).epsilon(1e-6));
        how.upper = infinity;
        how.motor.force = 100;
        engine.change(pin, how);
        CHECK(std::abs(engine.torque(pin)) <
              1e-12);  // of the pin, by rounding; its own row has borne nothing
        CHECK(engine.force(pin) == force);
        World other = World::load(engine.save());
        for (World* one : {&engine, &other}) {
            one->step(frame);
            CHECK(one->torque(pin) == Approx(moment).epsilon(1e-6));
            CHECK(std::abs(one->spin(rod)) < 1e-9);
        }
        CHECK(engine.hash() == other.hash());
    }
}

TEST_CASE("a sleeper on a pulley bears its own rope and not what acts on the other body", "[house]")
{
    // no scene sleeps with a force across a rope that can be seen: one is put there
    EngineState state;
    JointedScene& scene = state.scene;
    for (const Real x : {-2.0, 2.0}) add_body(scene, box(1, 1), 1, {x, 0});
    RigidJoint pulley;
    pulley.kind = JointKind::pulley;
    pulley.a = 0, pulley.b = 1;
    pulley.over_a = {-2, 5}, pulley.over_b = {2, 5};
    pulley.length = 10;
    add_joint(scene, pulley);
    ToldManifolds& sleepers = state.awake();
    sleepers.wake_all(scene.bodies);
    sleepers.set.sleep(std::array{0, 1});
    sleepers.forces.put(0, joint_key(0, 0), 9.81);  // of the rope
    sleepers.forces.put(0, joint_key(0, 1), 3);     // across its part at a
    CHECK((resting_reaction(state, 0, 1).force - Vec2(0, 9.81)).norm() < 1e-12);
    sleepers.forces.put(0, joint_key(0, 2), 5);  // across its part at b
    CHECK((resting_reaction(state, 0, 1).force - Vec2(5, 9.81)).norm() < 1e-12);
}

TEST_CASE("what a joint bears while its body sleeps is the same whatever else is awake", "[idea]")
{
    for (const int substeps : {1, 4}) {
        World engine({.substeps = substeps});
        const BodyId weight = engine.add_body(body_at({0.5, 0}, 1000));
        const JointId beam =
            engine.add_joint({}, weight, engine.joint_at(JointKind::weld, {}, weight, {0, 0}));
        run(engine, 200);
        REQUIRE_FALSE(engine.is_awake(weight));
        const Vec2 force = engine.force(beam);
        const Real torque = engine.torque(beam);
        CHECK(force.y() == Approx(9810));
        CHECK(torque == Approx(4905));
        engine.add_body(body_at({20, 0}, 1, disc(0.5)));
        engine.step(frame);
        REQUIRE_FALSE(engine.is_awake(weight));
        CHECK(engine.force(beam) == force);
        CHECK(engine.torque(beam) == torque);
        CHECK(World::load(engine.save()).force(beam) == force);
        RigidJoint how = engine.joint(beam);
        how.motor.force = 0, how.breaking_force = 1e6;
        engine.change(beam, how);
        engine.step(frame);
        CHECK(engine.is_awake(weight));
        CHECK(engine.force(beam).y() == Approx(9810));
    }
}

TEST_CASE("a body knows its joints and a joint its number of the caller", "[idea]")
{
    Hung hung;
    World& engine = hung.engine;
    const BodyId other = engine.add_body(body_at({3, 0}));
    const JointId rope = engine.add_joint(hung.rod, other, [] {
        RigidJoint how;
        how.kind = JointKind::rope;
        how.length = 3;
        return how;
    }());
    CHECK(engine.joints(hung.rod) == std::vector<JointId>{hung.pin, rope});
    CHECK(engine.joints(other) == std::vector<JointId>{rope});
    engine.set_user(rope, 77);
    CHECK(engine.user(rope) == 77);
    CHECK(World::load(engine.save()).user(rope) == 77);
    engine.remove(hung.pin);
    CHECK(engine.joints(hung.rod) == std::vector<JointId>{rope});
    CHECK(engine.joints(other).size() == 1);
}

TEST_CASE("the contacts of a body bear its weight while it is awake and while it sleeps", "[idea]")
{
    for (const int substeps : {1, 4}) {
        World engine({.substeps = substeps, .sleep = false});
        engine.add_wall({{-0.28, 0.96}, 0});  // a slope of 16°, n = (-7, 24)/25
        BodyDefinition body = body_at({0, 0}, 2);
        body.angle = std::atan2(0.28, 0.96);
        body.position = 0.5 * Vec2(-0.28, 0.96);
        const BodyId below = engine.add_body(body);
        body.position *= 3;
        const BodyId above = engine.add_body(body);
        std::vector<ContactView> list;
        const auto check = [&](BodyId of, Real mass_above, Real mass_here) {
            Vec2 sum(0, 0);
            engine.contacts(of, list);
            for (const ContactView& it : list) {
                const Vec2 P = it.impulse * it.normal + it.friction * perpendicular(it.normal);
                CHECK((it.touch.a == of || it.touch.b == of));
                CHECK(std::abs(it.gap) < 0.006);
                sum += it.touch.b == of ? P : Vec2(-P);
            }
            // from below and from above: the body's own weight is left, in a sub-step
            const Real h = frame / substeps;
            CHECK(sum.x() == Approx(0).margin(1e-4 * mass_above * h));
            CHECK(sum.y() == Approx(mass_here * 9.81 * h).epsilon(1e-4));
        };
        run(engine, 10);
        REQUIRE(engine.is_awake(below));
        check(below, 4, 2), check(above, 4, 2);
        CHECK(list.size() == 2);
        WorldSettings settings = engine.settings();
        settings.sleep = true;
        engine.change(settings);
        run(engine, 110);
        REQUIRE_FALSE(engine.is_awake(below));
        check(below, 4, 2), check(above, 4, 2);
        engine.contacts(below, list);
        CHECK(list.size() == 4);
        const World other = World::load(engine.save());
        std::vector<ContactView> loaded;
        other.contacts(below, loaded);
        REQUIRE(loaded.size() == 4);
        for (std::size_t i = 0; i < 4; ++i) CHECK(loaded[i].impulse == list[i].impulse);
    }
}

TEST_CASE("a contact is with the wall that its step met whatever has come in its place", "[house]")
{
    World engine({.sleep = false});
    engine.add_wall({{0, 1}, -100});
    const WallId floor = engine.add_wall({{0, 1}, 0});
    const BodyId body = engine.add_body(body_at({0, 0.5}, 1));
    run(engine, 5);
    std::vector<ContactView> list;
    const auto count = [&](const WallId& wall) {
        engine.contacts(body, list);
        for (const ContactView& it : list) CHECK(it.touch.wall == wall);
        return list.size();
    };
    CHECK(count(floor) == 2);
    engine.set_shape(body, disc(0.5));  // one vertex in place of four
    CHECK(count(floor) == 2);
    engine.step(frame);
    CHECK(count(floor) == 1);
    engine.remove(floor);
    const WallId deeper = engine.add_wall({{0, 1}, -5});
    CHECK(deeper.place == floor.place);
    CHECK(count(deeper) == 0);
}

TEST_CASE("what is in the place of a body that slept neither sleeps nor touches what that one did", "[house]")
{
    for (const Real density : {1.0, 0.0}) {
        World engine;
        engine.add_wall({{0, 1}, 0});
        const BodyId below = engine.add_body(body_at({0, 0.5}, density)),
                     above = engine.add_body(body_at({0, 1.5}));
        run(engine, 120);
        REQUIRE_FALSE(engine.is_awake(above));
        std::vector<ContactView> list;
        engine.contacts(above, list);
        CHECK(list.size() == 2);
        engine.remove(below);
        engine.contacts(above, list);  // nothing that was removed is in it
        CHECK(list.empty());
        const BodyId other = engine.add_body(body_at({9, 3}));
        REQUIRE(other.place == below.place);
        CHECK(engine.is_awake(other));
        for (const BodyId it : {above, other}) {
            engine.contacts(it, list);
            CHECK(list.empty());
        }
        engine.step(frame);
        CHECK(engine.is_awake(above));  // what bore it is gone
        REQUIRE(engine.events().ended.size() == (density > 0 ? 2U : 1U));
        CHECK(engine.events().began.empty());
    }
}

TEST_CASE("the bodies that a step has moved are those that are elsewhere", "[idea]")
{
    World engine = piles_world(3);
    for (int i = 0; i < 200; ++i) engine.step(frame);
    std::vector<BodyId> moved;
    engine.moved(moved);
    CHECK(moved.empty());
    const std::vector<BodyId> all = engine.bodies();
    engine.push(all[4], {0.5, 0}, engine.position(all[4]));
    for (int n = 0; n < 30; ++n) {
        std::vector<Vec2> before;
        for (const BodyId it : all) before.push_back(engine.position(it));
        engine.step(frame);
        engine.moved(moved);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (engine.position(all[i]) != before[i])
                CHECK(std::binary_search(moved.begin(), moved.end(), all[i]));
        CHECK(moved.size() <= 5);
        CHECK(!moved.empty());
    }
    engine.remove(all[4]);  // and another one takes its place
    engine.add_body(body_at({50, 3}));
    engine.moved(moved);
    CHECK(moved.size() == 4);
}

TEST_CASE("a ray and a cast find all that is on their way in its order", "[idea]")
{
    World engine({.gravity = {0, 0}});
    std::vector<BodyId> all;
    const Real at[] = {6, 2, 4, 8, 4};
    for (int i = 0; i < 5; ++i) {
        BodyDefinition body = body_at({at[i], i == 4 ? 0.3 : 0}, 1, box(1, 1));
        body.filter.category = std::uint64_t{1} << (40 + i);
        all.push_back(engine.add_body(body));
    }
    engine.add_wall({{-1, 0}, -10});
    const auto ids = [](const std::vector<Met>& met) {
        std::vector<BodyId> found;
        for (const Met& it : met) found.push_back(it.body);
        return found;
    };
    const std::vector<Met> met = engine.ray_all({0, 0}, {20, 0});
    CHECK(ids(met) == std::vector<BodyId>{all[1], all[2], all[4], all[0], all[3], {}});
    const Real parts[] = {1.5 / 20, 3.5 / 20, 3.5 / 20, 5.5 / 20, 7.5 / 20, 10.0 / 20};
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(met[i].part == Approx(parts[i]));
        CHECK(met[i].normal == Vec2(-1, 0));
    }
    CHECK(engine.ray({0, 0}, {20, 0})->body == met[0].body);
    Filter some;
    some.meets = std::uint64_t{0b11001} << 40;
    CHECK(ids(engine.ray_all({0, 0}, {9, 0}, some)) == std::vector<BodyId>{all[4], all[0], all[3]});
    CHECK(engine.ray_all({0, 0}, {1.4, 0}).empty());
    CHECK(engine.ray_all({2, 0}, {0.1, 0}).size() == 1);  // it begins in one

    const std::vector<Met> cast = engine.cast_all(disc(0.2), {0, 0}, 0, {20, 0});
    CHECK(ids(cast) == ids(met));
    for (std::size_t i = 0; i < 6; ++i) CHECK(cast[i].part == Approx(parts[i] - 0.2 / 20).margin(1e-6));
    CHECK(engine.cast(disc(0.2), {0, 0}, 0, {20, 0})->body == all[1]);
    CHECK(ids(engine.cast_all(disc(0.2), {0, 0}, 0, {9, 0}, some)) ==
          std::vector<BodyId>{all[4], all[0], all[3]});
    CHECK(engine.overlapping(box(9, 0.1), {4.5, 0}, 0, some).size() == 3);
    CHECK_THROWS_WITH(engine.ray_all({0, infinity}, {1, 0}), Contains("ray"));
    CHECK_THROWS_WITH(engine.ray({0, 0}, {1e76, 0}), Contains("the ray") && Contains("beyond 1e75"));
    CHECK_THROWS_WITH(engine.cast(box(1, 1), {0, -1e76}, 0, {1, 0}),
                      Contains("the shape") && Contains("beyond 1e75"));
    CHECK_THROWS_WITH(engine.cast(box(1, 1), {0, 0}, infinity, {1, 0}),
                      "the shape goes from an angle of inf rad; it must be finite");
    CHECK_THROWS_WITH(engine.cast_all(disc(0.2), {0, 0}, infinity, {1, 0}), Contains("shape goes"));
}

TEST_CASE("all that is met begins with what is met first in any world", "[idea]")
{
    World engine = rubble_world(60, 3);
    run(engine, 60);
    Random random(11);
    std::size_t most = 0;
    for (int n = 0; n < 300; ++n) {
        const Real x = random.uniform(-6, 6), y = random.uniform(-1, 8), dx = random.uniform(-8, 8),
                   dy = random.uniform(-8, 8);
        const auto first = engine.ray({x, y}, {dx, dy});
        const std::vector<Met> all = engine.ray_all({x, y}, {dx, dy});
        most = std::max(most, all.size());
        REQUIRE(first.has_value() == !all.empty());
        if (first) {
            REQUIRE(all[0].part == first->part);
            REQUIRE(all[0].body == first->body);
        }
        // each body that it goes through is met by a ray that sees that body alone: by its outline
        REQUIRE(std::is_sorted(all.begin(), all.end(),
                               [](const Met& a, const Met& b) { return a.part < b.part; }));
        const auto cast = engine.cast(box(0.3, 0.2), {x, y}, 0.4, {dx, dy});
        const std::vector<Met> casts = engine.cast_all(box(0.3, 0.2), {x, y}, 0.4, {dx, dy});
        REQUIRE(cast.has_value() == !casts.empty());
        if (cast) REQUIRE(casts[0].body == cast->body);
    }
    CHECK(most > 4);
}

TEST_CASE("several threads that ask get the answers that one gets", "[idea]")
{
    World engine = poured_world(120);
    run(engine, 50);
    const World& asked = engine;
    struct Question {
        Vec2 from, way;
    };
    std::vector<Question> questions;
    Random random(2);
    for (int i = 0; i < 400; ++i) {
        const Real x = random.uniform(-3, 3), y = random.uniform(0, 10), dx = random.uniform(-5, 5),
                   dy = random.uniform(-5, 5);
        questions.push_back({{x, y}, {dx, dy}});
    }
    const auto answer = [&](const World& of, const Question& q) {
        std::vector<BodyId> all = of.overlapping(box(2, 2), q.from, 0.3);
        for (const Met& met : of.ray_all(q.from, q.way)) all.push_back(met.body);
        for (const Met& met : of.cast_all(disc(0.1), q.from, 0, q.way)) all.push_back(met.body);
        if (const auto met = of.ray(q.from, q.way)) all.push_back(met->body);
        if (const auto met = of.cast(disc(0.1), q.from, 0, q.way)) all.push_back(met->body);
        return all;
    };
    std::vector<std::vector<BodyId>> alone;
    const World copy = World::load(engine.save());
    for (const Question& q : questions) alone.push_back(answer(copy, q));
    for (int round = 0; round < 3; ++round) {
        if (round == 1) engine.step(frame);
        if (round == 1) {
            alone.clear();
            const World again = World::load(engine.save());
            for (const Question& q : questions) alone.push_back(answer(again, q));
        }
        asked.prepare_questions();
        std::atomic<int> wrong = 0, ready = 0;
        std::vector<std::thread> threads;
        for (int t = 0; t < 4; ++t)
            threads.emplace_back([&] {
                ++ready;
                while (ready < 4) {
                }
                for (std::size_t i = 0; i < questions.size(); ++i)
                    wrong += answer(asked, questions[i]) != alone[i];
            });
        for (std::thread& thread : threads) thread.join();
        CHECK(wrong == 0);
    }
}

namespace {

/// Lets through what comes from below, and what is not above it yet.
PreSolve one_way(const World& engine, BodyId platform)
{
    return [&engine, platform](const Touch& touch, std::span<const ContactView> points) {
        if (touch.a != platform && touch.b != platform) return true;
        const Real sense = touch.a == platform ? 1 : -1;
        const BodyId other = touch.a == platform ? touch.b : touch.a;
        return sense * points[0].normal.y() > 0.9 && points[0].gap > -0.02 &&
               engine.velocity(other).y() < 0.01;
    };
}

}  // namespace

TEST_CASE("a platform that asks is open from below and bears from above", "[idea]")
{
    for (const Real speed : {8.0, 40.0})  // the second is stopped on its way where anything stops it
        for (const int substeps : {1, 4}) {
            World engine({.substeps = substeps});
            engine.add_wall({{0, 1}, 0});
            const BodyId platform = engine.add_body(body_at({0, 2}, 0, box(4, 0.2)));
            engine.set_pre_solve(one_way(engine, platform));
            const BodyId ball = engine.add_body(body_at({0, 0.3}, 1, disc(0.2)));
            engine.set_velocity(ball, {0, speed}, 0);
            Real top = 0;
            int n = 0;
            do {
                const Real before = engine.position(ball).y(), up = engine.velocity(ball).y();
                engine.step(frame);
                top = std::max(top, engine.position(ball).y());
                if (up > 1)  // no step of its way up is cut short
                    CHECK(
                        engine.position(ball).y() ==
                        Approx(before + up * frame - 9.81 * frame * frame * (substeps + 1) / (2 * substeps)));
            } while (++n < 900 && engine.is_awake(ball));
            // v²/2g less half a step's fall: nothing held it on its way up
            const Real v = speed;
            CHECK(top == Approx(0.3 + v * v / (2 * 9.81)).epsilon(0.03));
            CHECK(engine.position(ball).y() == Approx(2.3).margin(0.006));
        }
}

TEST_CASE("a filter of the caller's is asked for pairs in their order and nothing else is", "[idea]")
{
    World engine;
    engine.add_wall({{0, 1}, 0});
    std::vector<BodyId> all;
    for (int i = 0; i < 6; ++i) all.push_back(engine.add_body(body_at({0.02 * i, 0.5 + i})));
    std::vector<std::pair<BodyId, BodyId>> asked;
    engine.set_contact_filter([&](BodyId a, BodyId b) {
        asked.emplace_back(a, b);
        return !(a == all[2] || b == all[2]);
    });
    engine.step(frame);
    CHECK(asked.size() == 5);
    CHECK(std::is_sorted(asked.begin(), asked.end()));
    for (const auto& [a, b] : asked) CHECK(a < b);
    run(engine, 200);
    CHECK(engine.position(all[2]).y() == Approx(0.5).margin(0.006));  // through those below it
    CHECK(engine.position(all[5]).y() == Approx(4.5).margin(0.03));
    // a fast body is not stopped at what it may pass
    engine.set_contact_filter([&](BodyId a, BodyId) { return a != all[2]; });
    const BodyId wall = engine.add_body(body_at({30, 0.5}, 0, box(0.1, 4)));
    engine.move(all[2], {28, 0.6}, 0);
    engine.set_velocity(all[2], {300, 0}, 0);
    run(engine, 3);
    CHECK(engine.position(all[2]).x() > 31);
    engine.set_contact_filter({});
    engine.move(all[2], {28, 0.6}, 0);
    engine.set_velocity(all[2], {300, 0}, 0);
    run(engine, 3);
    CHECK(engine.position(all[2]).x() < 30);
    CHECK(engine.has(wall));
}

TEST_CASE("a world that asks has the same bits again and after loading and in a replay", "[house]")
{
    const auto prepare = [](World& it, BodyId platform) {
        it.set_pre_solve(one_way(it, platform));
        it.set_contact_filter([](BodyId a, BodyId b) { return (a.place + b.place) % 5 != 0; });
    };
    const auto begin = [&](World& it) {
        it.add_wall({{0, 1}, 0});
        const BodyId platform = it.add_body(body_at({0, 2}, 0, box(4, 0.2)));
        Random random(4);
        for (int i = 0; i < 20; ++i) {
            const Real x = random.uniform(-2, 2), v = random.uniform(0, 9);
            const BodyId ball =
                it.add_body(body_at({x, 0.4 + 0.5 * i}, 1, i % 2 ? disc(0.2) : box(0.4, 0.3)));
            it.set_velocity(ball, {0, v}, 0);
        }
        return platform;
    };
    World engine, twin;
    const BodyId platform = begin(engine);
    begin(twin);
    prepare(engine, platform), prepare(twin, platform);
    Recording film;
    for (int n = 0; n < 150; ++n) {
        if (n == 40) engine.record(&film);
        if (n == 70) {
            twin = World::load(engine.save());
            prepare(twin, platform);
        }
        engine.step(frame), twin.step(frame);
        REQUIRE(engine.hash() == twin.hash());
    }
    CHECK(film.replay({}, [&](World& it) { prepare(it, platform); }).differs_at == -1);
    CHECK(film.replay().differs_at >= 0);
}

TEST_CASE("questions and sensors change no bit of what moves", "[house]")
{
    // thin and fast: shapes that move farther than they look ahead and stay in their boxes of the tree
    const auto made = [] {
        World engine;
        engine.add_wall({{0, 1}, 0});
        Random random(4);
        for (int i = 0; i < 30; ++i)
            engine.add_body(body_of(box(0.3, 0.05 + 0.3 * random.uniform()), {0.7 * i, 0.3}));
        for (int i = 0; i < 20; ++i) {
            BodyDefinition rod = body_of(capsule(0.5, 0.01), {0.6 * i, 1 + 0.3 * i}, random.uniform(0, 3));
            rod.velocity = {random.uniform(-6, 6), random.uniform(-9, 0)};
            rod.spin = random.uniform(-5, 5);
            engine.add_body(rod);
        }
        return engine;
    };
    World quiet = made(), asked = made(), watched = made();
    BodyDefinition sensor = body_of(box(1, 1), {0, 40}, 0, 0);
    sensor.sensor = true;
    watched.add_body(sensor);
    const std::vector<BodyId> all = quiet.bodies();
    for (int n = 0; n < 120; ++n) {
        for (World* const engine : {&quiet, &asked, &watched}) {
            if (engine == &asked) (void)engine->ray({-5, 0.2}, {50, 0});
            // slowly from one place to another, which is what a question would see first
            if (n % 20 == 10) engine->move(all[35], engine->position(all[3]) + Vec2(0.02, 0.03), 0.1);
            if (engine == &asked) (void)engine->at({0, 0});
            engine->step(frame);
        }
        for (const BodyId body : all) {
            REQUIRE(quiet.position(body) == asked.position(body));
            REQUIRE(quiet.position(body) == watched.position(body));
        }
    }
}

TEST_CASE("whoever helps with a step in whatever order its bits are the same", "[house]")
{
    std::atomic<int> called = 0, pieces = 0;
    const auto counted = [&](Jobs jobs) {
        return [&, jobs](int count, const std::function<void(int)>& piece) {
            ++called, pieces += count;
            jobs(count, piece);
        };
    };
    const Jobs backwards = [](int count, const std::function<void(int)>& piece) {
        for (int i = count; i-- > 0;) piece(i);
    };
    const Jobs on_threads = [](int count, const std::function<void(int)>& piece) {
        std::atomic<int> next = 0;
        const auto take = [&] {
            for (int i = next++; i < count; i = next++) piece(i);
        };
        std::vector<std::thread> others;
        for (int i = 0; i < 3; ++i) others.emplace_back(take);
        take();
        for (std::thread& other : others) other.join();
    };
    // many islands, some that bounce, some on joints, a heap, and bodies that come and go
    const auto made = [] {
        World engine = poured_world(150);
        for (int i = 0; i < 30; ++i) {
            JointedScene doll;
            add_ragdoll(doll, {40.0 + 3 * i, 1.5});
            cover(doll, {0.6, i % 3 == 0 ? 0.5 : 0, 0, 0});
            put_in(engine, doll, {1, 0xffff'ffff, -1 - i});
        }
        for (int i = 0; i < 40; ++i)
            for (int k = 0; k < 5; ++k)
                engine.add_body(body_of(box(0.5, 0.5), {-40.0 - 2 * i, 0.3 + 0.6 * k}, 0.1 * (i % 4)));
        engine.add_body(body_of(box(400, 1), {0, -1.0}, 0, 0));
        BodyDefinition belt = body_of(box(60, 1), {-160, 0}, 0, 0);  // one that all stacks on it read
        belt.velocity = {0.5, 0};
        engine.add_body(belt);
        for (int i = 0; i < 40; ++i)
            for (int k = 0; k < 4; ++k)
                engine.add_body(body_of(box(0.5, 0.5), {-185.0 + 1.2 * i, 0.8 + 0.55 * k}));
        return engine;
    };
    World alone = made();
    std::vector<std::uint64_t> bits;
    std::vector<StepWork> work;
    for (int n = 0; n < 90; ++n) {
        alone.step(frame);
        bits.push_back(alone.hash());
        work.push_back(alone.work());
    }
    for (const Jobs& jobs : {backwards, on_threads}) {
        World helped = made();
        helped.set_jobs(counted(jobs));
        called = pieces = 0;
        for (int n = 0; n < 90; ++n) {
            helped.step(frame);
            REQUIRE(helped.hash() == bits[static_cast<std::size_t>(n)]);
            const StepWork &a = helped.work(), &b = work[static_cast<std::size_t>(n)];
            REQUIRE(std::tuple(a.visits, a.entries, a.sweeps, a.rescued, a.unsolved, a.residual) ==
                    std::tuple(b.visits, b.entries, b.sweeps, b.rescued, b.unsolved, b.residual));
        }
        CHECK(called > 90);
        CHECK(pieces > 10 * called / 2);
        // a world of one small island asks nobody
        World small;
        small.set_jobs(counted(jobs));
        small.add_wall({{0, 1}, 0});
        for (int k = 0; k < 5; ++k) small.add_body(body_of(box(1, 1), {0, 0.5 + k}));
        called = 0;
        small.step(frame);
        CHECK(called == 0);
    }
}

TEST_CASE("what is put down in balance sleeps at once whenever and wherever it is put", "[idea]")
{
    World engine;
    engine.add_wall({{0, 1}, 0});
    const auto stands = [&](Real x) { return engine.add_body(body_at({x, 0.5}, 1)); };
    const BodyId first = stands(0);
    engine.step(frame);
    CHECK_FALSE(engine.is_awake(first));
    const BodyId later = stands(3);
    engine.step(frame);
    CHECK_FALSE(engine.is_awake(later));
    engine.remove(later);
    const BodyId again = stands(3);  // in the place of the other one
    engine.step(frame);
    CHECK_FALSE(engine.is_awake(again));
    CHECK(engine.position(again) == Vec2(3, 0.5));
}

TEST_CASE("what is touched again and again does not fall asleep in between", "[idea]")
{
    for (const int every : {1, 3, 10}) {
        World engine;
        engine.add_wall({{0, 1}, 0});
        const BodyId box_ = engine.add_body(body_at({0, 0.5}, 1)),
                     other = engine.add_body(body_at({9, 0.5}, 1));
        engine.step(frame);
        int slept = 0;
        for (int n = 0; n < 120; ++n) {
            // friction stops it in the same step
            if (n % every == 0) engine.push(box_, {0.01, 0}, engine.position(box_));
            const bool was = engine.is_awake(box_);
            engine.step(frame);
            slept += was && !engine.is_awake(box_);
        }
        INFO(every);
        CHECK(slept == 0);
        CHECK_FALSE(engine.is_awake(other));
        int more = 0;
        while (more < 60 && engine.is_awake(box_)) engine.step(frame), ++more;
        CHECK(std::abs(more + (119 % every) - 30) <= 2);
    }
}

TEST_CASE("a joint that breaks in the step in which its body would sleep lets go", "[idea]")
{
    World engine;
    const BodyId weight = engine.add_body(body_at({0, 0}, 1));
    RigidJoint pin = engine.joint_at(JointKind::revolute, {}, weight, {0, 0});
    pin.breaking_force = 9.7;  // less than its weight
    const JointId joint = engine.add_joint({}, weight, pin);
    engine.step(frame);
    CHECK(engine.is_broken(joint));
    CHECK(engine.events().broken.size() == 1);
    for (int n = 0; n < 30; ++n) engine.step(frame);
    CHECK(engine.position(weight).y() < -1);
}

TEST_CASE("a pin that is open a little closes before its body sleeps", "[idea]")
{
    for (const Real open : {1e-6, 1e-5, 1e-3}) {
        World engine;
        const BodyId weight = engine.add_body(body_at({0, -0.5}, 1));
        engine.add_joint({}, weight, engine.joint_at(JointKind::revolute, {}, weight, {0, 0}));
        engine.move(weight, {0, -0.5 - open}, 0);
        int n = 0;
        while (n < 30 && (n == 0 || engine.is_awake(weight))) engine.step(frame), ++n;
        INFO(open);
        CHECK(n > 1);  // where the step began it was open
        CHECK(n < 10);
        CHECK(engine.position(weight).y() == Approx(-0.5).margin(1e-8));
    }
}

}  // namespace what_is_asked
