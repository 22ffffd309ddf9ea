/// Chapter 19: what comes and goes, settings at their ends, and hostile worlds.

#include "tests/no_allocation.hpp"

#include "chapters/19_engine/moving_worlds.hpp"
#include "chapters/19_engine/places.hpp"
#include "chapters/19_engine/recording.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <limits>

using namespace rigid;
using Catch::Contains;

namespace {

constexpr Real frame = 1.0 / 60;

}  // namespace

TEST_CASE("a steady step asks for no memory", "[house]")
{
    for (const Solving solving : {Solving::by_island, Solving::sweeps}) {
        WorldSettings settings;
        settings.solving = solving;
        settings.sleep = false;
        World engine(settings);
        put_in(engine, card_house(2, 0.6));
        JointedScene chain = chain_scene({8, 0.1, 0.1, 10, 0});
        for (Index k = 0; k < chain.bodies.count(); ++k) chain.bodies.position(k).head<2>() += Vec2(9, 9);
        chain.placed[0].joint.at_a += Vec2(9, 9);
        put_in(engine, chain, {1, ~0u, -1});
        BodyDefinition gate = body_of(box(2, 2), {0, 0.5}, 0, 0);
        gate.sensor = true;
        engine.add_body(gate);
        for (int i = 0; i < 300; ++i) engine.step(frame);
        int count = 0;
        {
            const NoAllocation watch;
            for (int i = 0; i < 20; ++i) engine.step(frame);
            count = NoAllocation::violations();
        }
        CHECK(count == 0);
    }
}

TEST_CASE("a joint that is taken out holds no more and its place is used again", "[idea]")
{
    World engine;
    const BodyId bob = engine.add_body(body_of(disc(0.2), {1, 5}));
    RigidJoint pin = engine.joint_at(JointKind::revolute, {}, bob, {0, 5});
    const JointId first = engine.add_joint({}, bob, pin);
    for (int i = 0; i < 60; ++i) engine.step(frame);
    CHECK((engine.position(bob) - Vec2(0, 5)).norm() == Approx(1).margin(1e-6));
    engine.remove(first);
    CHECK(!engine.has(first));
    CHECK_THROWS_WITH(engine.error(first), Contains("was removed"));
    const Vec2 v = engine.velocity(bob);
    engine.step(frame);
    CHECK(engine.velocity(bob).x() == Approx(v.x()).epsilon(1e-13));
    const JointId second =
        engine.add_joint({}, bob, engine.joint_at(JointKind::revolute, {}, bob, engine.position(bob)));
    CHECK(second.place == first.place);
    for (int i = 0; i < 60; ++i) engine.step(frame);
    CHECK(engine.error(second) < 1e-8);
    engine.remove(bob);
    CHECK(!engine.has(second));
    engine.step(frame);
}

TEST_CASE("a place that was used four billion times still has an id that names something", "[house]")
{
    Places<BodyTag> places;
    const BodyId first = places.append();
    places.give_back(0);
    places.generation[0] = std::numeric_limits<std::uint32_t>::max();
    const BodyId id = places.take(0);
    CHECK(id);
    CHECK(id == first);  // the names begin again
    CHECK(places.require(id, "body") == 0);
}

TEST_CASE("two bodies whose joint is taken out touch again", "[idea]")
{
    World engine;
    engine.add_wall({{0, 1}, 0});
    const BodyId low = engine.add_body(body_of(box(1, 1), {0, 0.5})),
                 high = engine.add_body(body_of(box(1, 1), {0, 1.5}));
    const JointId weld = engine.add_joint(low, high, engine.joint_at(JointKind::weld, low, high, {0, 1}));
    for (int i = 0; i < 100; ++i) engine.step(frame);
    engine.remove(weld);
    for (int i = 0; i < 100; ++i) engine.step(frame);
    CHECK(engine.position(high).y() == Approx(1.5).margin(0.012));
}

TEST_CASE("a joint that breaks is reported once", "[idea]")
{
    World engine;
    const BodyId weight = engine.add_body(body_of(disc(0.2), {0, 4}, 0, 100));
    RigidJoint pin = engine.joint_at(JointKind::rope, {}, weight, {0, 4});
    pin.length = 1;
    pin.breaking_force = 500;
    const JointId rope = engine.add_joint({}, weight, pin);
    int broken = 0;
    for (int i = 0; i < 120; ++i) {
        engine.step(frame);
        broken += static_cast<int>(engine.events().broken.size());
    }
    CHECK(broken == 1);
    CHECK(engine.is_broken(rope));
    CHECK(engine.position(weight).y() < 2);
}

