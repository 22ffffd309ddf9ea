/// Chapter 29: water in two directions: mass, momentum, water at rest, a round dam break, and what it shares with columns.

#include "tests/catch.hpp"
#include "tests/no_allocation.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

#include "chapters/29_waves/shallow_water.hpp"
#include "chapters/29_waves/water_field.hpp"
#include "common/random.hpp"

using namespace rigid;

namespace {

/// Rough ground, a third of it dry, and all in motion.
WaterField any_water(Index nx, Index ny, Real size, Random& random)
{
    WaterField water(nx, ny, size, 0);
    for (Index k = 0; k < nx * ny; ++k) {
        water.bed[k] = size * random.uniform(0, 2);
        const bool is_dry = random.uniform() < 0.3;
        water.depth[k] = is_dry ? 0 : size * random.uniform();
    }
    const Real speed = std::sqrt(9.81 * size);
    for (Index j = 0; j < ny; ++j)
        for (Index i = 1; i < nx; ++i) water.u[j * (nx + 1) + i] = speed * random.uniform(-1, 1);
    for (Index k = nx; k < nx * ny; ++k) water.v[k] = speed * random.uniform(-1, 1);
    return water;
}

constexpr Real dam_radius = 2.5, before_dam = 0.2, dam_time = 0.6;

/// The part of a cell that lies within the round dam, by 16 × 16 points.
Real part_inside(const Vec2& middle, Real dx)
{
    int inside = 0;
    for (int a = 0; a < 16; ++a)
        for (int b = 0; b < 16; ++b)
            inside += (middle + dx * Vec2((a - 7.5) / 16, (b - 7.5) / 16)).norm() < dam_radius;
    return inside / 256.0;
}

/// A round dam of 1 m in a square of 10 m, 0.6 s after it broke: nothing has come to the walls.
WaterField round_dam(Index cells)
{
    WaterField water(cells, cells, 10 / static_cast<Real>(cells), before_dam);
    for (Index j = 0; j < cells; ++j)
        for (Index i = 0; i < cells; ++i)
            water.depth[water.at(i, j)] +=
                (1 - before_dam) * part_inside(water.middle_of(i, j) - Vec2(5, 5), water.dx);
    const Index steps = cells;  // at most 0.7 of what is stable
    for (Index n = 0; n < steps; ++n) step(water, dam_time / static_cast<Real>(steps));
    return water;
}

/// The same dam as a problem of one dimension, along the radius, by another method: rings that exchange mass and momentum
/// by the fluxes of Harten, Lax and van Leer. Its 4,000 rings are twenty times as fine as the finest plane beside it.
VecX rings()
{
    const Index n = 4000;
    const Real width = 5.0 / static_cast<Real>(n), g = 9.81;
    VecX r(n), m = VecX::Zero(n), mass = VecX::Zero(n + 1), push = mass;
    for (Index i = 0; i < n; ++i) r[i] = (static_cast<Real>(i) + 0.5) * width < dam_radius ? 1 : before_dam;
    const Index steps = 4000;  // at most 0.6 of a ring a step
    const Real h = dam_time / static_cast<Real>(steps);
    for (Index t = 0; t < steps; ++t) {
        for (Index f = 1; f < n; ++f) {
            const Real ul = m[f - 1] / r[f - 1], ur = m[f] / r[f], cl = std::sqrt(g * r[f - 1]),
                       cr = std::sqrt(g * r[f]), a = std::min(std::min(ul - cl, ur - cr), 0.0),
                       b = std::max(std::max(ul + cl, ur + cr), 0.0);
            const Real pl = m[f - 1] * ul + g / 2 * r[f - 1] * r[f - 1], pr = m[f] * ur + g / 2 * r[f] * r[f];
            mass[f] = (b * m[f - 1] - a * m[f] + a * b * (r[f] - r[f - 1])) / (b - a);
            push[f] = (b * pl - a * pr + a * b * (m[f] - m[f - 1])) / (b - a);
        }
        push[0] = g / 2 * r[0] * r[0], push[n] = g / 2 * r[n - 1] * r[n - 1];
        for (Index i = 0; i < n; ++i) {
            const auto left = static_cast<Real>(i), right = left + 1, middle = left + 0.5;
            // the walls of a ring push outwards as well: g r²/2 on what is wider outside than inside
            m[i] +=
                h / width * ((left * push[i] - right * push[i + 1]) / middle + g / 2 * r[i] * r[i] / middle);
            r[i] += h / width * (left * mass[i] - right * mass[i + 1]) / middle;
        }
    }
    return r;
}

/// Σ Δx² |r − r of the ring there| [m³].
Real error_beside(const VecX& ring, const WaterField& water)
{
    Real sum = 0;
    for (Index j = 0; j < water.ny; ++j)
        for (Index i = 0; i < water.nx; ++i) {
            const Real at = (water.middle_of(i, j) - Vec2(5, 5)).norm() / 5 * static_cast<Real>(ring.size());
            const Index k = std::min(static_cast<Index>(at), ring.size() - 1);
            sum += std::abs(water.depth[water.at(i, j)] - ring[k]);
        }
    return sum * water.dx * water.dx;
}

}  // namespace

