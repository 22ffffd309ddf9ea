/// Chapter 19: the engine. What a world promises: ids, bits, sleep, events, questions, bytes.

#include "tests/no_allocation.hpp"

#include "chapters/19_engine/recording.hpp"
#include "chapters/19_engine/world.hpp"

#include "common/random.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <thread>

using namespace rigid;
using Catch::Contains;

namespace {

constexpr Real h = 1.0 / 60;

BodyDefinition falling(const Polygon& shape, const Vec2& at, Real angle = 0)
{
    BodyDefinition body;
    body.shape = shape;
    body.position = at;
    body.angle = angle;
    return body;
}

/// A little of everything: a stack, a heavy box on light ones, a chain, a doll's arm, balls, a ledge, a sensor.
World mixed_world(const WorldSettings& settings = {})
{
    World engine(settings);
    engine.add_wall({{0, 1}, 0});
    for (int i = 0; i < 5; ++i) engine.add_body(falling(box(1, 1), {0, 0.5 + i}));
    for (int i = 0; i < 3; ++i) {
        BodyDefinition b = falling(box(1, 1), {3, 0.5 + i});
        if (i == 2) b.density = 100;
        engine.add_body(b);
    }
    BodyId above{};
    for (int i = 0; i < 6; ++i) {
        const BodyId link = engine.add_body(falling(capsule(0.4, 0.05), {6.25 + 0.5 * i, 6}));
        RigidJoint pin = engine.joint_at(JointKind::revolute, above, link, {6 + 0.5 * i, 6});
        pin.motor.force = i == 3 ? 0.1 : 0;
        engine.add_joint(above, link, pin);
        above = link;
    }
    BodyDefinition ledge = falling(box(2, 0.2), {-4, 2}, 0.3);
    ledge.density = 0;
    engine.add_body(ledge);
    for (int i = 0; i < 4; ++i) {
        BodyDefinition ball = falling(disc(0.2 + 0.05 * i), {-4.2 + 0.2 * i, 3 + 0.8 * i});
        ball.surface = {0.4, 0.3, 0, 0};
        engine.add_body(ball);
    }
    BodyDefinition gate = falling(box(1, 4), {-2.5, 2});
    gate.density = 0;
    gate.sensor = true;
    engine.add_body(gate);
    return engine;
}

void run(World& engine, int steps)
{
    for (int i = 0; i < steps; ++i) {
        engine.step(h);
        for (const BodyId body : engine.bodies()) {
            REQUIRE(engine.position(body).allFinite());
            REQUIRE(std::isfinite(engine.angle(body)));
        }
    }
}

}  // namespace

TEST_CASE("a ball in a world falls as symplectic Euler says", "[idea]")
{
    World engine;
    const BodyId ball = engine.add_body(falling(disc(0.5), {0, 100}));
    const int n = 60;
    for (int i = 0; i < n; ++i) engine.step(h);
    // y0 - g t²/2 (1 + h/t): chapter 1, to rounding of n sums
    CHECK(engine.position(ball).y() == Approx(100 - 9.81 / 2 * (1 + h)).epsilon(1e-13));
    CHECK(engine.time() == Approx(1).epsilon(1e-14));
}

TEST_CASE("a stack and a heavy box on light ones and a chain come to rest and sleep", "[idea]")
{
    World engine = mixed_world();
    run(engine, 900);
    const std::vector<BodyId> all = engine.bodies();
    for (int i = 0; i < 5; ++i) {
        // within the slop of half a per cent of ℓ for each contact below
        CHECK(std::abs(engine.position(all[static_cast<std::size_t>(i)]).y() - 0.5 - i) < 0.006 * (i + 1));
        CHECK(!engine.is_awake(all[static_cast<std::size_t>(i)]));
    }
    // 100 times as heavy as the two below it
    CHECK(engine.position(all[7]).y() > 2.5 - 3 * 0.006);
}

TEST_CASE("a world that sleeps takes no step at all and one that is touched wakes", "[idea]")
{
    World engine;
    engine.add_wall({{0, 1}, 0});
    std::vector<BodyId> boxes;
    for (int i = 0; i < 8; ++i)
        boxes.push_back(engine.add_body(falling(box(1, 1), {i < 5 ? 0.0 : 3.0, 0.5 + i % 5})));
    const BodyId low = boxes[0];
    int steps = 0;
    while (!engine.work().skipped && ++steps < 600) engine.step(h);
    REQUIRE(engine.work().skipped);
    const std::uint64_t before = engine.hash();
    run(engine, 10);
    CHECK(engine.hash() == before);
    engine.push(low, {0, 20}, engine.position(low));
    engine.step(h);
    CHECK(engine.is_awake(low));
    CHECK(!engine.is_awake(boxes[6]));  // the other stack
}