TEST_CASE("a body slides over a chain of edges and the chain goes as a whole", "[idea]")
{
    World engine;
    std::vector<Vec2> floor;
    for (int i = 20; i >= -20; --i) floor.push_back({0.5 * i, 0});
    const BodyId chain = engine.add_chain(floor, false, {0, 0, 0, 0});
    BodyDefinition slides = body_of(box(0.6, 0.6), {-8, 0.3});
    slides.velocity = {3, 0};
    const BodyId body = engine.add_body(slides);
    for (int i = 0; i < 120; ++i) engine.step(frame);
    CHECK(engine.velocity(body).x() == Approx(3).margin(1e-9));
    CHECK(engine.bodies().size() == 41);
    engine.remove(chain);
    CHECK(engine.bodies() == std::vector<BodyId>{body});
    for (int i = 0; i < 30; ++i) engine.step(frame);
    CHECK(engine.position(body).y() < -0.5);
}

TEST_CASE("a fixed body that is put into a sleeping pile wakes what it touches and nothing else", "[idea]")
{
    World engine = piles_world(3);
    for (int i = 0; i < 200; ++i) engine.step(frame);
    REQUIRE(engine.work().skipped);
    BodyDefinition wedge = body_of(box(0.5, 0.1), {0.2, 2.52}, 0, 0);
    engine.add_body(wedge);
    engine.step(frame);
    int awake = 0;
    const std::vector<BodyId> all = engine.bodies();
    for (std::size_t i = 0; i < 15; ++i) {
        awake += engine.is_awake(all[i]);
        if (i >= 5) CHECK(!engine.is_awake(all[i]));
    }
    CHECK(awake == 5);
}

TEST_CASE("another surface or filter of one body wakes that body and no other pile", "[idea]")
{
    World engine = piles_world(2);
    for (int i = 0; i < 200; ++i) engine.step(frame);
    const std::vector<BodyId> all = engine.bodies();
    engine.set_surface(all[0], {0.1, 0, 0, 0});
    engine.step(frame);
    CHECK(engine.is_awake(all[0]));
    CHECK(!engine.is_awake(all[9]));
    engine.set_filter(all[4], {1, 0, 0});  // the top one meets walls alone
    for (int i = 0; i < 120; ++i) engine.step(frame);
    CHECK(engine.position(all[4]).y() == Approx(0.25).margin(0.006));
    CHECK(!engine.is_awake(all[9]));
}

namespace {

/// Piles of five, and discs that roll on and on beside them, when the piles have fallen asleep.
World piles_beside_discs(int piles, int discs)
{
    World engine = piles_world(piles);
    for (int i = 0; i < discs; ++i) {
        BodyDefinition disc_of = body_of(disc(0.25), {-2.0 - i, 0.25});
        disc_of.velocity = {-0.5, 0};
        disc_of.spin = 2;
        engine.add_body(disc_of);
    }
    for (int i = 0; i < 60; ++i) engine.step(frame);
    return engine;
}

}  // namespace

TEST_CASE("a step passes what is awake and nothing of what sleeps beside it", "[house]")
{
    for (const int piles : {10, 200}) {
        World engine = piles_beside_discs(piles, 20);
        for (int i = 0; i < 20; ++i) {
            engine.step(frame);
            CHECK(engine.work().awake == 20);
            CHECK(engine.work().walked == 20);  // their touches with the floor
        }
        const BodyId rolls = engine.bodies().back();
        engine.set_velocity(rolls, {-0.6, 0}, 2.4);
        engine.step(frame);
        CHECK(engine.work().awake == 20);
        CHECK(engine.work().walked == 21);  // and the one body that was changed
    }
}

TEST_CASE("what calls have changed is found in one pass however many bodies it is", "[house]")
{
    const auto walked = [](int piles) {
        World engine = piles_beside_discs(piles, 1);
        const std::vector<BodyId> all = engine.bodies();
        for (int p = 0; p < piles; ++p) engine.wake(all[static_cast<std::size_t>(5 * p)]);
        engine.step(frame);
        CHECK(engine.work().awake == 5 * piles + 1);
        return static_cast<Real>(engine.work().walked);
    };
    // of each pile one body that was reported, four pairs of two boxes and five touches; what there is besides is one
    // touch of a disc
    CHECK(walked(20) == 20 * 10 + 1);
    CHECK(walked(160) == 160 * 10 + 1);
}

TEST_CASE("what sleeps goes on touching until it is taken out and then ends once", "[house]")
{
    World engine = piles_beside_discs(3, 1);
    World again = World::load(engine.save());
    for (World* const each : {&engine, &again}) {
        const BodyId low = each->bodies()[5];  // of the second pile
        each->step(frame);
        CHECK(each->events().ended.empty());
        CHECK(each->events().began.empty());
        const Vec2 place = each->position(low);
        each->remove(low);
        each->add_body(body_of(box(0.5, 0.5), place));  // its number is used again
        each->step(frame);
        CHECK(each->events().ended.size() == 2);  // with the floor, and with the next one
        CHECK(each->events().began.size() == 2);
        each->step(frame);
        CHECK(each->events().ended.empty());
    }
    CHECK(engine.hash() == again.hash());
}