TEST_CASE("a plane on which nothing differs across moves as the row of columns does to the bit", "[idea]")
{
    // 1,300 columns: more than step() moves at once
    Random random(3);
    const Index N = 1300;
    ShallowWater row(N, 0.1 * static_cast<Real>(N), 1);
    WaterField along(N, 3, row.dx, 1), across(2, N, row.dx, 1);
    for (Index i = 0; i < N; ++i) {
        row.bed[i] = random.uniform();
        const bool is_dry = random.uniform() < 0.3;
        row.depth[i] = is_dry ? 0 : random.uniform();
        for (Index j = 0; j < 3; ++j)
            along.bed[along.at(i, j)] = row.bed[i], along.depth[along.at(i, j)] = row.depth[i];
        for (Index j = 0; j < 2; ++j)
            across.bed[across.at(j, i)] = row.bed[i], across.depth[across.at(j, i)] = row.depth[i];
    }
    level_water(row);
    for (int n = 0; n < 200; ++n) {
        const Real h = 0.9 * stable_step(along);
        step(row, h), step(along, h), step(across, h);
    }
    CHECK(row.u.cwiseAbs().maxCoeff() > 0.1);
    for (Index i = 0; i < N; ++i) {
        CHECK(along.depth[along.at(i, 1)] == row.depth[i]);
        CHECK(across.depth[across.at(1, i)] == row.depth[i]);
        CHECK(along.u[(N + 1) + i] == row.u[i]);
        CHECK(across.v[2 * i] == row.u[i]);
    }
}

TEST_CASE("the columns that a step moves at once do not show in what it does", "[house]")
{
    // the same by its pieces, which go over all columns each
    Random random(4);
    for (const Index N : {517, 518, 519, 1024, 1031, 1540}) {
        ShallowWater water(N, 0.1 * static_cast<Real>(N), 0);
        for (Index i = 0; i < N; ++i) water.depth[i] = random.uniform();
        if (N == 1031) water.damping = VecX::Constant(N + 1, 0.5);
        water.u[0] = 0.2, water.u[N] = -0.1;  // both walls move
        ShallowWater pieces = water;
        for (int n = 0; n < 30; ++n) {
            step(water, 0.01);
            level_water(pieces), push_water(pieces, 0.01), carry_water(pieces, 0.01), level_water(pieces);
        }
        CHECK(water.depth == pieces.depth);
        CHECK(water.u == pieces.u);
        CHECK(water.level == pieces.level);
    }
}

