/// Chapter 25: sweeps side by side, and the same bits.

#include "tests/no_allocation.hpp"

#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"
#include "chapters/25_world_in_space/built_scenes.hpp"
#include "chapters/25_world_in_space/car.hpp"
#include "chapters/25_world_in_space/doll_scenes.hpp"
#include "chapters/25_world_in_space/step_in_parts.hpp"

#include "tests/catch.hpp"
#include "tests/sentence.hpp"
#include "tests/solids.hpp"

using namespace rigid;

namespace {

/// Solids of all kinds that are poured, roll with resistance, and rest on a body that cannot move.
SpaceScene rolling_heap()
{
    SpaceScene scene = mixed_heap(24, 0.5, 3);
    scene.rolling.assign(scene.shapes.size(), 0.01);
    scene.spinning.assign(scene.shapes.size(), 0.02);
    add_stairs(scene, 3, 3, 0.5);
    scene.rolling.resize(scene.shapes.size(), 0.01);
    scene.spinning.resize(scene.shapes.size(), 0.02);
    return scene;
}

SpaceScene driven_car()
{
    SpaceScene scene = car_on_floor({}, 0.9);
    add_bumps(scene, 3, 0.1, 0.9);
    return scene;
}

/// Both ways through the same scene, as long as they are the same.
void compare(SpaceScene scene, TouchingCones one_by_one, int steps, int substeps)
{
    SpaceScene other = scene;
    TouchingCones side_by_side = one_by_one;
    one_by_one.solver.wide = false;
    StepData<6> now, then;
    const StepSettings settings{.h = sixtieth, .substeps = substeps};
    for (int i = 0; i < steps; ++i) {
        step(scene, settings, one_by_one, now);
        step(other, settings, side_by_side, then);
        INFO("step " << i);
        REQUIRE(same_bits(scene.bodies.x, other.bodies.x));
        REQUIRE(same_bits(scene.bodies.u, other.bodies.u));
        REQUIRE(same_bits(now.solution.lambda, then.solution.lambda));
        REQUIRE(now.solution.residual == then.solution.residual);
        REQUIRE(now.solution.iterations == then.solution.iterations);
        REQUIRE(now.solution.status == then.solution.status);
        REQUIRE(now.visits == then.visits);
    }
}

}  // namespace

TEST_CASE("five rows by hand have the levels of the text", "[idea][wide]")
{
    std::vector<int> highest(4, 0);
    // A and the wall, B and A, C and the wall, C and B, D and the wall: section 25.1
    CHECK(next_level(highest, 0, world) == 1);
    CHECK(next_level(highest, 1, 0) == 2);
    CHECK(next_level(highest, 2, world) == 1);
    CHECK(next_level(highest, 2, 1) == 3);
    CHECK(next_level(highest, world, 3) == 1);
    CHECK(highest == std::vector<int>{2, 3, 3, 1});
}

TEST_CASE("the level of a visit is the length of the longest chain of visits that it waits for",
          "[idea][wide]")
{
    Random random(25);
    for (int round = 0; round < 50; ++round) {
        const int bodies = 2 + round % 9;
        std::vector<int> highest(static_cast<std::size_t>(bodies), 0);
        std::vector<std::pair<Index, Index>> rows;
        std::vector<int> chain;  // of each row, by force: over all rows before it
        for (int i = 0; i < 40; ++i) {
            const auto any = [&] { return static_cast<Index>(random.uniform(0, 1) * bodies); };
            const Index a = any(), other = any(), b = i % 5 == 0 || other == a ? world : other;
            int longest = 0;
            for (std::size_t k = 0; k < rows.size(); ++k) {
                const auto& [c, d] = rows[k];
                const bool meet = a == c || a == d || (b != world && (b == c || b == d));
                if (meet) longest = std::max(longest, chain[k]);
            }
            rows.emplace_back(a, b), chain.push_back(longest + 1);
            CHECK(next_level(highest, i % 2 == 0 ? a : b, i % 2 == 0 ? b : a) == chain.back());
        }
    }
}

TEST_CASE("a wall that is swept level by level has the bits of one that is swept row by row", "[idea][wide]")
{
    // no more than the order: whether lanes do it is the book's own matter
    SpaceScene scene = brick_wall(3, 3, 0.6), other = scene;
    TouchingCones one_by_one, by_levels;
    one_by_one.solver.wide = false;
    StepData<6> now, then;
    for (int i = 0; i < 20; ++i) {
        step(scene, {.h = sixtieth}, one_by_one, now);
        step(other, {.h = sixtieth}, by_levels, then);
        REQUIRE(same_bits(scene.bodies.u, other.bodies.u));
    }
}