TEST_CASE("a step that looks at few bodies finds what one that looks at all would", "[house]")
{
    // a world that was just loaded knows nothing of the step before: whatever is copied, it copies whole
    World engine;
    engine.add_wall({{0, 1}, 0});
    const BodyId belt = engine.add_body(body_of(box(6, 0.4), {0, 1}, 0, 0)),
                 ledge = engine.add_body(body_of(box(2, 0.4), {6, 1}, 0, 0));
    for (int i = 0; i < 4; ++i) engine.add_body(body_of(box(0.5, 0.5), {0.1 * (i % 2), 1.5 + 0.52 * i}));
    engine.add_body(body_of(box(0.5, 0.5), {6, 1.45}));
    engine.set_surface(belt, {0.6, 0.5, 0, 0});  // a bounce is measured by u*
    for (int i = 0; i < 150; ++i) {
        if (i == 2) engine.set_velocity(belt, {1, -9}, 0);  // away from what falls on it
        if (i == 20) engine.set_velocity(belt, {1, 0}, 0);
        if (i == 4 || i == 40 || i == 100) engine.set_velocity(belt, {0, 0}, 0);
        if (i == 90) engine.set_velocity(belt, {-0.5, 0.2}, 0.1);
        if (i % 30 == 25) engine.move(ledge, engine.position(ledge) + Vec2(0.05, 0.01), 0.02);
        World other = World::load(engine.save());
        engine.step(frame);
        other.step(frame);
        REQUIRE(other.hash() == engine.hash());
    }
}

TEST_CASE("a pyramid costs the same at any size where its gravity has that size too", "[idea]")
{
    const auto price = [](Real size) {
        World engine = sized_pyramid_world(10, size);
        WorldSettings settings = engine.settings();
        settings.gravity *= size;
        engine.change(settings);
        Random random(1);
        for (const BodyId body : engine.bodies())
            if (engine.mass(body) < infinity)
                engine.move(body, engine.position(body) + Vec2(1e-4 * size * random.uniform(-1, 1), 0),
                            engine.angle(body));
        std::int64_t sum = 0;
        for (int i = 0; i < 60; ++i) {
            engine.step(frame);
            sum += engine.work().price();
        }
        CHECK(engine.work().awake == 0);
        return static_cast<Real>(sum);
    };
    const Real one = price(1);
    for (const Real size : {1.0 / 1024, 128.0}) CHECK(price(size) == one);  // each number has the same digits
    // others round otherwise: a guess more or less
    for (const Real size : {1e-3, 100.0}) CHECK(price(size) == Approx(one).epsilon(0.1));
}

TEST_CASE("a world of other units moves as the first one does", "[idea]")
{
    // lengths by 1000, masses by 8: 1000 is no power of two, so rounding differs, and a heap makes it grow
    const auto made = [](Real length) {
        WorldSettings settings;
        settings.length = length;
        settings.gravity *= length;
        World engine(settings);
        engine.add_wall({{0, 1}, 0});
        for (int i = 0; i < 6; ++i) {
            BodyDefinition body = body_of(i % 2 ? disc(0.3 * length) : box(0.6 * length, 0.5 * length),
                                          {0.2 * i * length, (0.4 + 0.8 * i) * length}, 0.1 * i, 8);
            body.surface.restitution = 0.2;
            engine.add_body(body);
        }
        return engine;
    };
    World one = made(1), other = made(1000);
    for (int i = 0; i < 90; ++i) {
        one.step(frame);
        other.step(frame);
    }
    const std::vector<BodyId> a = one.bodies(), b = other.bodies();
    for (std::size_t k = 0; k < a.size(); ++k)
        CHECK((other.position(b[k]) / 1000 - one.position(a[k])).norm() < 1e-6);
}

