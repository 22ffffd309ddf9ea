/// Chapter 19: bodies of several shapes: their mass, what each shape touches, and that all of them move as one.

#include "chapters/19_engine/furniture.hpp"
#include "chapters/19_engine/recording.hpp"
#include "chapters/19_engine/world.hpp"

#include "common/random.hpp"
#include "tests/catch.hpp"
#include "tests/world_run.hpp"

#include <algorithm>
#include <cmath>

using namespace rigid;
using Catch::Contains;

namespace bodies_of_shapes {  // sources of one target are compiled together

namespace {

using worlds::body_at;
using worlds::frame;
using worlds::run;

ShapeDefinition more(const Polygon& shape, Real friction = 0.6)
{
    return {.shape = shape, .surface = {friction, 0, 0, 0}};
}

/// A board of 2 m, 0.2 m thick, on two legs of 1 m; its lowest point is 0.8 m below its centroid.
BodyId add_table(World& engine, const Vec2& at)
{
    return engine.add_body(body_at(at, 1, box(2, 0.2)), std::vector{more(shifted(box(0.2, 1), {-0.9, -0.6})),
                                                                    more(shifted(box(0.2, 1), {0.9, -0.6}))});
}

/// A bottom of 2 m and two sides, open above.
std::vector<ShapeDefinition> sides()
{
    return {more(shifted(box(0.2, 1.2), {-1.1, 0.5})), more(shifted(box(0.2, 1.2), {1.1, 0.5}))};
}

BodyId add_cup(World& engine, const Vec2& at, Real density = 0)
{
    return engine.add_body(body_at(at, density, box(2, 0.2)), sides());
}

/// The lowest point of all shapes of a body.
Real lowest(const World& engine, BodyId body)
{
    Real y = infinity;
    for (const BodyId shape : engine.shapes(body))
        for (const Vec2& v : engine.shape(shape).vertices)
            y = std::min(y, engine.point_of(body, v).y() - engine.shape(shape).radius);
    return y;
}

}  // namespace

TEST_CASE("a body of several shapes has the mass of all and turns about their centroid", "[idea]")
{
    World engine({.gravity = {0, 0}});
    BodyDefinition definition = body_at({2, 1}, 3, disc(0.5));
    definition.velocity = {1, 0};
    definition.spin = 5;
    ShapeDefinition light = more(shifted(disc(0.5), {3, 0}));
    light.density = 1;
    const BodyId body = engine.add_body(definition, std::vector{light});
    const Real m = pi / 4;  // of a disc of density 1
    CHECK(engine.mass(body) == Approx(4 * m).epsilon(1e-15));
    // the centroid is a quarter of the way to the light one: 0.75 m and 2.25 m away
    CHECK(engine.inertia(body) == Approx(4 * m / 8 + 3 * m * 0.75 * 0.75 + m * 2.25 * 2.25).epsilon(1e-14));
    CHECK(engine.shape(body).vertices[0].x() == Approx(-0.75).epsilon(1e-15));
    CHECK(engine.shape(engine.shapes(body)[1]).vertices[0].x() == Approx(2.25).epsilon(1e-15));
    run(engine, 600);
    CHECK((engine.position(body) - Vec2(12, 1)).norm() < 1e-11);
    CHECK(engine.angle(body) == Approx(50).epsilon(1e-12));
    // each shape is where the body is
    for (const BodyId shape : engine.shapes(body)) {
        CHECK(engine.position(shape) == engine.position(body));
        CHECK(engine.angle(shape) == engine.angle(body));
    }
}

TEST_CASE("two boxes that are one body move as one box", "[idea]")
{
    for (const Real angle : {0.0, 0.3, 1.2}) {
        World one, two;
        for (World* const engine : {&one, &two}) engine->add_wall({Vec2(-0.1, 1).normalized(), 0});
        BodyDefinition whole = body_at({0, 3}, 2, box(2, 1)), half = body_at({0, 3}, 2, box(1, 1));
        whole.angle = half.angle = angle;
        whole.velocity = half.velocity = {2, 0};
        const BodyId a = one.add_body(whole),
                     b = two.add_body(half, std::vector{more(shifted(box(1, 1), {1, 0}))});
        CHECK(one.mass(a) == Approx(two.mass(b)).epsilon(1e-15));
        CHECK(one.inertia(a) == Approx(two.inertia(b)).epsilon(1e-14));
        for (int n = 0; n < 200; ++n) {
            one.step(frame), two.step(frame);
            // rows in the middle of a side add nothing: what is solved is exact to 1e-12 m/s a step
            REQUIRE((one.position(a) - two.position(b)).norm() < 1e-9);
            REQUIRE(std::abs(one.angle(a) - two.angle(b)) < 1e-9);
        }
    }
}

TEST_CASE("the feet of tables bear all that stands on them while they sleep too", "[idea]")
{
    World engine;
    engine.add_wall({{0, 1}, 0});
    std::vector<BodyId> tables;
    for (int i = 0; i < 3; ++i) tables.push_back(add_table(engine, {0, 1 + 1.3 * i}));
    const BodyId on_top = engine.add_body(body_at({0.3, 5}, 1, box(0.5, 0.5)));
    run(engine, 120);
    CHECK(engine.work().skipped);
    CHECK(engine.work().bodies == 4);
    for (int i = 0; i < 3; ++i)
        CHECK(engine.position(tables[static_cast<std::size_t>(i)]).y() == Approx(0.8 + 1.2 * i).margin(1e-6));
    Real weight = 0, borne = 0, above = 0;
    for (const BodyId body : engine.bodies()) weight += engine.mass(body) * 9.81;
    std::vector<ContactView> list;
    engine.contacts(tables[0], list);
    for (const ContactView& contact : list) {
        (contact.touch.wall ? borne : above) += contact.impulse / frame;
        CHECK(engine.body_of(contact.touch.wall ? contact.touch.b : contact.touch.a) == tables[0]);
        // the floor touches legs, the next table's legs the board
        CHECK((contact.touch.wall ? contact.touch.b != tables[0] : contact.touch.a == tables[0]));
    }
    CHECK(borne == Approx(weight).epsilon(1e-4));
    CHECK(above == Approx(weight - engine.mass(tables[0]) * 9.81).epsilon(1e-4));

    // a push at the name of a leg is one of the body, and wakes what stands on it
    engine.push(engine.shapes(tables[0])[2], {0, 4}, {0.9, 0.4});
    engine.step(frame);
    CHECK(engine.work().awake == 4);
    CHECK(engine.spin(tables[0]) > 0);
    CHECK(engine.is_awake(on_top));
}

TEST_CASE("what sleeps on another shape of a body falls when the body goes", "[idea]")
{
    for (const bool fixed : {true, false}) {
        World engine;
        engine.add_wall({{0, 1}, -5});
        const BodyId cup = add_cup(engine, {0, fixed ? 0 : -4.9}, fixed ? 0 : 1);
        const BodyId ball =
            engine.add_body(body_at({1.1, fixed ? 1.3 : -3.6}, 1, box(0.15, 0.15)));  // on a side
        run(engine, 90);
        REQUIRE(!engine.is_awake(ball));
        const Real y = engine.position(ball).y();
        engine.move(cup, {-9, engine.position(cup).y()}, 0);
        run(engine, 20);
        CHECK(engine.position(ball).y() < y - 0.4);
        CHECK((engine.position(cup).x() < -8.9 && engine.shape(cup).vertices.size() == 4));
        // the shapes are where it is
        CHECK(
            !engine
                 .at(engine.point_of(cup, engine.shape(engine.shapes(cup)[2]).vertices[0] + Vec2(0.05, 0.05)))
                 .empty());
        CHECK(engine.at({1.1, y - 0.3}).empty());
    }
}

TEST_CASE("a cup that moves takes along what lies in it and loses nothing", "[idea]")
{
    World engine;
    const BodyId cup = add_cup(engine, {0, 0});
    std::vector<BodyId> balls;
    for (int i = 0; i < 6; ++i)
        balls.push_back(
            engine.add_body(body_at({-0.6 + 0.25 * i, 1 + 0.5 * i}, 1, i % 2 ? box(0.4, 0.4) : disc(0.2))));
    engine.set_velocity(cup, {1, 0}, 0);
    run(engine, 400);
    CHECK(engine.position(cup).x() == Approx(400 * frame).epsilon(1e-12));
    for (const BodyId ball : balls) {
        CHECK(std::abs(engine.position(ball).x() - engine.position(cup).x()) < 0.95);
        CHECK(engine.velocity(ball).x() == Approx(1).margin(0.02));
        CHECK(engine.kind(engine.shapes(cup)[1]) == BodyKind::kinematic);
    }
}

TEST_CASE("a shape lies on an edge of a chain though the centroid of its body is behind it", "[idea]")
{
    // a gate over a post: its bar lies on the top, its legs hang beside it
    World engine;
    engine.add_chain(std::vector<Vec2>{{0.2, 0}, {0.2, 1}, {-0.2, 1}, {-0.2, 0}}, true);
    const BodyId gate = engine.add_body(
        body_at({0, 0.57}, 1, box(2, 0.1)),
        std::vector{more(shifted(box(0.1, 1.5), {-0.9, -0.8})), more(shifted(box(0.1, 1.5), {0.9, -0.8}))});
    const Real bar = engine.shape(gate).vertices[0].y();  // its lower side
    engine.move(gate, {0, 1.1 - bar}, 0);
    run(engine, 120);
    CHECK(engine.position(gate).y() + bar == Approx(1).margin(0.006));
    CHECK(engine.position(gate).y() < 0.6);
}

TEST_CASE("what comes to rest under another shape of a sleeper wakes it", "[house]")
{
    for (const Real x : {0.0, 2.0}) {
        World engine;
        engine.add_wall({{0, 1}, 0});
        const BodyId two = engine.add_body(body_at({1, 0.5}), std::vector{more(shifted(box(1, 1), {2, 0}))});
        run(engine, 60);
        REQUIRE(!engine.is_awake(two));
        engine.add_body(body_at({x, 0.5}, 0, box(0.3, 0.3)));  // cannot move, and is in one of the two
        engine.step(frame);
        CHECK(engine.is_awake(two));
    }
}

TEST_CASE("a place that was another body's is looked at once", "[house]")
{
    World fresh({.sleep = false}), used({.sleep = false});
    for (World* const engine : {&fresh, &used})
        engine->add_wall({{0, 1}, 0}), engine->add_wall({{1, 0}, -0.5});
    const BodyId a = used.add_body(body_at({3, 3})), b = used.add_body(body_at({5, 3}));
    used.step(frame);
    used.remove(a), used.remove(b);
    for (World* const engine : {&fresh, &used}) {
        const BodyId it =
            engine->add_body(body_at({0.5, 0.5}), std::vector{more(shifted(box(1, 1), {1, 0}))});
        CHECK(engine->shapes(it).size() == 2);
        for (int n = 0; n < 3; ++n) {
            engine->step(frame);
            CHECK(engine->events().began.size() == (n == 0 ? 3U : 0U));  // two on the ground, one at the side
            CHECK(engine->events().ended.empty());
            CHECK(engine->work().contacts == 6);
        }
    }
}

TEST_CASE("all shapes of a fast body stop where the first of them touches", "[idea]")
{
    for (const bool chain : {false, true})
        for (const Real spin : {0.0, 20.0, 60.0})
            for (const Real speed : {50.0, 200.0, 1000.0}) {
                World engine({.gravity = {0, 0}});
                if (chain) engine.add_chain(std::vector<Vec2>{{5, 50}, {5, -50}});
                else engine.add_body(body_at({5, 0}, 0, box(0.05, 100)));
                BodyDefinition barbell = body_at({0, 0}, 1, disc(0.1));
                barbell.angle = 0.4;
                barbell.velocity = {speed, 0};
                barbell.spin = spin;
                const BodyId body =
                    engine.add_body(barbell, std::vector{more(shifted(disc(0.1), {1, 0})),
                                                         more(shifted(box(0.9, 0.04), {0.5, 0}))});
                Real farthest = 0;
                int stopped = 0;
                for (int n = 0; n < 120; ++n) {
                    engine.step(frame);
                    stopped += engine.work().stopped;
                    for (const BodyId shape : engine.shapes(body))
                        for (const Vec2& v : engine.shape(shape).vertices)
                            farthest =
                                std::max(farthest, engine.point_of(body, v).x() + engine.shape(shape).radius);
                }
                INFO("chain " << chain << ", speed " << speed << ", spin " << spin);
                CHECK(stopped > 0);
                // the near side of the wall is at 4.975 m; a slow end that turns into it may go in by half its radius
                CHECK(farthest < 5 + 0.05);
                CHECK(farthest > 4.9);
            }
}

TEST_CASE("each shape has a surface of its own", "[idea]")
{
    // feet at ±d, the centroid h above the ground: the front foot rubs, and bears N = m g d / (2 d − μ h)
    World engine;
    engine.add_wall({{0, 1}, 0}, {1, 0, 0, 0});
    const Real mu = 0.5, d = 1;
    BodyDefinition slider = body_at({0, 0.6}, 1, box(2.4, 0.2));
    slider.velocity = {6, 0};
    const auto foot = [](Real x, Real friction) { return more(shifted(disc(0.1), {x, -0.4}), friction); };
    const BodyId body = engine.add_body(slider, std::vector{foot(-d, 0), foot(d, mu * mu)});
    // coefficients of two surfaces make their geometric mean
    REQUIRE(engine.surface(engine.shapes(body)[2]).friction == 0.25);
    const Real h = 0.5 - engine.shape(engine.shapes(body)[1]).vertices[0].y() - 0.4;
    engine.move(body, {0, h}, 0);
    engine.set_velocity(body, {6, 0}, 0);
    run(engine, 30);
    const Real before = engine.velocity(body).x();
    run(engine, 30);
    const Real slows = (before - engine.velocity(body).x()) / (30 * frame);
    CHECK(slows == Approx(mu * 9.81 * d / (2 * d - mu * h)).epsilon(1e-6));
    // the other way round the rear foot rubs
    engine.set_surface(engine.shapes(body)[1], {mu * mu, 0, 0, 0});
    engine.set_surface(engine.shapes(body)[2], {0, 0, 0, 0});
    engine.set_velocity(body, {6, 0}, 0);
    run(engine, 30);
    CHECK((6 - engine.velocity(body).x()) / (30 * frame) ==
          Approx(mu * 9.81 * d / (2 * d + mu * h)).epsilon(1e-6));
}

TEST_CASE("each shape has a filter of its own and may be a sensor that goes along", "[idea]")
{
    World engine;
    engine.add_body(body_at({0, -1}, 0, box(20, 2)));
    ShapeDefinition ghost = more(shifted(disc(0.3), {0, -0.8})), nose = more(disc(2));
    ghost.filter = {0, 0, 0};
    ghost.user = 7;
    nose.sensor = true;
    BodyDefinition definition = body_at({0, 3});
    definition.user = 3;
    const BodyId body = engine.add_body(definition, std::vector{ghost, nose}),
                 stone = engine.add_body(body_at({0, 0.2}, 1, disc(0.2)));
    const std::vector<BodyId> shapes = engine.shapes(body);
    REQUIRE(shapes.size() == 3);
    CHECK(shapes[0] == body);
    CHECK(engine.user(shapes[0]) == 3);
    CHECK(engine.user(shapes[1]) == 7);
    CHECK(engine.mass(body) == Approx(1 + 0.09 * pi).epsilon(1e-15));  // a sensor weighs nothing
    std::vector<Seen> entered;
    std::vector<Touch> began;
    for (int n = 0; n < 120; ++n) {
        engine.step(frame);
        const Events& events = engine.events();
        entered.insert(entered.end(), events.entered.begin(), events.entered.end());
        began.insert(began.end(), events.began.begin(), events.began.end());
    }
    // the stone and the ground; the body's own shapes are nothing that a sensor of it sees
    REQUIRE(entered.size() == 2);
    for (const Seen& seen : entered) {
        CHECK(seen.sensor == shapes[2]);
        CHECK((seen.body == stone || seen.body == engine.bodies()[0]));
    }
    // the disc below it meets nothing: it lands on the box, on the stone
    for (const Touch& touch : began) CHECK((touch.a != shapes[1] && touch.b != shapes[1]));
    const auto end_of = [&](BodyId shape) {
        return engine.point_of(body, engine.shape(shape).vertices[0]).y() - engine.shape(shape).radius;
    };
    CHECK(end_of(shapes[1]) < -0.05);
    engine.set_filter(shapes[1], {});
    run(engine, 120);
    CHECK(end_of(shapes[1]) > -0.01);
    // nor does a half-space push a sensor, and a fast one stops nowhere
    World fast({.gravity = {0, 0}});
    fast.add_wall({{-1, 0}, -10});
    BodyDefinition flying = body_at({0, 0}, 1, disc(0.2));
    flying.velocity = {500, 0};
    fast.add_body(flying, std::vector{nose});
    run(fast, 1);
    CHECK(fast.position(fast.bodies()[0]).x() == Approx(500 * frame).epsilon(1e-12));
    run(fast, 60);
    CHECK(fast.position(fast.bodies()[0]).x() == Approx(9.8).margin(0.01));
}

TEST_CASE("shapes of one body or of two that are joined never touch", "[idea]")
{
    World engine({.gravity = {0, 0}});
    const auto cross = [&](const Vec2& at) {
        return engine.add_body(body_at(at, 1, box(2, 0.2)),
                               std::vector{more(box(0.2, 2)), more(shifted(disc(0.3), {1, 0}))});
    };
    const BodyId a = cross({0, 0}), b = cross({0.5, 0.1});
    std::vector<ContactView> list;
    engine.step(frame);
    engine.contacts(list);
    CHECK(!list.empty());  // of two bodies
    // a joint may be made by the name of any shape, and is one of the body
    const JointId pin =
        engine.add_joint(engine.shapes(a)[2], engine.shapes(b)[1],
                         engine.joint_at(JointKind::revolute, engine.shapes(a)[1], b, {0.25, 0}));
    CHECK(engine.body_a(pin) == a);
    CHECK(engine.body_b(pin) == b);
    CHECK(engine.joints(engine.shapes(b)[2]) == std::vector{pin});
    engine.set_velocity(engine.shapes(a)[1], {0, 0}, 3);
    for (int n = 0; n < 30; ++n) {
        engine.step(frame);
        engine.contacts(list);
        REQUIRE(list.empty());
    }
    CHECK(engine.error(pin) < 1e-8);
    CHECK(engine.spin(engine.shapes(a)[2]) == engine.spin(a));
}

TEST_CASE("nothing catches on the seams of a body of several shapes that stands", "[idea]")
{
    World engine({.sleep = false});
    std::vector<ShapeDefinition> tiles;
    for (int i = 1; i < 20; ++i) tiles.push_back(more(shifted(box(1, 1), {1.0 * i, 0}), 0));
    BodyDefinition first = body_at({9.5, -0.5}, 0);
    first.surface.friction = 0;
    engine.add_body(first, tiles);
    BodyDefinition disc_on = body_at({0, 0.2}, 1, disc(0.2)), box_on = body_at({3, 0.2}, 1, box(0.4, 0.4));
    for (BodyDefinition* const it : {&disc_on, &box_on}) it->velocity = {15, 0}, it->surface.friction = 0;
    const BodyId a = engine.add_body(disc_on), b = engine.add_body(box_on);
    for (int n = 0; n < 60; ++n) {
        engine.step(frame);
        CHECK(engine.velocity(a).x() == Approx(15).epsilon(1e-9));
        CHECK(engine.velocity(b).x() == Approx(15).epsilon(1e-9));
    }
}

TEST_CASE("a body is as fast as the farthest of its shapes and as thin as the thinnest", "[idea]")
{
    // without gravity what is slow sleeps: this one is slow at its first shape alone
    World still({.gravity = {0, 0}});
    const Real rest = still.settings().rest.speed;
    BodyDefinition pole = body_at({0, 0}, 1, disc(0.1));
    pole.mass = Mass{1, {0, 0}, 1};
    pole.spin = 2 * rest / 10;
    const BodyId with = still.add_body(pole, std::vector{more(shifted(disc(0.1), {10, 0}))});
    pole.position = {30, 0};
    const BodyId without = still.add_body(pole);
    run(still, 120);
    CHECK(still.is_awake(with));
    CHECK(!still.is_awake(without));

    // (rods of 1 mm are not left in what they lie on by the slop of a box)
    World engine;
    engine.add_wall({{0, 1}, 0});
    const BodyId frame_of_rods = engine.add_body(body_at({0, 0.6}, 1000, box(1, 0.3)),
                                                 std::vector{more(shifted(box(0.001, 0.3), {-0.4, -0.3})),
                                                             more(shifted(box(0.001, 0.3), {0.4, -0.3}))});
    const Real low = lowest(engine, frame_of_rods) - engine.position(frame_of_rods).y();
    engine.move(frame_of_rods, {0, -low - 0.002}, 0);
    run(engine, 300);
    CHECK(lowest(engine, frame_of_rods) > -3e-6);
}

TEST_CASE("a heap of bodies of several shapes goes by small steps like any other", "[house]")
{
    // hooks and tables have more rows between two of them than a bundle of chapter 17 has
    World engine = furniture_world(100, 1);
    int stepped = 0, most = 0;
    std::vector<ContactView> list;
    for (int n = 0; n < 200; ++n) {
        engine.step(frame);
        CHECK(engine.work().unsolved == 0);
        stepped += engine.work().stepped;
        engine.contacts(list);
        std::vector<std::pair<BodyId, BodyId>> pairs;
        for (const ContactView& it : list)
            if (it.touch.a) pairs.emplace_back(engine.body_of(it.touch.a), engine.body_of(it.touch.b));
        std::sort(pairs.begin(), pairs.end());
        for (std::size_t i = 0, same = 0; i < pairs.size(); ++i) {
            same = i > 0 && pairs[i] == pairs[i - 1] ? same + 1 : 1;
            most = std::max(most, static_cast<int>(same));
        }
    }
    CHECK(stepped > 100);
    CHECK(2 * most > 15);
}

TEST_CASE("what is entangled from the beginning is not thrown away by its overlaps", "[house]")
{
    // crosses that begin in one another fly to one place: overlaps that work against each other
    for (const std::uint64_t seed : {3U, 4U, 5U, 6U})
        for (const int substeps : {1, 4}) {
            World engine({.gravity = {0, 0}, .substeps = substeps});
            Random random(seed);
            for (int i = 0; i < 20; ++i) {
                BodyDefinition body;
                body.shape = box(1, 0.2);
                const Real around = random.uniform(0, 2 * pi);
                body.position = {6 * rigid::cos(around) + random.uniform(-1, 1),
                                 6 * rigid::sin(around) + random.uniform(-1, 1)};
                body.velocity = -0.7 * body.position;
                body.spin = random.uniform(-3, 3);
                engine.add_body(body, std::vector{more(box(0.2, 1)), more(shifted(disc(0.3), {0.5, 0}))});
            }
            const std::vector<BodyId> all = engine.bodies();
            for (int n = 0; n < 150; ++n) {
                std::vector<Vec2> before;
                for (const BodyId body : all) before.push_back(engine.position(body));
                engine.step(frame);
                for (std::size_t k = 0; k < all.size(); ++k)
                    REQUIRE((engine.position(all[k]) - before[k]).norm() < 0.5);  // at 6 m/s 0.1
            }
        }
}

TEST_CASE("shapes are saved and recorded and go with their body by whatever name", "[idea]")
{
    Recording film;
    World engine;
    engine.record(&film);
    engine.add_wall({{0, 1}, 0});
    const BodyId table = add_table(engine, {0, 2}), cup = add_cup(engine, {0.2, 4}, 2);
    run(engine, 40);
    World other = World::load(engine.save());
    for (int n = 0; n < 40; ++n) {
        engine.step(frame), other.step(frame);
        REQUIRE(engine.hash() == other.hash());
    }
    CHECK(other.shapes(cup) == engine.shapes(cup));
    CHECK(engine.bodies() == std::vector{table, cup});
    const auto met = engine.ray({-1.0, 9}, {0, -20});
    REQUIRE(met);
    CHECK(engine.body_of(met->body) == cup);
    CHECK(met->body != cup);  // a side of it

    engine.set_enabled(engine.shapes(cup)[2], false);
    CHECK(!engine.is_enabled(cup));
    CHECK(engine.body_of(engine.ray({-1.0, 9}, {0, -20})->body) == table);
    engine.set_enabled(cup, true);
    CHECK(engine.body_of(engine.ray({-1.0, 9}, {0, -20})->body) == cup);

    const std::vector<BodyId> gone = engine.shapes(table);
    engine.remove(gone[1]);
    for (const BodyId name : gone) CHECK(!engine.has(name));
    CHECK(engine.bodies() == std::vector{cup});
    run(engine, 60);
    CHECK(engine.work().bodies == 1);
    CHECK(lowest(engine, cup) == Approx(0).margin(0.006));
    // places are used again, by bodies and by shapes
    const BodyId box_there = engine.add_body(body_at({5, 2})), new_cup = add_cup(engine, {9, 3}, 1);
    CHECK(engine.shapes(box_there) == std::vector{box_there});
    CHECK(engine.shapes(new_cup).size() == 3);
    const auto is_new = [&](BodyId it) { return it.generation > 1; };
    CHECK(is_new(box_there));
    const std::vector<BodyId> new_shapes = engine.shapes(new_cup);
    CHECK(std::any_of(new_shapes.begin(), new_shapes.end(), is_new));
    run(engine, 120);
    CHECK(engine.position(box_there).y() == Approx(0.5).margin(0.006));
    CHECK(lowest(engine, new_cup) == Approx(0).margin(0.006));
    CHECK(film.replay().differs_at == -1);
}

TEST_CASE("another shape comes where the old one was and the mass stays", "[idea]")
{
    World engine({.gravity = {0, 0}});
    const BodyId cup = add_cup(engine, {0, 0}, 1);
    const BodyId side = engine.shapes(cup)[1];
    const Real mass = engine.mass(cup);
    Vec2 middle(0, 0);
    for (const Vec2& v : engine.shape(side).vertices) middle += v / 4;
    engine.set_shape(side, shifted(disc(0.5), {7, 7}));
    CHECK((engine.shape(side).vertices[0] - middle).norm() < 1e-14);
    CHECK(engine.mass(cup) == mass);
    CHECK(engine.at(engine.point_of(cup, middle + Vec2(-0.45, 0))) == std::vector{side});
    // far from the body's centroid rounding would make one point of two vertices
    BodyDefinition far = body_at({0, 0}, 1, box(1e9, 1e9));
    const BodyId wide = engine.add_body(far, std::vector{more(shifted(box(1e9, 1e9), {1e17, 0}))});
    CHECK_THROWS_WITH(engine.set_shape(engine.shapes(wide)[1], box(1, 1)), Contains("vert"));
    CHECK(engine.shape(engine.shapes(wide)[1]).vertices.size() == 4);
    engine.remove(wide);
    CHECK_THROWS_WITH(engine.set_density(cup, 2), Contains("several shapes") && Contains("set_mass()"));
    engine.set_mass(side, 5, 6);
    CHECK(engine.mass(cup) == 5);
    engine.set_density(cup, 0);
    CHECK(engine.mass(side) == infinity);
}

TEST_CASE("shapes that make no sense are refused and nothing is added", "[idea]")
{
    World engine;
    const auto refused = [&](const ShapeDefinition& shape, const BodyDefinition& body = {}) {
        std::string sentence;
        try {
            engine.add_body(body, std::vector{more(box(1, 1)), shape});
        } catch (const std::invalid_argument& thrown) {
            sentence = thrown.what();
        }
        CHECK(engine.bodies().empty());
        return sentence;
    };
    ShapeDefinition shape;
    shape.density = -1;
    CHECK_THAT(refused(shape), Contains("the density of the shape is -1 kg/m²"));
    shape.density = 1;
    BodyDefinition given;
    given.mass = Mass{1, {0, 0}, 1};
    CHECK_THAT(refused(shape, given), Contains("the shape has the density 1 kg/m²") && Contains("was given"));
    shape.sensor = true;
    CHECK_THAT(refused(shape), Contains("the shape has the density 1 kg/m²") && Contains("a sensor"));
    BodyDefinition sensor;
    sensor.density = 0;
    sensor.sensor = true;
    CHECK_THAT(refused({}, sensor), Contains("2 shapes more"));
    CHECK_THAT(refused({.shape = {}}), Contains("no vertex"));
    CHECK_THAT(refused({.shape = shifted(box(1, 1), {infinity, 0})}),
               Contains("inf") && Contains("vertex 0"));
    CHECK_THAT(refused(more(box(1, 1), -2)), Contains("friction") && Contains("-2"));
    CHECK_THAT(refused({.shape = {{{0, 0}, {1, 0}}, 0}}), Contains("area"));  // of a body that has a density
}

}  // namespace bodies_of_shapes