TEST_CASE(
    "water on a plane keeps its mass over a hundred thousand steps and at rest stays at rest over any bed",
    "[idea]")
{
    Random random(5);
    const Index n = 14;
    WaterField rest(n, n, 0.1, 0), moving = rest;
    for (Index k = 0; k < n * n; ++k) {
        const Vec2 off = rest.middle_of(k % n, k / n) - Vec2(0.7, 0.7);
        rest.bed[k] = moving.bed[k] = 1.4 - 2 * off.norm() + 0.1 * random.uniform();  // an island
        rest.depth[k] = std::max(0.0, 1 - rest.bed[k]);
        moving.depth[k] = rest.depth[k] > 0 ? rest.depth[k] + 0.2 * random.uniform() : 0;
    }
    REQUIRE((rest.depth.array() == 0).count() > 10);
    const Real at_rest = volume(rest), in_motion = volume(moving), whole = energy(moving);
    Real most = 0;
    for (int t = 0; t < 100000; ++t) {
        step(rest, 0.01);
        step(moving, 0.01);
        if (t % 100 == 0) most = std::max(most, energy(moving));
    }
    // as in a row of columns: 1e5 roundings
    CHECK(rest.u.cwiseAbs().maxCoeff() < 1e-11);
    CHECK(rest.v.cwiseAbs().maxCoeff() < 1e-11);
    CHECK(volume(rest) == Approx(at_rest).epsilon(1e-12));
    CHECK(volume(moving) == Approx(in_motion).epsilon(1e-12));
    CHECK(moving.depth.minCoeff() >= 0);
    // upwind means take energy, and slopes and flows half a step apart give at most what a step moves
    CHECK(most < whole);
}

TEST_CASE("what is exchanged in x and y moves with x and y exchanged to the bit", "[idea]")
{
    Random random(6);
    WaterField water = any_water(17, 23, 1, random), turned(23, 17, 1, 0);
    for (Index j = 0; j < 23; ++j)
        for (Index i = 0; i < 17; ++i) {
            turned.bed[turned.at(j, i)] = water.bed[water.at(i, j)];
            turned.depth[turned.at(j, i)] = water.depth[water.at(i, j)];
        }
    for (Index j = 0; j < 23; ++j)
        for (Index i = 0; i <= 17; ++i) turned.v[i * 23 + j] = water.u[j * 18 + i];
    for (Index j = 0; j <= 23; ++j)
        for (Index i = 0; i < 17; ++i) turned.u[i * 24 + j] = water.v[j * 17 + i];
    for (int n = 0; n < 200; ++n) {
        const Real h = 0.9 * stable_step(water);
        CHECK(h == 0.9 * stable_step(turned));
        step(water, h), step(turned, h);
    }
    for (Index j = 0; j < 23; ++j)
        for (Index i = 0; i < 17; ++i) CHECK(turned.depth[turned.at(j, i)] == water.depth[water.at(i, j)]);
}

TEST_CASE("water on a level plane keeps both its momenta to rounding", "[idea]")
{
    const Index n = 120;
    WaterField water(n, n, 0.1, 1);
    for (Index j = 0; j < n; ++j)
        for (Index i = 1; i < n; ++i) {
            const Vec2 off = water.middle_of(i, j) - Vec2(6, 6);
            if (off.norm() >= 0.8) continue;
            water.depth[water.at(i, j)] += 0.4 * (0.64 - off.squaredNorm());
            water.u[j * (n + 1) + i] = 0.7 + off.y(), water.v[j * n + i] = -0.4 + off.x() * off.y();
        }
    const Vec2 start = momentum(water);
    for (int t = 0; t < 40; ++t) step(water, 0.01);
    for (Index k = 0; k < n; ++k) {  // nothing has reached the walls
        REQUIRE(water.depth[water.at(k, 0)] == 1);
        REQUIRE(water.depth[water.at(k, n - 1)] == 1);
        REQUIRE(water.depth[water.at(0, k)] == 1);
        REQUIRE(water.depth[water.at(n - 1, k)] == 1);
    }
    CHECK(start.norm() > 100);
    CHECK((momentum(water) - start).norm() < 1e-12 * start.norm());  // 40 steps of 14,400 roundings
}

TEST_CASE("water on a plane of any depths and speeds never becomes negative or infinite", "[idea]")
{
    Random random(8);
    for (int round = 0; round < 30; ++round) {
        const Real size = rigid::pow(10.0, random.uniform(-3, 3));
        WaterField water = any_water(9, 7, size, random);
        const Real whole = volume(water);
        for (int n = 0; n < 300; ++n) step(water, 0.9 * stable_step(water));
        CHECK(water.depth.minCoeff() >= 0);
        CHECK(water.depth.allFinite());
        CHECK(water.u.allFinite());
        CHECK(water.v.allFinite());
        CHECK(volume(water) == Approx(whole).epsilon(1e-12));
    }
}