TEST_CASE("settings at their ends make worlds that step or sentences", "[house]")
{
    const auto with = [](const std::function<void(WorldSettings&)>& change) {
        WorldSettings settings;
        change(settings);
        World engine(settings);
        engine.add_wall({{0, 1}, 0});
        for (int i = 0; i < 4; ++i) engine.add_body(body_of(box(1, 1), {0.1 * i, 0.5 + i}));
        for (int i = 0; i < 120; ++i) engine.step(frame);
        for (const BodyId body : engine.bodies()) CHECK(engine.position(body).allFinite());
        return engine.position(engine.bodies()[3]).y();
    };
    CHECK(with([](auto& s) { s.substeps = 50; }) == Approx(3.5).margin(0.03));
    CHECK(with([](auto& s) { s.margin = 0; }) > 3);
    CHECK(with([](auto& s) { s.margin = 2; }) == Approx(3.5).margin(0.03));
    CHECK(with([](auto& s) { s.slop = 0; }) == Approx(3.5).margin(1e-3));
    CHECK(with([](auto& s) { s.sweeps = 1; }) > 3);
    CHECK(with([](auto& s) { s.most_exact = 0; }) == Approx(3.5).margin(0.03));
    CHECK(with([](auto& s) { s.tolerance = 1e-12; }) == Approx(3.5).margin(0.03));
    CHECK(with([](auto& s) { s.tolerance = 10; }) > 3);
    CHECK(with([](auto& s) { s.gravity = {0, 0}; }) == Approx(3.5).margin(1e-12));
    CHECK(with([](auto& s) { s.hit_speed = 0; }) == Approx(3.5).margin(0.03));

    CHECK_THROWS_WITH(with([](auto& s) { s.substeps = 0; }), Contains("sub-steps of the world is 0"));
    CHECK_THROWS_WITH(with([](auto& s) { s.length = -1; }), Contains("length of the world is -1 m"));
    CHECK_THROWS_WITH(with([](auto& s) { s.tolerance = 0; }), Contains("tolerance of the world is 0"));
    CHECK_THROWS_WITH(with([](auto& s) { s.gravity.x() = infinity; }), Contains("gravity"));
}

TEST_CASE("bad input gets a sentence and changes nothing", "[house]")
{
    World engine = piles_world(1);
    for (int i = 0; i < 50; ++i) engine.step(frame);
    const std::string before = engine.save();
    const BodyId body = engine.bodies()[0];
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    CHECK_THROWS_WITH(engine.step(0), Contains("time step h is 0"));
    BodyDefinition two_coefficients;
    two_coefficients.surface.kinetic = 0.4;
    CHECK_THROWS_WITH(engine.add_body(two_coefficients),
                      Contains("kinetic friction coefficient 0.4 beside the static one, 0.6"));
    CHECK_THROWS_WITH(engine.step(nan), Contains("time step h is nan"));
    CHECK_THROWS_WITH(engine.add_body(body_of(box(1, 1), {nan, 0})), Contains("nan"));
    CHECK_THROWS_WITH(engine.add_body(body_of({{}, 1}, {0, 0})), Contains("no vertex"));
    CHECK_THROWS_WITH(engine.add_body(body_of(box(1, 1), {0, 0}, 0, -1)),
                      Contains("density of the body is -1"));
    CHECK_THROWS_WITH(engine.add_body(body_of({{{0, 0}, {1, 0}}, 0}, {0, 0})), Contains("area"));
    BodyDefinition sensor = body_of(box(1, 1), {0, 0});
    sensor.sensor = true;
    CHECK_THROWS_WITH(engine.add_body(sensor), Contains("sensor"));
    CHECK_THROWS_WITH(engine.position({}), Contains("no body"));
    CHECK_THROWS_WITH(engine.position({99, 1}), Contains("not of this world"));
    CHECK_THROWS_WITH(engine.move(body, {nan, 0}, 0), Contains("finite"));
    CHECK_THROWS_WITH(engine.move(body, {0, 1e76}, 0), Contains("1e+76") && Contains("beyond 1e75"));
    CHECK_THROWS_WITH(engine.move(body, {0, 0}, -1e76), Contains("beyond 1e75"));
    CHECK_THROWS_WITH(engine.add_body(body_of(box(1, 1), {-1e76, 0})), Contains("beyond 1e75"));
    CHECK_THROWS_WITH(engine.add_body(body_of(box(1e76, 1), {0, 0})), Contains("vertex 0"));
    CHECK_THROWS_WITH(engine.add_chain(std::vector<Vec2>{{1e76, 0}, {1e76, 5}}),
                      Contains("the chain has a point"));
    CHECK_THROWS_WITH(engine.set_velocity(body, {0, infinity}, 0), Contains("finite"));
    CHECK_THROWS_WITH(engine.push(body, {nan, 0}, {0, 0}), Contains("impulse"));
    CHECK_THROWS_WITH(engine.add_wall({{0, 2}, 0}), Contains("normal"));
    CHECK_THROWS_WITH(engine.add_joint(body, body, {}), Contains("itself"));
    RigidJoint wide;
    wide.at_a = {0, 1e76};
    CHECK_THROWS_WITH(engine.add_joint({}, body, wide), Contains("1e+76; none may be beyond 1e75"));
    CHECK_THROWS_WITH(engine.add_wall({{0, 1}, -1e76}), Contains("-1e+76 m"));
    CHECK_THROWS_WITH(engine.pull(body, {1e76, 0}), Contains("beyond 1e75"));
    CHECK_THROWS_WITH(engine.add_chain(std::vector<Vec2>{{0, 0}}), Contains("two or more"));
    CHECK_THROWS_WITH(engine.ray({nan, 0}, {1, 0}), Contains("ray"));
    CHECK_THROWS_WITH(World::load("rubbish"), Contains("save()"));
    std::string changed = before;
    changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 1);
    CHECK_THROWS_WITH(World::load(changed), Contains("changed"));
    CHECK_THROWS_WITH(World::load(before.substr(0, before.size() - 9)), Contains("changed"));
    CHECK(engine.save() == before);
}