TEST_CASE("what lay on a body that is taken out falls and ids of what is gone are refused", "[idea]")
{
    World engine;
    engine.add_wall({{0, 1}, 0});
    const BodyId low = engine.add_body(falling(box(1, 1), {0, 0.5})),
                 high = engine.add_body(falling(box(1, 1), {0, 1.5})),
                 far = engine.add_body(falling(box(1, 1), {5, 0.5}));
    run(engine, 200);
    REQUIRE(!engine.is_awake(high));
    engine.remove(low);
    CHECK(!engine.has(low));
    engine.step(h);
    CHECK(engine.is_awake(high));
    CHECK(!engine.is_awake(far));
    run(engine, 120);
    CHECK(engine.position(high).y() == Approx(0.5).margin(0.006));

    CHECK_THROWS_AS(engine.position(low), std::invalid_argument);
    const BodyId next = engine.add_body(falling(disc(0.3), {2, 4}));
    CHECK(next.place == low.place);  // the place is used again
    CHECK(next != low);
    CHECK_THROWS_AS(engine.position(low), std::invalid_argument);
    CHECK(!engine.is_awake(far));
    run(engine, 300);
    CHECK(engine.position(next).y() == Approx(0.3).margin(0.006));
}

TEST_CASE("a world that was saved and loaded goes on to the same bits", "[idea]")
{
    for (const int at : {0, 1, 7, 60, 200, 500}) {
        INFO("saved after " << at << " steps");
        World one = mixed_world();
        run(one, at);
        World other = World::load(one.save());
        CHECK(other.save() == one.save());
        for (int i = 0; i < 150; ++i) {
            if (i == 40)
                for (World* const engine : {&one, &other})
                    engine->push(engine->bodies()[2], {3, 1}, {0.2, 2.6});
            one.step(h);
            other.step(h);
            REQUIRE(other.hash() == one.hash());
            REQUIRE(other.events().began == one.events().began);
            REQUIRE(other.events().ended == one.events().ended);
        }
        CHECK(other.save() == one.save());
    }
}

TEST_CASE("settings that were others for a while leave nothing behind that bytes do not have", "[house]")
{
    World one = mixed_world();
    const WorldSettings settings = one.settings();
    WorldSettings swept = settings;
    swept.most_exact = 0;
    one.change(swept);
    run(one, 5);
    one.change(settings);
    BodyDefinition both = falling(disc(0.2), {2, 6});
    both.surface.kinetic = both.surface.friction;
    const BodyId ball = one.add_body(both);
    World other = World::load(one.save());
    CHECK(other.surface(ball) == both.surface);
    for (int i = 0; i < 150; ++i) {
        one.step(h);
        other.step(h);
        REQUIRE(other.work().exact == one.work().exact);
        REQUIRE(other.hash() == one.hash());
    }
}

TEST_CASE("a recording replays to the same bits and says where it does not", "[idea]")
{
    World engine = mixed_world();
    run(engine, 20);
    Recording film;
    engine.record(&film);
    run(engine, 30);
    const BodyId ball = engine.add_body(falling(disc(0.3), {0.3, 8}));
    run(engine, 60);
    engine.remove(engine.bodies()[1]);
    engine.push(ball, {1, 2}, engine.position(ball));
    engine.add_joint({}, ball, engine.joint_at(JointKind::revolute, {}, ball, {0.3, 6}));
    run(engine, 60);
    engine.record(nullptr);
    const Replay again = Recording::load(film.save()).replay();
    CHECK(again.steps == 150);
    CHECK(again.differs_at == -1);
    CHECK(again.world.hash() == engine.hash());
}

TEST_CASE("two worlds in two threads do not influence each other", "[idea]")
{
    World alone = mixed_world(), first = mixed_world(), second = mixed_world();
    for (int i = 0; i < 200; ++i) alone.step(h);
    const auto go = [](World& engine) {
        for (int i = 0; i < 200; ++i) engine.step(h);
    };
    std::thread one([&] { go(first); }), two([&] { go(second); });
    one.join();
    two.join();
    CHECK(first.hash() == alone.hash());
    CHECK(second.hash() == alone.hash());
}