TEST_CASE("a round dam break tends to that of rings and is as far in all directions", "[idea]")
{
    const VecX ring = rings();
    std::vector<Real> errors;
    // the table of section 29.H
    for (const auto& [n, stated] :
         {std::pair{Index{50}, 1.598}, {Index{100}, 0.948}, {Index{200}, 0.556}, {Index{400}, 0.309}}) {
        const WaterField water = round_dam(n);
        errors.push_back(error_beside(ring, water));
        CHECK(errors.back() == Approx(stated).margin(5.1e-4));
        // its eight mirror images: rounding, which the steps add up
        for (Index k = 0; k < n / 2; ++k)
            CHECK(std::abs(water.depth[water.at(k, n / 3)] - water.depth[water.at(n - 1 - n / 3, k)]) <
                  1e-12);
    }
    CHECK(order_of(errors) == Approx(0.75).margin(0.2));  // as along a row, section 29.D
}

TEST_CASE("pressed water gives way and none is lost", "[idea]")
{
    WaterField water(20, 20, 0.1, 0.5);
    const Real whole = volume(water);
    for (int n = 0; n < 10; ++n) {
        press(water, {1, 1}, 0.4, 0.2, 0.01);
        step(water, 0.01);
    }
    CHECK(water.depth[water.at(10, 10)] < 0.49);
    CHECK(volume(water) == Approx(whole).epsilon(1e-14));
    CHECK(momentum(water).norm() < 1e-10);  // as much to each side; 20 kg of water at some 0.1 m/s
}

TEST_CASE("a step of water on a plane asks for no memory and what makes no sense is refused by name",
          "[house]")
{
    WaterField water(30, 20, 0.1, 1);
    water.depth[100] = 1.3;
    ShallowWater row(600, 6, 1);
    step(water, 0.01), step(row, 0.001);
    int violations = 0;
    {
        const NoAllocation forbidden;
        for (int n = 0; n < 20; ++n) step(water, 0.01), step(row, 0.001);
        violations = NoAllocation::violations();
    }
    CHECK(violations == 0);
    CHECK(sentence_of([] { WaterField(0, 4, 1, 1); }) ==
          "the water has 0 by 4 cells; it must have one or more each way");
    CHECK(sentence_of([] { WaterField(4, 4, -1, 1); }) ==
          "the width of a cell is -1 m; it must be positive and finite");
    CHECK(sentence_of([] { WaterField(4, 4, 1, -1); }) ==
          "the depth of the water is -1 m; it must be zero or positive and finite");
    const auto plane = [](const auto& change, bool late) {
        WaterField w(4, 4, 1, 1);
        if (late) step(w, 0.01);
        change(w);
        return sentence_of([&] { step(w, 0.01); });
    };
    for (const bool late : {false, true}) {
        CHECK(plane([](auto& w) { w.depth[9] = NAN; }, late) ==
              "depth[9] is nan; it must be a finite number");
        CHECK(plane([](auto& w) { w.depth[9] = -1; }, late) ==
              "depth[9] is -1 m; it must be zero or positive");
        CHECK(plane([](auto& w) { w.v[2] = NAN; }, late) == "v[2] is nan; it must be a finite number");
        CHECK(plane([](auto& w) { w.u.conservativeResize(3); }, late) ==
              "u has 3 entries; water of 4 by 4 cells needs 20");
    }
    CHECK(plane([](auto& w) { w.nx = w.ny = -4; }, true) ==
          "the water has -4 by -4 cells; it must have one or more each way");
    WaterField still(4, 4, 1, 1);
    CHECK(sentence_of([&] { step(still, 1); }) ==
          "the time step is 1 s; a wave passes a whole cell in " + shortest(1 / std::sqrt(2 * 9.81)) + " s");
    CHECK(sentence_of([&] {
              press(still, {0, 0}, 0, 1, 1);
          }).starts_with("the water is pressed at (0, 0) m within 0 m by a column of 1 m"));
    still.depth[3] = -1;
    CHECK(sentence_of([&] { require_valid(still); }) == "depth[3] is -1 m; it must be zero or positive");
    still.u.conservativeResize(3);
    still.depth[3] = 1;
    CHECK(sentence_of([&] { require_valid(still); }) == "u has 3 entries; water of 4 by 4 cells needs 20");
}