TEST_CASE("a thousand filters are as many as one and the one that a place had before is gone", "[idea]")
{
    World engine;
    std::vector<BodyId> all;
    for (int i = 0; i < 1000; ++i) {  // pairs that fall through each other, and do not
        BodyDefinition body = body_of(disc(0.2), {0.5 * (i / 2), i % 2 ? 0.6 : 0.0}, 0, i % 2 ? 1 : 0);
        body.filter = {std::uint64_t{1} << (i / 2 % 64), ~std::uint64_t{0},
                       i / 4 % 2 ? -1 - i / 2 : 1 + i / 2};
        all.push_back(engine.add_body(body));
    }
    engine.remove(all[2]);  // another one in its place, that meets everything
    engine.add_body(body_of(disc(0.2), {0.5, 0}, 0, 0));
    for (int i = 0; i < 40; ++i) engine.step(frame);
    for (std::size_t i = 1; i < 1000; i += 2) {
        INFO(i);
        CHECK((engine.position(all[i]).y() < -0.1) == (i / 4 % 2 == 1));
    }
}

TEST_CASE("what is poured lies beside what is poured and not in it", "[idea]")
{
    World engine = poured_world(60);
    Real deep = 0;
    std::vector<ContactView> contacts;
    for (int i = 0; i < 150; ++i) {
        engine.step(frame);
        engine.contacts(contacts);
        for (const ContactView& contact : contacts) deep = std::max(deep, -contact.gap);
    }
    // 0.03 m with boxes of an inner radius of 0.2 m that fall from up to 6 m; 0.1 m if nobody looks ahead
    CHECK(deep < 0.06);
}

TEST_CASE("rods of one millimetre are not left to overlap by the slop of a box", "[idea]")
{
    World engine;
    engine.add_wall({{0, 1}, 0});
    for (int i = 0; i < 4; ++i)  // 0.4 mm deep in each other
        engine.add_body(body_of(box(1, 0.001), {0.1 * i, 0.0001 + 0.0006 * i}));
    for (int i = 0; i < 60; ++i) engine.step(frame);
    // a two-hundredth of the inner radius, 2.5 µm, each; with the slop of ℓ they stay as they are
    const std::vector<BodyId> rods = engine.bodies();
    for (int i = 0; i < 4; ++i)
        CHECK(engine.position(rods[static_cast<std::size_t>(i)]).y() >
              0.0005 + 0.001 * i - 0.0000025 * (i + 1));
}

TEST_CASE("no pile falls asleep while its bodies are deeper in each other than the slop", "[idea]")
{
    struct Pile {
        Polygon shape;
        int count;
        Real thick;
    };
    for (const Pile& pile :
         {Pile{box(1, 1), 5, 1}, Pile{box(0.5, 0.2), 10, 0.2}, Pile{box(1, 0.003), 14, 0.003}}) {
        World engine;
        engine.add_wall({{0, 1}, 0});
        for (int i = 0; i < pile.count; ++i)  // a tenth of them in each other
            engine.add_body(body_of(pile.shape, {0, pile.thick * (0.4 + 0.9 * i)}));
        int steps = 0;
        do engine.step(frame);
        while (engine.work().awake > 0 && ++steps < 240);
        CHECK(steps < 240);
        Real below = 0;
        for (const BodyId body : engine.bodies()) {
            const Real foot = engine.position(body).y() - pile.thick / 2;
            INFO(pile.count << " of " << pile.thick << " m, gap " << foot - below);
            CHECK(foot - below > -std::min(0.005, pile.thick / 400));  // no margin: it is the slop itself
            below = foot + pile.thick;
        }
    }
}

TEST_CASE("dolls that fall down stairs overstep no limit of their joints", "[idea]")
{
    for (const int dolls : {1, 2}) {
        World engine = dolls_world(dolls);
        Real worst = 0;
        for (int i = 0; i < 180; ++i) {
            engine.step(frame);
            REQUIRE(engine.work().unsolved == 0);
            for (const JointId joint : engine.joints()) worst = std::max(worst, engine.error(joint));
        }
        // 1e-4 rad; one doll 0.13 if a row waits until the joint itself is fast, for a blow makes it fast within the step
        CHECK(worst < 0.005);
    }
}