TEST_CASE("sweeps side by side give the bits of sweeps one by one", "[house][wide]")
{
    TouchingCones method;
    SECTION("a wall") { compare(brick_wall(5, 5, 0.6), method, 40, 1); }
    SECTION("a wall in sub-steps") { compare(brick_wall(4, 4, 0.6), method, 20, 4); }
    SECTION("dolls that fall down stairs") { compare(dolls_on_stairs(3, 2), method, 60, 1); }
    SECTION("a heap that rolls with resistance") { compare(rolling_heap(), method, 90, 2); }
    SECTION("a car on bumps") { compare(driven_car(), method, 90, 1); }
    SECTION("ten sweeps")
    {
        method.solver.sweeps.max_sweeps = 10;
        compare(mixed_heap(24, 0.5, 1), method, 90, 1);
    }
    SECTION("no sweep")
    {
        method.solver.sweeps.max_sweeps = 0;
        compare(mixed_heap(6, 0.5, 1), method, 10, 1);
    }
    SECTION("all sweeps")
    {
        method.solver.sweeps = {30, 0};
        compare(mixed_heap(12, 0.5, 1), method, 60, 1);
    }
    SECTION("small islands exactly")
    {
        method.solver.exact_rows = 30;
        compare(mixed_heap(24, 0.5, 1), method, 60, 1);
    }
    SECTION("a pyramid for each disc")
    {
        method.solver.corners = 8;
        compare(mixed_heap(12, 0.5, 1), method, 30, 1);
    }
}

TEST_CASE("runs of one level move no body in common and each body meets its rows in their order",
          "[house][wide]")
{
    SpaceScene scene = mixed_heap(30, 0.5, 2);
    TouchingCones method;
    StepData<6> now;
    int wide = 0;
    for (int i = 0; i < 90; ++i) {
        step(scene, {.h = sixtieth}, method, now);
        const auto& solver = method.solver;
        const VisitLevels& levels = solver.lanes.levels;
        std::vector<std::pair<int, int>> last(static_cast<std::size_t>(scene.bodies.count()), {0, -1});
        for (const int r : levels.order) {
            const LevelRun& run = levels.runs[static_cast<std::size_t>(r)];
            const SolverRow<6>& row = solver.rows[static_cast<std::size_t>(run.first)];
            for (const int place : row.a == row.b ? std::vector{row.b} : std::vector{row.a, row.b}) {
                if (!scene.bodies.can_move(place / 6)) continue;
                auto& [level, first] = last[static_cast<std::size_t>(place / 6)];
                REQUIRE(run.level > level);
                REQUIRE(run.first > first);
                level = run.level, first = run.first;
            }
        }
        for (const LevelRun& run : levels.runs) wide += run.lane > 0;
    }
    CHECK(wide > 1000);  // runs that share a packet
}

TEST_CASE("a disc in lanes is visited as a disc alone", "[house][wide]")
{
    using V = Lanes<Real, 2>;
    Random random(5);
    int held = 0, slid = 0;
    for (int n = 0; n < 2000; ++n) {
        VecX u(12);
        for (Real& number : u) number = random.uniform(-1, 1);
        VecX alone = u;
        LaneRow<V> wide[2] = {};
        LaneDisc<V> disc{};
        LaneBodies<V> inverse{}, at{};
        SolverRow<6> rows[2];
        const auto mass = [&] { return n % 7 == 0 ? 0 : random.uniform(0.1, 2); };
        Vec<6> a, b;
        for (int d = 0; d < 6; ++d) a[d] = mass(), b[d] = mass();
        for (int r = 0; r < 2; ++r) {
            SolverRow<6>& row = rows[r];
            // every fifth pair of rows is one direction twice
            for (int d = 0; d < 6; ++d)
                row.Ja[d] = r == 1 && n % 5 == 0 ? rows[0].Ja[d] : random.uniform(-1, 1),
                row.Jb[d] = r == 1 && n % 5 == 0 ? rows[0].Jb[d] : random.uniform(-1, 1);
            row.Wa = a.cwiseProduct(row.Ja.transpose()), row.Wb = b.cwiseProduct(row.Jb.transpose());
            row.bias = random.uniform(-1, 1), row.lambda = random.uniform(-1, 1);
            row.a = 0, row.b = 6, row.mass = 1, row.lo = -1, row.hi = 1;
            for (int d = 0; d < 6; ++d) wide[r].Ja[d][1] = row.Ja[d], wide[r].Jb[d][1] = row.Jb[d];
            wide[r].bias[1] = row.bias, wide[r].lambda[1] = row.lambda;
        }
        DiscOfRows one;
        one = disc_of_rows(std::vector<SolverRow<6>>{rows[0], rows[1]}, 0);
        disc.a[1] = one.A(0, 0), disc.b[1] = one.A(1, 1), disc.c[1] = one.A(0, 1);
        disc.det[1] = one.A(0, 0) * one.A(1, 1) - one.A(0, 1) * one.A(1, 0), disc.largest[1] = one.largest;
        for (int d = 0; d < 6; ++d) {
            inverse.a[d][1] = a[d], inverse.b[d][1] = b[d];
            at.a[d][1] = u[d], at.b[d][1] = u[6 + d];
        }
        V radius{};
        radius[1] = n % 3 == 0 ? 0 : random.uniform(0, 3);
        const Real off = visit_disc(one, rows, radius[1], alone);
        const V wide_off = visit_disc(wide, disc, radius, inverse, at);
        REQUIRE(wide_off[1] == off);
        for (int r = 0; r < 2; ++r) REQUIRE(wide[r].lambda[1] == rows[r].lambda);
        for (int d = 0; d < 6; ++d) {
            REQUIRE(at.a[d][1] == alone[d]);
            REQUIRE(at.b[d][1] == alone[6 + d]);
            REQUIRE((at.a[d][0] == 0 && at.b[d][0] == 0));  // the empty lane
        }
        const Real length = std::hypot(rows[0].lambda, rows[1].lambda);
        length < radius[1] * (1 - 1e-9) ? ++held : ++slid;
    }
    CHECK(held > 200);
    CHECK(slid > 200);
}