TEST_CASE("a touch begins once and ends once and a fall is a hit with its speed", "[idea]")
{
    World engine;
    const WallId floor = engine.add_wall({{0, 1}, 0});
    const BodyId ball = engine.add_body(falling(disc(0.5), {0, 2.5}));
    int began = 0, ended = 0, hits = 0;
    Real speed = 0;
    for (int i = 0; i < 300; ++i) {
        engine.step(h);
        for (const Touch& touch : engine.events().began)
            if (touch.wall == floor && touch.b == ball) ++began;
        ended += static_cast<int>(engine.events().ended.size());
        for (const Hit& hit : engine.events().hits) ++hits, speed = hit.speed;
    }
    CHECK(began == 1);
    CHECK(ended == 0);
    CHECK(hits == 1);
    // √(2 g 2 m), to what gravity does in two steps
    CHECK(speed == Approx(std::sqrt(2 * 9.81 * 2)).margin(2 * 9.81 * h));
    engine.remove(ball);
    engine.step(h);
    REQUIRE(engine.events().ended.size() == 1);
    CHECK(engine.events().ended[0].b == ball);
}

TEST_CASE("a touch that bears nothing stays while its gap is small and ends where it is not", "[idea]")
{
    World engine;
    engine.add_wall({{0, 1}, 0});
    const BodyId ball = engine.add_body(falling(disc(0.5), {0, 0.5}));
    run(engine, 10);
    WorldSettings weightless = engine.settings();
    weightless.gravity = {0, 0};
    engine.change(weightless);
    engine.set_velocity(ball, {0, 0}, 0);
    // a tenth of the margin is 2 mm
    for (const auto& [gap, ends] : {std::pair{1e-3, 0}, std::pair{5e-3, 1}}) {
        engine.move(ball, {0, 0.5 + gap}, 0);
        int ended = 0;
        for (int i = 0; i < 5; ++i) {
            engine.step(h);
            ended += static_cast<int>(engine.events().ended.size());
        }
        CHECK(ended == ends);
    }
}

TEST_CASE("a sensor sees what comes in and what leaves and pushes nothing", "[idea]")
{
    World engine;
    const BodyId ball = engine.add_body(falling(disc(0.25), {0, 3}));
    BodyDefinition gate = falling(box(2, 1), {0, 0});
    gate.density = 0;
    gate.sensor = true;
    const BodyId sensor = engine.add_body(gate);
    int entered = 0, left = 0;
    for (int i = 0; i < 120; ++i) {
        engine.step(h);
        for (const Seen& seen : engine.events().entered) {
            ++entered;
            CHECK(seen == Seen{sensor, ball});
            CHECK(engine.position(ball).y() == Approx(0.75).margin(0.2));
        }
        left += static_cast<int>(engine.events().left.size());
    }
    CHECK(entered == 1);
    CHECK(left == 1);
    CHECK(engine.velocity(ball).y() == Approx(-9.81 * 2));
}

TEST_CASE("filters let through whom they should", "[idea]")
{
    for (const bool same_group : {false, true}) {
        World engine;
        BodyDefinition ledge = falling(box(4, 1), {0, 0});
        ledge.density = 0;
        ledge.filter.category = 2;
        ledge.filter.group = 7;
        engine.add_body(ledge);
        BodyDefinition ball = falling(disc(0.25), {0, 3});
        ball.filter.meets = ~2u;
        if (same_group) ball.filter.group = 7;  // stronger than masks
        const BodyId id = engine.add_body(ball);
        run(engine, 120);
        if (same_group) CHECK(engine.position(id).y() == Approx(0.75).margin(0.006));
        else CHECK(engine.position(id).y() < -5);
    }
}