TEST_CASE("a body whose numbers overflow is held where it was and the step says so", "[idea]")
{
    World engine;
    engine.add_wall({{0, 1}, 0});
    BodyDefinition wild = body_of(disc(0.2), {0, 50});
    wild.velocity = {1e306, 0};
    const BodyId lost = engine.add_body(wild), other = engine.add_body(body_of(disc(0.2), {5, 50}));
    engine.step(frame);
    CHECK(engine.position(lost) == Vec2(0, 50));
    CHECK(engine.velocity(lost) == Vec2(0, 0));
    CHECK(engine.work().held == 1);
    CHECK(engine.work().unsolved == 1);
    CHECK(engine.work().residual == infinity);
    CHECK(engine.events().held == std::vector<BodyId>{lost});
    CHECK(engine.velocity(other).y() == Approx(-9.81 * frame));
    // from rest it falls as any other
    engine.step(frame);
    CHECK(engine.work().held == 0);
    CHECK(engine.work().unsolved == 0);
    CHECK(engine.events().held.empty());
    CHECK(engine.velocity(lost).y() == Approx(-9.81 * frame));
}

TEST_CASE("what hangs on a body whose numbers overflow is held with it and goes on", "[idea]")
{
    for (const int substeps : {1, 3}) {
        INFO(substeps << " sub-steps");
        WorldSettings settings;
        settings.substeps = substeps;
        World engine(settings);
        std::vector<BodyId> ids;
        std::vector<Vec2> places;
        for (int i = 0; i < 4; ++i) {  // a chain of three, and one for itself
            places.push_back({i < 3 ? 0.5 * i : 20.0, 50});
            BodyDefinition body = body_of(disc(0.2), places.back());
            if (i == 1) body.velocity = {0, 1e306};
            ids.push_back(engine.add_body(body));
            if (i == 1 || i == 2)
                engine.add_joint(ids[static_cast<std::size_t>(i) - 1], ids.back(),
                                 engine.joint_at(JointKind::revolute, ids[static_cast<std::size_t>(i) - 1],
                                                 ids.back(), {0.5 * i - 0.25, 50}));
        }
        engine.step(frame);
        CHECK(engine.work().held == 3);
        CHECK(engine.work().unsolved == 1);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK((engine.position(ids[i]) - places[i]).norm() <=
                  9.81 * frame * frame);  // at most a fall of one step
            CHECK(std::abs(engine.velocity(ids[i]).y()) <= 9.81 * frame);
        }
        CHECK(engine.velocity(ids[3]).y() == Approx(-9.81 * frame));
        for (int k = 0; k < 30; ++k) {
            engine.step(frame);
            CHECK(engine.work().held == 0);
            CHECK(engine.work().unsolved == 0);
        }
        for (const JointId joint : engine.joints()) {
            CHECK(engine.error(joint) <= 1e-8);  // Newton stops at 1e-9 ℓ
            CHECK(engine.force(joint).allFinite());
        }
        // all three fall as one, and as what was never near them, but for the sub-step that they were held
        CHECK(engine.velocity(ids[0]).y() == Approx(engine.velocity(ids[2]).y()));
        CHECK(engine.velocity(ids[1]).y() == Approx(engine.velocity(ids[3]).y() + 9.81 * frame / substeps));
    }
}

TEST_CASE("joints between masses whose ratio no number holds leave no impulse that is no number", "[house]")
{
    World engine;
    std::vector<BodyId> ids;
    const Real masses[] = {1e120, 1e-119, 1e-67};
    for (int i = 0; i < 3; ++i) {
        BodyDefinition body = body_of(disc(0.2), {0.5 * i, 50});
        body.mass = Mass{masses[i], {0, 0}, 0.02 * masses[i]};
        body.velocity = {0.0, 1.0 * i};
        ids.push_back(engine.add_body(body));
    }
    engine.add_joint(ids[0], ids[1], engine.joint_at(JointKind::revolute, ids[0], ids[1], {0.3, 50.1}));
    engine.add_joint(ids[1], ids[2], engine.joint_at(JointKind::weld, ids[1], ids[2], {0.8, 49.9}));
    engine.add_body(body_of(disc(0.2), {20, 50}));  // an island after it, whose residual is 0
    for (int k = 0; k < 3; ++k) {
        engine.step(frame);
        CHECK(engine.work().unsolved > 0);
        CHECK_FALSE(engine.work().residual <= 1e-4);  // the tolerance; also where it is no number
        for (const JointId joint : engine.joints()) {
            CHECK(engine.force(joint).allFinite());
            CHECK(std::isfinite(engine.torque(joint)));
        }
    }
}

