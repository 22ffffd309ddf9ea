/// The small programs of chapters 18 and 19, islands and a world of boxes, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/18_islands/island_shape.hpp"
#include "chapters/19_engine/world_scenes.hpp"
#include "tests/catch.hpp"
#include "tests/small/sentences.hpp"

#define main small_main
namespace small18 {
#include "chapters/18_islands/small.cpp"
}
namespace small19 {
#include "chapters/19_engine/small.cpp"
}
#undef main

using namespace rigid;

namespace {

/// Section 18.1: one box, 100 kg on two, a tower of twenty.
small18::Bodies three()
{
    small18::Bodies d;
    small18::add_box(d, 50, 0.5, INFINITY, {0, -0.5, 0});
    small18::add_box(d, 0.5, 0.5, 1, {-14, 0.5, 0});
    for (int k = 0; k < 3; ++k) small18::add_box(d, 0.5, 0.5, k < 2 ? 1 : 100, {-10, 0.5 + k, 0});
    for (int k = 0; k < 20; ++k) small18::add_box(d, 0.5, 0.5, 1, {0, 0.5 + k, 0});
    return d;
}

Real h = 1.0 / 120;

/// (11.6): the row of a point of body b along an axis.
RowVec<3> along(const Vec2& axis, const Vec2& point, const small18::Bodies& d, int b)
{
    const Vec2 r = point - d.x.segment<2>(3 * b);
    return {axis.x(), axis.y(), r.x() * axis.y() - r.y() * axis.x()};
}

/// The rows of an island for the library, of each point the friction, then the normal. Overlaps here are below the
/// 5 mm that may stay.
std::vector<Row<3>> library_rows(const small18::Island& island, const small18::Bodies& d)
{
    std::vector<Row<3>> rows;
    for (const small18::Contact& c : island.points)
        for (const int i : {0, 1}) {
            const Vec2 axis = i == 0 ? Vec2(-c.n.y(), c.n.x()) : c.n;
            Constraint<3> constraint;
            constraint.a = c.a, constraint.b = c.b;
            constraint.Ja = -along(axis, c.p, d, c.a), constraint.Jb = along(axis, c.p, d, c.b);
            Row<3> row = bilateral(constraint, d.inverse_mass, i == 0 ? 0 : std::max(0.0, c.C) / h);
            row.lo = 0, row.hi = i == 0 ? 0 : infinity;
            if (i == 0) row.bounded_by = int(rows.size()) + 1, row.friction = d.mu;
            rows.push_back(row);
        }
    return rows;
}

/// The islands, their velocities after the forces.
std::vector<small18::Island> begun(small18::Bodies& d)
{
    std::vector<small18::Island> islands = small18::islands(d);
    for (small18::Island& i : islands) {
        for (const int k : i.bodies) d.u[3 * k + 1] -= d.g * h;
    }
    return islands;
}

}  // namespace

TEST_CASE("the small program of chapter 18 counts what its islands need as the library does")
{
    small18::Bodies d = three();
    std::vector<small18::Island> islands = begun(d);
    REQUIRE(islands.size() == 3);
    IslandSurveyor survey;
    Bodies<3> bodies(d.x.size() / 3);
    bodies.x = d.x;
    bodies.inverse_mass = d.inverse_mass;
    for (const auto& [n, needed] : {std::pair{0, 1.0}, {1, 900.0}, {2, 400.0}}) {  // section 18.1
        const small18::Island& i = islands[std::size_t(n)];
        CHECK(i.needed() == Approx(needed).epsilon(1e-14));
        const std::vector<Row<3>> rows = library_rows(i, d);
        std::vector<int> members(rows.size());
        std::iota(members.begin(), members.end(), 0);
        CHECK(survey(bodies, rows, members, i.bodies).sweeps_needed() == Approx(needed).epsilon(1e-14));
    }
}

TEST_CASE("the small program of chapter 18 solves what stands exactly and sweeps as the library does")
{
    small18::Bodies d = three();
    for (const std::size_t n : {1u, 2u}) {
        small18::Bodies solved = d;
        small18::Island island = begun(solved)[n];
        const std::vector<Row<3>> rows = library_rows(island, solved);
        VecX swept = solved.u, u = solved.u;
        REQUIRE(small18::solve(island, solved, h, true, 1));  // a sweep changes nothing
        for (const int k : island.bodies) CHECK(solved.u.segment<3>(3 * k).norm() < 1e-10);  // it stands
        // Ten sweeps, of both.
        small18::Bodies small = d;
        small18::Island again = begun(small)[n];
        CHECK(!small18::solve(again, small, h, false, 10));
        ImpulseMemory<3> memory;
        Solution solution;
        sequential_impulse<3>(rows, {}, {.max_sweeps = 10, .tolerance = 0}, memory, swept, solution);
        CHECK((small.u - swept).cwiseAbs().maxCoeff() < 1e-12);
        CHECK((small.u - solved.u).cwiseAbs().maxCoeff() > 1e-3);  // what ten sweeps leave
    }
}

