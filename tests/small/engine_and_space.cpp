/// The small programs of chapters 18 to 25, islands, a world of boxes and bodies in space, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/06_sequential_impulse/sequential_impulse.hpp"
#include "chapters/18_islands/island_shape.hpp"
#include "chapters/19_engine/world_scenes.hpp"
#include "chapters/20_turning_in_space/tumbling.hpp"
#include "chapters/24_friction_is_a_disc/friction_cone.hpp"
#include "tests/catch.hpp"

#define main small_main
namespace small18 {
#include "chapters/18_islands/small.cpp"
}
namespace small19 {
#include "chapters/19_engine/small.cpp"
}
namespace small25 {
#include "chapters/25_world_in_space/small.cpp"
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

TEST_CASE("the small program of chapter 25 has the numbers of the text and the library's to 1e-12")
{
    // Section 20.1.
    small25::Bodies d = small25::book(12, 0.1);
    const Vec3 I = d.inverse_mass.tail<3>().cwiseInverse();
    CHECK((I - Vec3(34.5, 15.9, 48.5) * 1e-4).cwiseAbs().maxCoeff() < 0.05e-4);
    for (const auto& [wobble, turns] : {std::pair{0.1, 0.74}, {0.01, 1.38}}) {
        small25::Bodies slow = small25::book(1, wobble);
        int n = 0;
        for (; slow.u[3] > 0 && n < 20000; ++n) small25::step(slow, 0.001, 0, 0);
        CHECK(n * 0.001 / (2 * pi) == Approx(turns).margin(0.005));
    }
    Vec3 theta(0, 0, 0), omega = d.u.tail<3>();
    for (int n = 0; n < 100; ++n) {
        small25::step(d, 0.005, 0, 0);
        tumble(Tumbling::middle, I, 0.005, theta, omega);
        REQUIRE((d.u.tail<3>() - omega).norm() < 1e-11);  // 12 rad/s, to 1e-12 of it
        REQUIRE((d.x.tail<3>() - theta).norm() < 1e-12);
    }
}

TEST_CASE(
    "the small program of chapter 25 visits a point as the library does and stops alike in all directions")
{
    small25::Bodies d{{}, {}, {}, {}, VecX{{0, 0, 1, 0}}};
    small25::add_box(d, {1, 0.8, 0.2}, 1, {0, 0, 0.1});
    d.u << 2, 1, -0.3, 0.1, 0.2, 0.5;
    std::vector<small25::Contact> contacts = small25::find_contacts(d);
    REQUIRE(contacts.size() == 4);
    VecX u = d.u;
    std::vector<Row<6>> rows;
    for (const small25::Contact& c : contacts)
        for (const int i : {0, 1, 2}) {
            Constraint<6> constraint;
            constraint.a = world, constraint.b = 0;
            constraint.Jb = c.J.row(i);
            rows.push_back(bilateral(constraint, d.inverse_mass, 0));
            if (i == 2) rows.back().lo = 0;
        }
    std::vector<SolverRow<6>> visited;
    prepare<6>(rows, {}, VecX::Zero(Index(rows.size())), visited);
    for (int n = 0; n < 100; ++n)
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            visit_disc(disc_of_rows(visited, 3 * k), &visited[3 * k], d.mu * visited[3 * k + 2].lambda, u);
            visit(visited[3 * k + 2], u);
            small25::visit(contacts[k], d);
            REQUIRE((d.u - u).cwiseAbs().maxCoeff() < 1e-12);
        }
    CHECK(contacts[0].lambda.head<2>().norm() > 0);

    for (const Real angle : {0.0, pi / 6, pi / 4}) {
        small25::Bodies block{{}, {}, {}, {}, VecX{{0, 0, 1, 0}}};
        small25::add_box(block, {1, 1, 0.2}, 1, {0, 0, 0.1});
        block.u.head<2>() << 2 * std::cos(angle), 2 * std::sin(angle);
        for (int n = 0; n < 480; ++n) small25::step(block, 1.0 / 240, 0.2, 20);
        // v²/(2 μ g), less half a step's way: symplectic Euler brakes first
        CHECK(block.x.head<2>().norm() == Approx(2 / 9.81 * 2 - 2.0 / 480).margin(2e-4));
        CHECK(std::atan2(block.x[1], block.x[0]) == Approx(angle).margin(2e-3));
        CHECK(block.u.norm() < 1e-3);
    }
}