TEST_CASE("a hand that pulls farther than numbers go holds its body and no step refuses what it left",
          "[house]")
{
    World engine;
    const BodyId ball = engine.add_body(body_of(disc(0.2), {0, 5}));
    engine.pull(ball, {0, 1e75});
    engine.step(frame);
    CHECK(engine.work().held == 1);
    CHECK(engine.position(ball).y() == 5);
    engine.pull({}, {0, 0});
    World again = World::load(engine.save());
    for (World* const each : {&engine, &again}) {
        CHECK_NOTHROW(each->step(frame));
        CHECK(each->velocity(ball).y() == Approx(-9.81 * frame));
    }
}

TEST_CASE("a step so short that every velocity is noise loses nothing", "[house]")
{
    // what rounding makes of a position in 1e-300 s is more than any number (x/h), so no residual is small
    World engine;
    std::vector<BodyId> ids;
    for (int i = 0; i < 2; ++i) ids.push_back(engine.add_body(body_of(disc(0.2), {1e9 + 0.5 * i, 50})));
    RigidJoint joint = engine.joint_at(JointKind::revolute, ids[0], ids[1], {1e9 + 0.25, 50});
    joint.lower = -0.1, joint.upper = 0.1;
    engine.add_joint(ids[0], ids[1], joint);
    engine.set_velocity(ids[0], {0, 1}, 30);  // the limit has a row
    engine.step(frame);
    CHECK_NOTHROW(engine.step(1e-300));
    for (const BodyId id : ids) {
        CHECK(engine.position(id).allFinite());
        CHECK(engine.velocity(id).allFinite());
    }
    CHECK_NOTHROW(engine.step(frame));
}

TEST_CASE("a step whose part is no time and a body without a centroid are refused", "[house]")
{
    WorldSettings settings;
    settings.substeps = 3;
    World engine(settings);
    BodyDefinition ton;
    ton.mass = Mass{1000, {0, 0}, 1000};
    engine.add_body(ton);
    const std::uint64_t before = engine.hash();
    CHECK_THROWS_WITH(engine.step(std::numeric_limits<Real>::denorm_min()),
                      Contains("the time step h is 0 s"));
    CHECK(engine.hash() == before);
    BodyDefinition vast = body_of(box(1e200, 1e200), {0, 0});
    vast.density = 0;
    CHECK_THROWS_WITH(engine.add_body(vast), Contains("vertex 0"));
    vast.shape = box(1, 1);
    vast.mass = Mass{0, {std::nan(""), 0}, 0};
    CHECK_THROWS_WITH(engine.add_body(vast), Contains("the centroid of the body is (nan, 0)"));
    CHECK(engine.hash() == before);
    // two vertices that are one about the centroid: what was saved could not be loaded
    BodyDefinition far = body_of(box(1, 1), {0, 0});
    for (Vec2& vertex : far.shape.vertices) vertex.x() += 1e15;
    far.mass = Mass{1, {-1e16, 0}, 1};
    CHECK_THROWS_WITH(engine.add_body(far), Contains("are the same point"));
    CHECK(engine.hash() == before);
    // a weight that overflows would be refused by each step from then on, and by load()
    BodyDefinition heavy = body_of(disc(0.5), {0, 0});
    heavy.mass = Mass{1e308, {0, 0}, 1e308};
    CHECK_THROWS_WITH(engine.add_body(heavy), Contains("has no finite weight"));
    WorldSettings strong = engine.settings();
    strong.gravity = {0, -1e308};
    CHECK_THROWS_WITH(engine.change(strong), Contains("has no finite weight"));
    WorldSettings vast_too;
    vast_too.length = 1e200, vast_too.tolerance = 1e150;
    CHECK_THROWS_WITH(engine.change(vast_too), Contains("1e+150 times it is not finite"));
    CHECK(engine.hash() == before);
}