TEST_CASE("the small program of chapter 18 stands still and falls asleep and wakes what is struck")
{
    small18::Bodies d = three();
    const VecX start = d.x;
    for (int n = 0; n < 120; ++n) small18::step(d, h);
    CHECK(d.exact == 120);  // both high ones for the half second until they sleep
    CHECK(d.swept == 60);
    CHECK(d.slept == 180);
    CHECK((d.x - start).cwiseAbs().maxCoeff() < 1e-5);  // of the box that is swept
    CHECK((d.x - start).tail(60).cwiseAbs().maxCoeff() < 1e-11);
    small18::add_box(d, 0.5, 0.5, 3, {-10, 12, 0});
    d.u[75] = 15;
    const VecX before = d.x;
    bool struck = false;
    for (int n = 0; n < 1080; ++n) {
        small18::step(d, h);
        struck = struck || d.rest[24] < 0.5;
    }
    CHECK(struck);
    CHECK((d.x - before).segment(15, 60).cwiseAbs().maxCoeff() > 1);
    CHECK((d.x - before).segment(3, 3).norm() == 0);  // what nothing touches sleeps on, to the bit
    CHECK(*std::min_element(d.rest.begin() + 1, d.rest.end()) >= 0.5);
    for (const small18::Island& i : small18::islands(d))
        for (const small18::Contact& c : i.points) CHECK(c.C > -0.01);
}

TEST_CASE("the small program of chapter 19 names and wakes as a world of the library does")
{
    small19::World d;
    World engine;
    const auto add = [&](Real w, Real high, Real mass, const Vec2& at) {
        const small19::Id small = small19::add_box(d, {w, high}, mass, at);
        BodyDefinition body = body_of(box(2 * w, 2 * high), at, 0, mass < infinity ? mass : 0);
        body.surface.friction = 0;
        const BodyId id = engine.add_body(body);
        CHECK(id.place == std::uint32_t(small.place));
        CHECK(id.generation == std::uint32_t(small.generation));
        return std::pair{small, id};
    };
    // section 19.1: add, remove, add; then the first name is refused
    add(20, 0.5, infinity, {0, -0.5});
    const auto [small_old, old] = add(0.5, 0.5, 1, {-3, 0.5});
    small19::remove_box(d, small_old);
    engine.remove(old);
    const auto [small_now, now] = add(0.5, 0.5, 1, {-3, 0.5});
    CHECK(small_now.place == small_old.place);
    CHECK(small_old.generation == 1);
    CHECK(small_now.generation == 2);
    const small19::World before = d;
    CHECK_THROWS_WITH(small19::remove_box(d, small_old), "box 1 of generation 1 was removed");
    CHECK_THROWS_WITH(engine.remove(old), Catch::Contains("1 of generation 1 was removed"));
    CHECK(small19::hash(d) == small19::hash(before));

    std::vector<std::pair<small19::Id, BodyId>> tower;
    for (int k = 0; k < 5; ++k) tower.push_back(add(0.5, 0.5, 1, {0, 0.5 + k}));
    const auto asleep = [&](int place) { return d.rest[place] >= 0.5; };
    for (int n = 0; n < 120; ++n) small19::step(d, h), engine.step(h);
    for (const auto& [small, id] : tower) {
        CHECK(asleep(small.place));
        CHECK(!engine.is_awake(id));
    }
    small19::remove_box(d, tower[1].first);
    engine.remove(tower[1].second);
    for (int n = 0; n < 30; ++n) {
        small19::step(d, h), engine.step(h);
        for (const std::size_t k : {0u, 2u, 3u, 4u}) {
            CHECK(engine.is_awake(tower[k].second));
            // it falls, or stands: both by symplectic Euler
            const int place = tower[k].first.place;
            CHECK((d.x.segment<2>(2 * place) - engine.position(tower[k].second)).norm() < 1e-8);
        }
        CHECK(asleep(small_now.place));
        CHECK(!engine.is_awake(now));
    }
    CHECK(d.x[2 * tower[2].first.place + 1] < 2.3);  // 9.81 / 2 · 0.25² below where it was

    small19::World again = small19::load(small19::save(d));
    World loaded = World::load(engine.save());
    for (int n = 0; n < 240; ++n) {
        small19::step(d, h), small19::step(again, h);
        engine.step(h), loaded.step(h);
    }
    CHECK(small19::hash(again) == small19::hash(d));
    CHECK(loaded.hash() == engine.hash());
    d.x[0] += 1e-300;
    CHECK(small19::hash(again) != small19::hash(d));
    for (const int k : {0, 2, 3, 4}) CHECK(asleep(tower[std::size_t(k)].first.place));
}

namespace {

// What the sentences of these chapters say.

Numbers tower(Numbers in)
{
    const int boxes = static_cast<int>(in["boxes"]);
    const rigid::IslandShape shape{boxes, 4 * boxes, 4 * boxes, 0, boxes, boxes, in["ratio"]};
    return {{"sweeps", shape.price_of_sweeps()}, {"exact", shape.price_of_exact()}};
}

const Sentence says_tower("tower", tower, 1e-12);

}  // namespace