TEST_CASE("sweeps side by side take no memory once they have seen a scene", "[house][wide]")
{
    SpaceScene scene = brick_wall(4, 4, 0.6);
    TouchingCones method;
    StepData<6> now;
    for (int i = 0; i < 30; ++i) step(scene, {.h = sixtieth}, method, now);
    const NoAllocation guard;
    for (int i = 0; i < 20; ++i) step(scene, {.h = sixtieth}, method, now);
    CHECK(NoAllocation::violations() == 0);
}

TEST_CASE("a step in parts is so many steps and none is refused", "[house]")
{
    SpaceScene scene = mixed_heap(8, 0.5, 1), other = scene;
    TouchingCones method, same;
    StepData<6> now, then;
    for (int i = 0; i < 30; ++i) {
        step_in_parts(scene, {.h = sixtieth}, 3, method, now);
        std::int64_t visits = 0;
        for (int part = 0; part < 3; ++part) {
            step(other, {.h = sixtieth / 3}, same, then);
            visits += then.visits;
        }
        REQUIRE(same_bits(scene.bodies.x, other.bodies.x));
        REQUIRE(now.visits == visits);
    }
    const VecX before = scene.bodies.x;
    CHECK(sentence_of([&] { step_in_parts(scene, {}, 0, method, now); }) ==
          "a step is taken in 0 parts; it must be 1 or more");
    CHECK(same_bits(scene.bodies.x, before));
}

TEST_CASE("what falls overlaps by no more than its way in a part and what turns does so too", "[house]")
{
    // in sub-steps a contact is found once, and its normal and its points stay
    const auto deepest_of = [](int parts, int substeps, Real spin) {
        Real deepest = 0;
        for (int n = 0; n < 12; ++n) {  // how far it is from the floor at a step's end is by lot
            SpaceScene scene;
            scene.length = 1;
            const Index k = add_body(scene, {solid_box({0.2, 0.2, 0.2})}, 1000.0, {0, 0.6 + 0.01 * n, 0});
            add_floor(scene, 0.5);
            scene.bodies.velocity(k)[1] = -5;
            scene.bodies.velocity(k)[5] = spin;
            TouchingCones method;
            StepData<6> now;
            const SolidForm form = form_of(scene.shapes[0][0]);
            for (int i = 0; i < 20; ++i) {
                step_in_parts(scene, {.h = sixtieth, .substeps = substeps}, parts, method, now);
                for (const Vec3& vertex : form.hull.vertices)
                    deepest = std::max(deepest, -point_of_solid(scene.bodies.x, k, vertex).y());
            }
        }
        return deepest;
    };
    for (const Real spin : {0.0, 15.0}) {
        const Real speed = 6 + 0.35 * spin;  // of the fastest corner
        INFO("spin " << spin);
        const Real whole = deepest_of(1, 1, spin), sub = deepest_of(1, 4, spin),
                   parts = deepest_of(4, 1, spin);
        CAPTURE(whole, sub, parts);
        CHECK(whole > 0.03);
        CHECK(sub > 0.03);
        CHECK(parts < speed * sixtieth / 4);
        CHECK(parts < whole / 2);
        CHECK(parts < sub / 2);
    }
}