TEST_CASE("worlds of extreme numbers never show one that is not finite", "[house]")
{
    Random random(5);
    int held = 0;
    for (int world_number = 0; world_number < 60; ++world_number) {
        INFO("world " << world_number);
        WorldSettings settings;
        settings.solving = static_cast<Solving>(world_number % 3);
        settings.substeps = 1 + world_number % 2;
        World engine(settings);
        engine.add_wall({{0, 1}, 0});
        const auto power = [&](Real low, Real high) { return std::pow(10, random.uniform(low, high)); };
        const Real wild = random.uniform(0, 150);  // powers of ten
        for (int i = 0; i < 12; ++i) {
            const Real x = random.uniform(-2, 2), y = random.uniform(0, 3), angle = random.uniform(-7, 7);
            const Index what = random.index(3);
            const Real size = power(-1.5, 0.5);
            BodyDefinition body = body_of(what == 0   ? disc(size)
                                          : what == 1 ? capsule(size, 0.3 * size)
                                                      : box(size, 0.2 * size),
                                          {x, y}, angle);
            body.density = power(-wild, wild);
            const Real speed = power(-2, random.index(4) == 0 ? 2 * wild : 3);
            body.velocity = {speed * std::cos(angle), speed * std::sin(angle)};
            const Real turning = power(0, random.index(4) == 0 ? 2 * wild : 2);
            body.spin = i % 2 ? turning : -turning;
            engine.add_body(body);
        }
        const std::vector<BodyId> all = engine.bodies();
        for (int i = 0; i < 10; ++i) {
            const BodyId a = all[static_cast<std::size_t>(random.index(12))],
                         b = all[static_cast<std::size_t>(random.index(12))];
            const auto kind = static_cast<JointKind>(random.index(7));
            const Real x = random.uniform(-2, 2), y = random.uniform(0, 3), strength = power(-wild, 2 * wild);
            if (a == b) continue;
            RigidJoint joint = engine.joint_at(kind, a, b, {x, y});
            joint.length = 1;
            if (kind == JointKind::revolute || kind == JointKind::prismatic) {
                joint.lower = -1, joint.upper = 0.5;
                joint.motor.force = joint.motor.speed = strength;
            }
            if (kind == JointKind::wheel) joint.spring.stiffness = strength;
            engine.add_joint(a, b, joint);
        }
        std::vector<ContactView> contacts;
        for (int k = 0; k < 60; ++k) {
            REQUIRE_NOTHROW(engine.step(frame));
            held += engine.work().held;
            if (engine.work().held > 0) CHECK(engine.work().unsolved > 0);
            CHECK(engine.work().held == static_cast<int>(engine.events().held.size()));
            for (const BodyId body : all) {
                REQUIRE(engine.position(body).allFinite());
                REQUIRE(engine.velocity(body).allFinite());
                REQUIRE(std::isfinite(engine.angle(body)));
                REQUIRE(std::isfinite(engine.spin(body)));
            }
            engine.contacts(contacts);
            for (const ContactView& contact : contacts) REQUIRE(std::isfinite(contact.impulse));
        }
        World again = World::load(engine.save());
        for (int k = 0; k < 10; ++k) {
            engine.step(frame);
            again.step(frame);
        }
        CHECK(again.hash() == engine.hash());
    }
    CHECK(held > 0);
}

TEST_CASE("hostile worlds stay finite or are refused", "[house]")
{
    Random random(11);
    for (int world_number = 0; world_number < 40; ++world_number) {
        INFO("world " << world_number);
        WorldSettings settings;
        settings.substeps = 1 + static_cast<int>(random.index(3));
        World engine(settings);
        engine.add_wall({{0, 1}, 0});
        std::vector<JointId> joints;
        for (int i = 0; i < 60; ++i) {
            const std::vector<BodyId> all = engine.bodies();
            const auto some = [&] {
                return all[static_cast<std::size_t>(random.index(static_cast<Index>(all.size())))];
            };
            const Index what = random.index(8);
            const Real x = random.uniform(-3, 3), y = random.uniform(-1, 4), angle = random.uniform(-7, 7);
            const Real size = std::pow(10, random.uniform(-2.5, 1)),
                       density = std::pow(10, random.uniform(-5, 6));
            if (what <= 2 || all.size() < 2) {
                BodyDefinition body = body_of(what == 0   ? disc(size)
                                              : what == 1 ? capsule(size, 0.3 * size)
                                                          : box(size, 0.2 * size),
                                              {x, y}, angle, random.index(6) == 0 ? 0 : density);
                const Real speed = std::pow(10, random.uniform(-2, 3));
                body.velocity = {speed * std::cos(angle), speed * std::sin(angle)};
                body.spin = random.uniform(-100, 100);
                body.surface.friction = random.uniform(0, 2);
                body.surface.restitution = random.uniform();
                engine.add_body(body);
            } else if (what == 3) engine.remove(some());
            else if (what == 4) {
                const BodyId a = some(), b = some();
                const auto kind = static_cast<JointKind>(random.index(5));
                try {
                    RigidJoint joint = engine.joint_at(kind, a, b, {x, y});
                    joint.length = std::abs(y);
                    joints.push_back(engine.add_joint(a, b, joint));
                } catch (const std::invalid_argument&) {
                }
            } else if (what == 5) engine.move(some(), {x, y}, angle);
            else if (what == 6) engine.push(some(), {100 * x, 100 * y}, {x, y});
            else if (!joints.empty() && engine.has(joints.back())) engine.remove(joints.back());
            for (int k = 0; k < 4; ++k) engine.step(frame);
        }
        World again = World::load(engine.save());
        for (int k = 0; k < 30; ++k) {
            engine.step(frame);
            again.step(frame);
        }
        CHECK(again.hash() == engine.hash());
        for (const BodyId body : engine.bodies()) {
            CHECK(engine.position(body).allFinite());
            CHECK(engine.velocity(body).allFinite());
        }
    }
}