TEST_CASE("rays and casts and overlaps find what is there", "[idea]")
{
    World engine;
    const WallId floor = engine.add_wall({{0, 1}, 0});
    const BodyId left = engine.add_body(falling(box(1, 1), {-3, 0.5})),
                 right = engine.add_body(falling(disc(0.5), {3, 0.5}));
    for (const bool stepped : {false, true}) {
        if (stepped) run(engine, 100);
        const auto met = engine.ray({0, 0.5}, {10, 0});
        REQUIRE(met);
        CHECK(met->body == right);
        CHECK(met->point.x() == Approx(2.5).margin(1e-3));
        CHECK(met->normal.x() == Approx(-1).margin(1e-3));
        const auto down = engine.ray({0, 2}, {0, -4});
        REQUIRE(down);
        CHECK(down->wall == floor);
        CHECK(down->part == Approx(0.5));
        CHECK(!engine.ray({0, 2}, {0, -1.9}));
        const auto cast = engine.cast(box(1, 1), {0, 0.6}, 0, {-10, 0});
        REQUIRE(cast);
        CHECK(cast->body == left);
        CHECK(10 * cast->part == Approx(2).margin(1e-4));
        CHECK(engine.overlapping(box(8, 0.5), {0, 0.5}) == std::vector<BodyId>{left, right});
        CHECK(engine.at({-3.4, 0.9}) == std::vector<BodyId>{left});
        CHECK(engine.at({0, 0.9}).empty());
    }
}

TEST_CASE("a bullet is stopped and others pass a thin wall only where they are allowed to", "[idea]")
{
    for (const bool stop : {true, false})
        for (const bool bullet : {false, true}) {
            WorldSettings settings;
            settings.gravity = {0, 0};
            settings.stop_fast = stop;
            World engine(settings);
            BodyDefinition wall = falling(box(0.05, 10), {0, 0});
            wall.density = 0;
            engine.add_body(wall);
            BodyDefinition ball = falling(disc(0.1), {-3, 0});
            ball.velocity = {300, 0};
            ball.bullet = bullet;
            const BodyId id = engine.add_body(ball);
            run(engine, 10);
            CHECK((engine.position(id).x() < 0) == (stop || bullet));
        }
}

TEST_CASE("the momentum of bodies that only meet each other stays", "[idea]")
{
    WorldSettings settings;
    settings.gravity = {0, 0};
    World engine(settings);
    Random random(3);
    for (int i = 0; i < 40; ++i) {
        const Real x = random.uniform(-3, 3), y = random.uniform(-3, 3), angle = random.uniform(0, 6);
        BodyDefinition body = falling(i % 2 ? box(0.5, 0.4) : disc(0.25), {x, y}, angle);
        body.density = random.uniform(0.5, 5);
        const Real vx = random.uniform(-2, 2), vy = random.uniform(-2, 2);
        body.velocity = {vx, vy};
        engine.add_body(body);
    }
    const auto momenta = [&] {
        Vec<3> sum = Vec<3>::Zero();
        for (const BodyId body : engine.bodies()) {
            const Vec2 p = engine.mass(body) * engine.velocity(body);
            sum += Vec<3>(p.x(), p.y(),
                          cross2(engine.position(body), p) + engine.inertia(body) * engine.spin(body));
        }
        return sum;
    };
    const Vec<3> before = momenta();
    run(engine, 200);
    const Vec<3> change = momenta() - before;
    // rounding of some thousand impulses of up to 10 N s
    CHECK(change.head<2>().norm() < 1e-10);
    // overlaps are corrected between two centroids by equal impulses on points that are not quite the same: to the slop
    CHECK(std::abs(change[2]) < 0.2);
}

TEST_CASE("a step tells its stages in their order and its bits are the same", "[house]")
{
    WorldSettings settings;
    settings.substeps = 2;
    World told(settings), silent(settings);
    for (World* const engine : {&told, &silent}) {
        engine->add_wall({{0, 1}, 0});
        engine->add_body(falling(box(1, 1), {0, 0.6}, 0.1));
    }
    const std::vector<Stage> order = {Stage::contacts,  Stage::start,    Stage::rows,   Stage::solver,
                                      Stage::positions, Stage::rows,     Stage::solver, Stage::positions,
                                      Stage::start,     Stage::contacts, Stage::report};
    std::vector<Stage> stages;
    int steps = 0;
    for (; steps < 400 && (steps == 0 || told.work().awake > 0); ++steps) {
        stages.clear();
        told.step(h, [&](Stage stage) { stages.push_back(stage); });
        silent.step(h);
        if (told.work().awake > 0) CHECK(stages == order);
        REQUIRE(told.hash() == silent.hash());
    }
    CHECK(steps < 400);
    // all sleep: there is no step, and nothing to tell
    stages.clear();
    told.step(h, [&](Stage stage) { stages.push_back(stage); });
    CHECK(told.work().skipped);
    CHECK(stages.empty());
}
