/// Chapter 29: shallow water, and bodies that float on it: mass, momentum, dam breaks, Archimedes, which box capsizes.

#include "tests/catch.hpp"
#include "tests/no_allocation.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

#include "chapters/15_trees/tree_method.hpp"
#include "chapters/29_waves/water_scenes.hpp"
#include "chapters/29_waves/water_step.hpp"
#include "chapters/29_waves/wave_line.hpp"
#include "common/elementary.hpp"
#include "common/random.hpp"

using namespace rigid;

namespace {

/// A dam at x = 0 in 20 m of water, one second after it broke.
ShallowWater broken_dam(Index cells, Real right)
{
    ShallowWater water(cells, 20, right);
    water.origin = -10;
    water.depth.head(cells / 2).setConstant(1);
    const auto steps = static_cast<int>(cells);  // at most 0.63 of a cell a step, at 2√(gH)
    for (int n = 0; n < steps; ++n) step(water, 1.0 / steps);
    return water;
}

Real error_of_dam(const ShallowWater& water, Real right)
{
    Real sum = 0;
    for (Index i = 0; i < water.cells(); ++i)
        sum += water.dx * std::abs(water.depth[i] - dam_break(1, right, water.g, water.x_of(i), 1).depth);
    return sum;
}

/// A body alone, without contacts: gravity, then x.
void fall(JointedScene& scene, Real h)
{
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        scene.bodies.velocity(k).head<2>() += h * scene.gravity;
        scene.bodies.integrate(k, scene.bodies.velocity(k), h);
    }
}

/// Momentum along x of water and bodies [N s].
Real whole_momentum(const WaterScene& all)
{
    Real sum = momentum(all.water);
    for (Index k = 0; k < all.scene.bodies.count(); ++k)
        sum += all.scene.bodies.velocity(k)[0] / all.scene.bodies.inverse_mass[3 * k];
    return sum;
}

/// Of water and bodies [J].
Real kinetic_energy(const WaterScene& all)
{
    const Bodies<3>& bodies = all.scene.bodies;
    const ShallowWater& water = all.water;
    Real sum = 0;
    for (Index i = 0; i < bodies.u.size(); ++i)
        sum += 0.5 * bodies.u[i] * bodies.u[i] / bodies.inverse_mass[i];
    for (Index f = 1; f < water.cells(); ++f)
        sum +=
            0.25 * water.density * water.dx * (water.depth[f - 1] + water.depth[f]) * water.u[f] * water.u[f];
    return sum;
}

void take(WaterScene& all, Floating& floating, Real h, int steps, bool touching = false)
{
    JointTrees<Manifolds> method;
    never_stop(method.contacts);
    if (!touching) method.contacts.finder.filter.set_meets(0, 0, false);
    StepData<3> now;
    for (int n = 0; n < steps; ++n) step(all.scene, all.water, floating, {.h = h}, method, now);
}

}  // namespace

// ------------------------------------------------------------------------------------------------ water alone

TEST_CASE("a small wave on shallow water is the string's leapfrog with c the root of gH", "[idea]")
{
    const Index N = 32;
    ShallowWater water(N, 1, 1);
    water.g = 1;
    const Real k = 3 * pi, a = 1e-7, h = 0.5 * water.dx;
    for (Index i = 0; i < N; ++i) water.depth[i] += a * rigid::cos(k * water.x_of(i));
    level_water(water);
    for (Index f = 1; f < N; ++f) water.u[f] = h / 2 * (water.level[f] - water.level[f - 1]) / water.dx;
    const Real omega = leapfrog_frequency(k, 1, water.dx, h), start = water.depth[3] - 1;
    for (int n = 1; n <= 200; ++n) {
        step(water, h);
        // the square of the amplitude, times the radians that it went
        REQUIRE(std::abs(water.depth[3] - 1 - start * rigid::cos(omega * h * n)) < a * a * 30);
    }
}

TEST_CASE(
    "water keeps its mass to rounding over a hundred thousand steps and at rest stays at rest over any bed",
    "[idea]")
{
    Random random(5);
    const Index N = 60;
    ShallowWater rest(N, 6, 1), moving(N, 6, 1);
    for (Index i = 0; i < N; ++i) {
        const Real x = rest.x_of(i) - 3;
        // an island in the middle, rough everywhere
        rest.bed[i] = 1.5 * rigid::exp(-x * x) + 0.1 * random.uniform();
        rest.depth[i] = std::max(0.0, 1 - rest.bed[i]);
        moving.bed[i] = rest.bed[i];
        moving.depth[i] = rest.depth[i] > 0 ? rest.depth[i] + 0.2 * random.uniform() : 0;
    }
    const Real at_rest = volume(rest), in_motion = volume(moving);
    Real least = 1;
    for (int n = 0; n < 100000; ++n) {
        step(rest, 0.01);
        step(moving, 0.01);
        least = std::min(least, moving.depth.minCoeff());
    }
    // 1e5 roundings of either sign; a rounding of the level is 1e-16 m, which g h / Δx makes a speed of 1e-16 a step
    CHECK(rest.u.cwiseAbs().maxCoeff() < 1e-11);
    CHECK(volume(rest) == Approx(at_rest).epsilon(1e-12));
    CHECK(volume(moving) == Approx(in_motion).epsilon(1e-12));
    CHECK(least >= 0);
}

TEST_CASE("water over a level bed keeps its momentum to rounding", "[idea]")
{
    ShallowWater water(200, 20, 1);
    for (Index i = 0; i < 200; ++i) {
        const Real x = water.x_of(i) - 10;
        water.depth[i] += std::abs(x) < 2 ? 0.5 * (4 - x * x) / 4 : 0;
        if (std::abs(x) < 1 && i > 0) water.u[i] = 0.7 + x;
    }
    const Real start = momentum(water);
    // 150 steps of 0.01 s: nothing has reached the ends, whose water pushes equally at both
    for (int n = 0; n < 150; ++n) step(water, 0.01);
    REQUIRE(water.depth[0] == 1);
    REQUIRE(water.depth[199] == 1);
    CHECK(start > 100);
    CHECK(momentum(water) == Approx(start).epsilon(1e-12));  // 150 steps of 200 roundings
}

TEST_CASE("a dam break tends to the solutions of Ritter and of Stoker", "[idea]")
{
    for (const Real right : {0.0, 0.1}) {
        std::vector<Real> errors;
        for (const Index n : {100, 200, 400, 800})
            errors.push_back(error_of_dam(broken_dam(n, right), right));
        // the first order at best: a corner of the exact solution moves by a cell
        CHECK(order_of(errors) == Approx(0.75).margin(0.2));
        CHECK(errors.back() < 0.06);
    }
    const ShallowWater water = broken_dam(400, 0);
    CHECK(volume(water) == Approx(10).epsilon(1e-12));
    CHECK(water.depth.minCoeff() >= 0);
}

TEST_CASE("the exact dam break has the reference front and its own jumps", "[idea]")
{
    const Real g = 9.81, front = 6.26418390534633;
    CHECK(dam_break(1, 0, g, front * 1.0001, 1).depth == 0);
    CHECK(dam_break(1, 0, g, front * 0.9999, 1).depth > 0);
    CHECK(dam_break(1, 0, g, 0, 1).depth == Approx(4.0 / 9).epsilon(1e-14));
    CHECK(dam_break(1, 0, g, 0, 1).u == Approx(2.0 / 3 * std::sqrt(g)).epsilon(1e-14));
    // mass and momentum that pass the bore: (r u) and (r u² + g r²/2) jump by its speed times the jump of r and of r u
    const DamBreak m = dam_break(1, 0.1, g, 2, 1);
    Real speed = 2;
    while (dam_break(1, 0.1, g, speed, 1).u > 0) speed += 1e-4;
    CHECK(m.depth * m.u == Approx(speed * (m.depth - 0.1)).epsilon(1e-3));  // the bore is found to 1e-4 m/s
    CHECK(m.depth * m.u * m.u + g / 2 * (m.depth * m.depth - 0.01) ==
          Approx(speed * m.depth * m.u).epsilon(1e-3));
    CHECK(m.u == Approx(2 * (std::sqrt(g) - std::sqrt(g * m.depth))).epsilon(1e-12));
}

TEST_CASE("water of any depths and speeds never becomes negative or infinite", "[idea]")
{
    Random random(8);
    for (int round = 0; round < 30; ++round) {
        const Real size = rigid::pow(10.0, random.uniform(-3, 3));
        ShallowWater water(20, 20 * size, 0);
        for (Index i = 0; i < 20; ++i) {
            water.bed[i] = size * random.uniform(0, 2);
            water.depth[i] = random.uniform() < 0.3 ? 0 : size * random.uniform();
        }
        for (Index f = 1; f < 20; ++f) water.u[f] = std::sqrt(9.81 * size) * random.uniform(-2, 2);
        const Real whole = volume(water);
        for (int n = 0; n < 300; ++n) step(water, 0.9 * stable_step(water));
        CHECK(water.depth.minCoeff() >= 0);
        CHECK(water.depth.allFinite());
        CHECK(water.u.allFinite());
        CHECK(volume(water) == Approx(whole).epsilon(1e-12));
    }
}

TEST_CASE("behind a bore water swings by the same part of it whatever the cells", "[idea]")
{
    struct Case {
        Real right, part;  ///< [m]; of the longest step
        Real least, most;  ///< of the bore's height, section 29.D
    };
    for (const auto& [right, part, least, most] :
         {Case{0.5, 0.5, 0.09, 0.15}, {0.5, 0.9, 0.15, 0.20}, {0.1, 0.5, 0.02, 0.05}})
        for (const Index n : {200, 400, 800}) {
            ShallowWater water(n, 20, right);
            water.origin = -10;
            water.depth.head(n / 2).setConstant(1);
            Real t = 0;
            while (t < 1) {
                const Real h = std::min(part * stable_step(water), 1 - t);
                if (h < 1e-12) break;
                step(water, h), t += h;
            }
            const Real middle = dam_break(1, right, water.g, 2, 1).depth;
            Index bore = 0;
            for (Index i = 0; i < n; ++i)
                if (water.depth[i] > (middle + right) / 2) bore = i;
            Real swing = 0, after = 0;  // close to the bore, and some cells behind it
            for (Index i = bore - 14; i <= bore; ++i) {
                const Real off = (water.depth[i] - middle) / (middle - right);
                swing = std::max(swing, off);
                if (i < bore - 7) after = std::max(after, std::abs(off));
            }
            INFO(right << ", " << part << ", " << n << ": " << swing << ", " << after);
            CHECK(swing > least);
            CHECK(swing < most);
            CHECK(after < 0.01);
        }
}

TEST_CASE("a standing wave on shallow water loses the less of its energy the lower it is", "[idea]")
{
    const auto kept = [](Real height, int periods) {
        ShallowWater water(200, 10, 1), still = water;
        for (Index i = 0; i < 200; ++i) water.depth[i] += height * rigid::cos(pi * water.x_of(i) / 10);
        const Real period = 20 / std::sqrt(9.81), start = energy(water) - energy(still),
                   whole = volume(water);
        const auto steps = static_cast<int>(std::ceil(period / (0.5 * water.dx / std::sqrt(9.81 * 1.3))));
        for (int n = 0; n < periods * steps; ++n) step(water, period / steps);
        CHECK(volume(water) == Approx(whole).epsilon(1e-13));
        return (energy(water) - energy(still)) / start;
    };
    // section 29.D
    CHECK(1 - kept(0.001, 1) == Approx(4e-5).margin(5e-6));
    CHECK(1 - kept(0.01, 1) == Approx(4e-4).margin(5e-5));
    CHECK(1 - kept(0.1, 1) == Approx(4e-3).margin(5e-4));
    CHECK(1 - kept(0.3, 1) == Approx(0.12).margin(0.01));  // it breaks
    CHECK(kept(0.001, 110) == Approx(0.996).margin(5e-4));
    CHECK(kept(0.01, 110) == Approx(0.19).margin(0.01));
}

TEST_CASE("water that is mirrored moves mirrored", "[idea]")
{
    Random random(6);
    ShallowWater water(30, 3, 0), mirrored = water;
    for (Index i = 0; i < 30; ++i) {
        water.depth[i] = random.uniform();
        mirrored.depth[29 - i] = water.depth[i];
    }
    for (int n = 0; n < 200; ++n) step(water, 0.01), step(mirrored, 0.01);
    for (Index i = 0; i < 30; ++i) CHECK(water.depth[i] == Approx(mirrored.depth[29 - i]).margin(1e-12));
}

// ------------------------------------------------------------------------------------------------ Archimedes

TEST_CASE("a polygon under water has the area centroid and waterline of its pieces", "[idea]")
{
    const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, diamond{{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    const Submerged half = submerged(square, 0.5), tip = submerged(diamond, -0.5),
                    all = submerged(diamond, 3);
    CHECK(half.area == 1);
    CHECK(half.centroid == Vec2(1, 0.25));
    CHECK(half.width == 2);
    CHECK(tip.area == Approx(0.25).epsilon(1e-15));
    CHECK(tip.centroid.y() == Approx(-2.0 / 3).epsilon(1e-15));
    CHECK(tip.width == Approx(1).epsilon(1e-15));
    CHECK(all.area == Approx(2).epsilon(1e-15));
    CHECK(all.width == 0);
    CHECK(submerged(square, -1).area == 0);
}

TEST_CASE(
    "a box that is let go heaves with the frequency of its waterline and floats at the draught of Archimedes",
    "[idea]")
{
    // in water that nothing moves: symplectic Euler on one spring, ω² = ρ g W / m
    WaterScene all = pond(40, 10, 2);
    Floating floating;
    floating.settings = {0, 0, 0};
    add_floating_box(all, 0, 0.5, 2, 0.6, 0);
    const Real rest = all.scene.bodies.x[1], a = 0.05, h = 1.0 / 120;
    const Real omega = std::sqrt(9.81 / box_draught(0.5, 0.6)), slowed = 2 / h * rigid::asin(omega * h / 2);
    all.scene.bodies.x[1] += a;
    all.scene.bodies.u[1] = h / 2 * omega * omega * a;
    for (int n = 1; n <= 1000; ++n) {
        floating.find(all.scene, all.water);
        floating.push(all.scene, all.water, h);
        fall(all.scene, h);
        // sums of the size of its place, 1.95 m
        REQUIRE(std::abs(all.scene.bodies.x[1] - rest - a * rigid::cos(slowed * h * n)) < 1e-12);
    }
    CHECK(rest == Approx(2 - 0.3 + 0.25).epsilon(1e-15));
}

TEST_CASE("the box with the metacentre below its centre capsizes and the other one stays upright", "[idea]")
{
    CHECK(box_metacentric_height(1, 1, 0.5) == Approx(1.0 / 6 - 0.25).epsilon(1e-14));
    // at half the density of water a box turns over below a width of √1.5 of its height
    CHECK(std::abs(box_metacentric_height(std::sqrt(1.5), 1, 0.5)) < 1e-15);
    for (const Real ratio : {1.1, 1.2, 1.25, 1.4}) {
        WaterScene all = pond(80, 8, 1);
        Floating floating;
        add_floating_box(all, 0.01, 0.5, ratio, 0.5, 0.02);
        floating.displace(all.scene, all.water);
        Real most = 0;
        for (int n = 0; n < 4800; ++n) {
            floating.find(all.scene, all.water);
            floating.push(all.scene, all.water, 1.0 / 240);
            fall(all.scene, 1.0 / 240);
            carry_water(all.water, 1.0 / 240);
            most = std::max(most, std::abs(all.scene.bodies.x[2]));
        }
        INFO(ratio);
        if (box_metacentric_height(ratio, 1, 0.5) < 0) CHECK(most > 0.1);
        else CHECK(most < 0.021);  // of 0.02 at the start
    }
}

TEST_CASE("a box that capsizes finds its rest at the lean (29.18a)", "[idea]")
{
    for (const Real ratio : {1.1, 1.2}) {
        const Real GM = box_metacentric_height(ratio, 1, 0.5), BM = ratio * ratio / (12 * 0.5);
        const Real lean = rigid::atan(std::sqrt(-2 * GM / BM));
        for (const Real beside : {-0.15, 0.0, 0.15}) {
            WaterScene all = pond(320, 8, 1);
            Floating floating;
            floating.settings = {0, 0, 0};
            add_floating_box(all, 0.01, 0.5, ratio, 0.5, lean + beside);
            floating.displace(all.scene, all.water);
            Real least = 10, most = 0;
            for (int n = 0; n < 1920; ++n) {
                floating.find(all.scene, all.water);
                floating.push(all.scene, all.water, 1.0 / 960);
                fall(all.scene, 1.0 / 960);
                carry_water(all.water, 1.0 / 960);
                least = std::min(least, all.scene.bodies.x[2]);
                most = std::max(most, all.scene.bodies.x[2]);
            }
            INFO(ratio << ", from " << lean << " + " << beside << ": " << least << " to " << most);
            if (beside == 0) CHECK(most - least < 1e-9);
            else CHECK((least < lean - 0.03 && most > lean + 0.03));  // it swings about it
        }
    }
}

TEST_CASE("a boat that is tilted and let go on still water rolls less and less and never turns over",
          "[idea]")
{
    // nothing brakes it but the waves that it makes; they come back from both walls, and must not tilt it farther
    for (const Real lid : {0.5, 0.8})
        for (const Real tilt : {0.02, 0.3}) {
            WaterScene all = pond(128, 16, 1.5);
            Floating floating;
            floating.settings = {lid, 0, 0};
            const Polygon hull{{{-0.8, -0.35}, {0.8, -0.35}, {1.2, 0.3}, {-1.2, 0.3}}, 0};
            add_body(all.scene, hull, Mass{600, {0, -0.15}, 220}, {0.03, 0});
            // its draught d: 1.6 d + 0.4 d² / 0.65 = 600 / 1000, and its centre is 0.2 m above its bottom
            all.scene.bodies.position(0)[1] = 1.5 - 0.33279 + 0.2;
            floating.displace(all.scene, all.water);
            all.scene.bodies.position(0)[2] = tilt;
            Real most = 0, late = 0;
            for (int n = 0; n < 30 * 240; ++n) {
                floating.find(all.scene, all.water);
                floating.push(all.scene, all.water, 1.0 / 240);
                fall(all.scene, 1.0 / 240);
                carry_water(all.water, 1.0 / 240);
                const Real now = std::abs(all.scene.bodies.x[2]);
                most = std::max(most, now);
                if (n >= 20 * 240) late = std::max(late, now);
            }
            INFO(lid << ", " << tilt);
            CHECK(most <= tilt);
            CHECK(late < 0.7 * tilt);  // what waves take from it they take soon: a third at least
            CHECK(late > 0.1 * tilt);  // and they come back
        }
}

// ------------------------------------------------------------------------------------------------ both together

TEST_CASE("water and bodies keep the momentum of both and the water its volume to rounding", "[idea]")
{
    for (const Real lid : {0.0, 0.5, 0.8}) {
        WaterScene all = pond(300, 100, 1);
        all.scene.walls.clear();
        Floating floating;
        floating.settings.lid = lid;
        add_floating_box(all, 0, 0.5, 2, 0.6, 0.3);
        add_floating_box(all, 2.2, 0.5, 1.6, 0.5, 0.1);
        add_raft(all, 6, 4);
        floating.displace(all.scene, all.water);
        all.scene.bodies.u[0] = 1;  // one swims, and a wave comes
        for (Index i = 0; i < 300; ++i) {
            const Real x = all.water.x_of(i) + 5;
            if (std::abs(x) < 4) all.water.depth[i] += 0.2 * (1 - x * x / 16);
        }
        const Real start = whole_momentum(all), whole = volume(all.water);
        take(all, floating, 1.0 / 240, 1200);
        REQUIRE(all.water.depth[0] == 1);  // nothing has come to the walls
        REQUIRE(all.water.depth[299] == 1);
        CHECK(start == Approx(300));
        // 1200 steps; water of 1e5 kg exchanges some 1e3 N s with the bodies in each wave
        CHECK(whole_momentum(all) == Approx(start).epsilon(1e-11));
        CHECK(volume(all.water) == Approx(whole).epsilon(1e-13));
        CHECK(std::abs(all.scene.bodies.u[0] - 1) > 0.1);  // and something was exchanged
    }
}

TEST_CASE("bodies afloat lift the level by what they displace and come to rest in it", "[idea]")
{
    for (const Real lid : {0.2, 0.8}) {
        WaterScene all = pond(64, 8, 1);
        Floating floating;
        floating.settings.lid = lid;
        add_floating_box(all, 0.03, 0.5, 2, 0.6, 0);
        floating.displace(all.scene, all.water);
        take(all, floating, 1.0 / 240, 240);
        // in balance from the start: to what Newton's method leaves
        CHECK((all.water.level.array() - 1).abs().maxCoeff() < 1e-8);
        CHECK(all.scene.bodies.x[1] == Approx(1 - 0.3 + 0.25).margin(1e-8));
        CHECK(volume(all.water) == Approx(8 - lid * 0.3).epsilon(1e-12));
    }
}

namespace {

/// A box of 1 m by 0.4 m that floats on 1 m of open water, lifted above its rest [m].
WaterScene box_lifted(Floating& floating, Real lid, Real by)
{
    WaterScene all = pond(800, 200, 1);
    all.scene.walls.clear();
    floating.settings = {lid, 0, 0};
    add_floating_box(all, 0, 0.4, 2.5, 0.5, 0);
    floating.displace(all.scene, all.water);
    all.scene.bodies.x[1] += by;
    return all;
}

}  // namespace

TEST_CASE("a box that is let go above its rest sends waves out and comes to rest", "[idea]")
{
    for (const Real lid : {0.0, 0.5}) {
        Floating floating;
        WaterScene all = box_lifted(floating, lid, 0.02);
        take(all, floating, 1.0 / 480, 480 * 4);
        Real late = 0;
        for (int n = 0; n < 480; ++n) {
            take(all, floating, 1.0 / 480, 1);
            late = std::max(late, std::abs(all.scene.bodies.x[1] - 1));
        }
        const Real outside = std::abs(all.water.level[all.water.cell_at(8)] - 1);
        INFO(lid);
        if (lid > 0) {
            CHECK(late < 1e-3);  // waves have taken its energy, nothing else can
            CHECK(outside < 1e-2);
        } else CHECK(late > 0.018);  // nothing takes it
    }
}

TEST_CASE("drag brakes a body against the water and never turns it round", "[idea]")
{
    for (const Real density : {1.0, 600.0}) {  // the light one would be turned round by an explicit step
        WaterScene all = pond(64, 16, 2);
        Floating floating;
        add_body(all.scene, disc(0.2), density, {0, 1});
        all.scene.gravity = {0, 0};
        all.water.g = 1e-9;
        all.scene.bodies.u[0] = 5;
        Real before = 5;
        for (int n = 0; n < 100; ++n) {
            floating.find(all.scene, all.water);
            floating.push(all.scene, all.water, 1.0 / 60);
            const Real now = all.scene.bodies.u[0];
            REQUIRE(now < before);
            REQUIRE(now > 0);
            before = now;
        }
        CHECK(before < 2.5);
    }
}

TEST_CASE("drag however long the step takes energy from bodies and water and gives them none", "[idea]")
{
    Random random(29);
    for (int run = 0; run < 400; ++run) {
        WaterScene all = pond(24, 6, 1);
        all.scene.gravity = {0, 0};
        all.water.g = 1e-300;  // drag alone
        for (Index i = 0; i < 24; ++i) all.water.depth[i] = i % 7 == run % 7 ? 0 : random.uniform(0.01, 2);
        level_water(all.water);
        for (Index f = 1; f < 24; ++f) all.water.u[f] = random.uniform(-5, 5);
        for (int k = 0; k < 3; ++k) {
            const Real x = random.uniform(-3.5, 3.5), y = random.uniform(0, 1.5);  // in a wall, too
            const Real width = random.uniform(0.05, 2), height = random.uniform(0.05, 2);
            const Index b = add_body(all.scene, box(width, height), random.uniform(1, 1000), {x, y});
            const Real u = random.uniform(-5, 5), v = random.uniform(-5, 5), spin = random.uniform(-20, 20);
            all.scene.bodies.velocity(b) = Vec<3>(u, v, spin);
        }
        Floating floating;
        floating.settings.drag = random.uniform(0, 100);
        floating.settings.friction = random.uniform(0, 100);
        floating.find(all.scene, all.water);
        const Real before = kinetic_energy(all);
        floating.push(all.scene, all.water, rigid::pow(10.0, random.uniform(-3, 3)));
        INFO("run " << run);
        CHECK(kinetic_energy(all) <= before * (1 + 1e-13));  // sums of thirty terms, twice
        if (!floating.edges.empty() && floating.settings.friction > 1)
            CHECK(kinetic_energy(all) < before * (1 - 1e-9));
    }
}

TEST_CASE("drag of a tip and in one cell and beside a wall gives no energy", "[idea]")
{
    // Each is where one term of (29.25), or half of an impulse, is needed: the arm, the edges that share a cell, the wall.
    const auto after_long_step = [](WaterScene& all) {
        all.scene.gravity = {0, 0};
        all.water.g = 1e-300;  // drag alone
        Floating floating;
        floating.settings.drag = floating.settings.friction = 100;
        floating.find(all.scene, all.water);
        REQUIRE_FALSE(floating.edges.empty());
        const Real before = kinetic_energy(all);
        floating.push(all.scene, all.water, 1000);
        return kinetic_energy(all) / before;
    };
    WaterScene tip =
        pond(24, 6, 0.2);  // an upright plank that turns about its middle, where its mass is; 0.1 m are wet
    add_body(tip.scene, box(0.05, 2), Mass{10, {0, 0}, 0.1}, {0.1, 1.1});
    tip.scene.bodies.velocity(0) = Vec<3>(0, 0, 10);
    CHECK(after_long_step(tip) < 1);

    WaterScene cell = pond(24, 6, 0.2);  // a heavy box with three edges against the water of one cell
    add_body(cell.scene, box(0.1, 0.1), 1e6, {0.125, 0.1});
    cell.scene.bodies.velocity(0) = Vec<3>(5, 0, 0);
    CHECK(after_long_step(cell) < 1);
    CHECK(cell.water.u.maxCoeff() < 5);

    WaterScene wall =
        pond(24, 6, 0.2);  // in the first cell, whose water moves at half the speed of its open face
    add_body(wall.scene, box(0.1, 0.1), 1e6, {-2.875, 0.1});
    wall.scene.bodies.velocity(0) = Vec<3>(3, 0, 0);
    wall.water.u[1] = 4;
    CHECK(after_long_step(wall) < 1);
}

TEST_CASE("drag in a mirror is drag mirrored", "[idea]")
{
    // a pond with two boxes, one turned and in the other's water; on the other side of x = 0 the same
    WaterScene all = pond(32, 8, 1), mirrored = pond(32, 8, 1);
    for (WaterScene* one : {&all, &mirrored}) {
        const Real side = one == &all ? 1 : -1;
        one->scene.gravity = {0, 0};
        for (const Real x : {0.4, 0.9}) {
            const Index b = add_body(one->scene, box(1, 0.5), 500, {side * x, 0.8});
            one->scene.bodies.position(b)[2] = side * x;
            one->scene.bodies.velocity(b) = Vec<3>(side * 3, -1, side * 4);
        }
    }
    Floating floating, beside;
    floating.settings.friction = beside.settings.friction = 1;
    floating.find(all.scene, all.water);
    beside.find(mirrored.scene, mirrored.water);
    floating.push(all.scene, all.water, 0.1);  // a long step: each edge feels what the others take
    beside.push(mirrored.scene, mirrored.water, 0.1);
    for (Index k = 0; k < 2; ++k) {
        const Vec<3> u = all.scene.bodies.velocity(k), v = mirrored.scene.bodies.velocity(k);
        CHECK((u - Vec<3>(-v[0], v[1], -v[2])).norm() < 1e-13);  // sums of some twenty edges
        CHECK((u - Vec<3>(3, -1, 4)).norm() > 0.1);
    }
}

TEST_CASE("what is under water is that of the shape a body has now", "[house]")
{
    WaterScene all = pond(80, 8, 1);
    const Index k = add_floating_box(all, 0.03, 0.5, 2, 0.5, 0);
    Floating floating, fresh;
    floating.find(all.scene, all.water);
    all.scene.shapes[static_cast<std::size_t>(k)] = box(2, 0.5);  // four corners as well
    ShallowWater same = all.water;
    floating.find(all.scene, all.water);
    fresh.find(all.scene, same);
    CHECK(floating.slices.size() == fresh.slices.size());
    CHECK(all.water.level == same.level);
    CHECK(floating.edges.size() == fresh.edges.size());
}

TEST_CASE("a body beyond the walls has no water on it", "[idea]")
{
    for (const Real x :
         {-10.0, 10.0, -4.3, 4.3}) {  // the walls are at -4 m and 4 m; the last two stand across one
        WaterScene all = pond(80, 8, 1);
        const Index k = add_body(all.scene, box(1, 1), 500.0, {x, 0.5});
        all.scene.bodies.velocity(k) << -3, 0, 0;
        Floating floating;
        floating.find(all.scene, all.water);
        for (const WetEdge& edge : floating.edges) CHECK(std::abs(edge.middle.x()) <= 4);
        CHECK(floating.edges.empty() == (std::abs(x) > 5));
        floating.push(all.scene, all.water, 0.01);
        if (std::abs(x) > 5) CHECK(all.scene.bodies.velocity(k) == Vec<3>(-3, 0, 0));
    }
}

TEST_CASE("a step that is too long below a hull is refused before the first as before any other", "[house]")
{
    WaterScene all = pond(80, 8, 1);
    add_floating_box(all, 0.03, 0.4, 10, 0.5, 0);
    Floating floating;
    floating.settings.lid = 0.95;
    const Real h = 0.9 * stable_step(all.water);  // without the hull it would do
    const VecX u = all.scene.bodies.u, depth = all.water.depth;
    const std::string said = sentence_of([&] { take(all, floating, h, 1); });
    CHECK(said.starts_with("the time step is " + shortest(h) + " s; a wave passes a whole cell in "));
    CHECK(all.scene.bodies.u == u);
    CHECK(all.water.depth == depth);
}

TEST_CASE("water moves alike in one window and in many after bodies have left it", "[house]")
{
    // as many columns as a window has, and more: the wave does not come so far
    for (const Index cells : {Index{100}, Index{2000}}) {
        ShallowWater used(cells, 0.1 * static_cast<Real>(cells), 1);
        used.depth.head(20).setConstant(1.5);
        ShallowWater plain = used;
        used.part.setConstant(0.5);
        for (int n = 0; n < 30; ++n) step(used, 0.01), step(plain, 0.01);
        CHECK(used.depth == plain.depth);
        CHECK(used.u == plain.u);
    }
}

TEST_CASE("water that was given more columns has room for them", "[house]")
{
    ShallowWater grown(4, 4, 1), made(8, 8, 1);
    for (VecX* const list : {&grown.bed, &grown.depth, &grown.level}) list->setZero(8);
    grown.u.setZero(9), grown.part.setOnes(9);
    grown.depth.setOnes(), made.depth[0] = grown.depth[0] = 1.2;
    step(grown, 0.05), step(made, 0.05);
    CHECK(grown.depth == made.depth);
    CHECK(grown.u == made.u);
}

TEST_CASE("a boat a raft and a duck float upright on waves", "[idea]")
{
    WaterScene all = pond(160, 20, 1.5);
    Floating floating;
    const Index boat = add_boat(all, -4), raft = add_raft(all, 1, 5), duck = add_duck(all, 6);
    floating.displace(all.scene, all.water);
    JointTrees<Manifolds> method;
    never_stop(method.contacts);
    StepData<3> now;
    Real most = 0, gap = 0;
    for (int n = 0; n < 1200; ++n) {
        all.water.u[0] = 0.5 * rigid::sin(2 * pi * n / 480.0);
        step(all.scene, all.water, floating, {.h = 1.0 / 240}, method, now);
        for (const Index k : {boat, raft, duck})
            most = std::max(most, std::abs(all.scene.bodies.x[3 * k + 2]));
        gap = std::max(gap, largest_joint_error(all.scene));
    }
    CHECK(most > 0.01);
    CHECK(most < 0.7);
    CHECK(gap < 1e-3);
    CHECK(all.scene.bodies.x.allFinite());
}

// ------------------------------------------------------------------------------------------------ house

TEST_CASE("the numbers of sections 29.D and 29.F are those of water and of a box on it", "[house]")
{
    struct Line {
        Index cells;
        std::array<Real, 3> errors;
    };
    const std::array<Real, 3> right{0, 0.1, 0.5};
    for (const auto& [cells, errors] : {Line{100, {0.1758, 0.1620, 0.0753}},
                                        {200, {0.1166, 0.0912, 0.0455}},
                                        {400, {0.0735, 0.0543, 0.0251}},
                                        {800, {0.0443, 0.0317, 0.0145}},
                                        {1600, {0.0259, 0.0181, 0.0087}}})
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(error_of_dam(broken_dam(cells, right[i]), right[i]) == Approx(errors[i]).margin(5.1e-5));

    for (const auto& [lid, swing] : {std::pair{0.0, 0.0100}, {0.5, 0.0056}, {0.8, 0.0044}}) {
        Floating floating;
        WaterScene all = box_lifted(floating, lid, 0.01);
        Real lowest = 0, late = 0;
        for (int n = 0; n < 960; ++n) {
            take(all, floating, 1.0 / 480, 1);
            const Real y = all.scene.bodies.x[1] - 1;
            if (n < 360) lowest = std::min(lowest, y);
            if (n >= 624) late = std::max(late, std::abs(y));  // 1.3 s
        }
        INFO(lid);
        CHECK(-lowest == Approx(swing).margin(1e-4));
        if (lid == 0.5) CHECK(late < 0.05 * 0.01);
        if (lid == 0) CHECK(late > 0.99 * 0.01);
    }
}

TEST_CASE("a step of water and bodies asks for no memory once it runs", "[house]")
{
    WaterScene all = pond(64, 8, 1);
    Floating floating;
    add_floating_box(all, 0.03, 0.5, 2, 0.6, 0.2);
    add_floating_box(all, 1.53, 0.5, 1, 0.6, 0.2);
    const auto one = [&] {
        floating.find(all.scene, all.water);
        floating.push(all.scene, all.water, 1.0 / 240);
        fall(all.scene, 1.0 / 240);
        carry_water(all.water, 1.0 / 240);
    };
    for (int n = 0; n < 200; ++n) one();
    int violations = 0;
    {
        const NoAllocation forbidden;
        for (int n = 0; n < 20; ++n) one();
        violations = NoAllocation::violations();
    }
    CHECK(violations == 0);
}

TEST_CASE("water and floating bodies that make no sense are refused by name", "[house]")
{
    CHECK(sentence_of([] { ShallowWater(1, 1, 1); }) == "the water has 1 cells; it must have two or more");
    CHECK(sentence_of([] { ShallowWater(4, 1, -1); }) ==
          "the depth of the water is -1 m; it must be zero or positive and finite");
    ShallowWater water(4, 4, 1);
    CHECK(sentence_of([&] { step(water, 1); }) ==
          "the time step is 1 s; a wave passes a whole cell in " + shortest(1 / std::sqrt(9.81)) + " s");
    const auto row = [](const auto& change, bool late) {
        ShallowWater w(4, 4, 1);
        if (late) step(w, 0.01);
        change(w);
        const VecX before = w.depth;
        const std::string said = sentence_of([&] { step(w, 0.01); });
        for (Index i = 0; i < w.cells(); ++i)  // nothing has moved
            CHECK((w.depth[i] == before[i] || std::isnan(before[i])));
        return said;
    };
    for (const bool late : {false, true}) {
        CHECK(row([](auto& w) { w.depth[3] = NAN; }, late) == "depth[3] is nan; it must be a finite number");
        CHECK(row([](auto& w) { w.depth[1] = -1; }, late) == "depth[1] is -1 m; it must be zero or positive");
        CHECK(row([](auto& w) { w.u[2] = infinity; }, late) == "u[2] is inf; it must be a finite number");
        CHECK(row([](auto& w) { w.u.conservativeResize(3); }, late) ==
              "u has 3 entries; water of 4 cells needs 5");
        CHECK(row([](auto& w) { w.dx = -1; }, late) ==
              "the width of a cell is -1 m; it must be positive and finite");
    }
    CHECK(row([](auto& w) { w.bed[1] = NAN; }, false) == "bed[1] is nan; it must be a finite number");
    const auto afloat = [](const auto& change) {
        WaterScene all = pond(16, 8, 1);
        Floating floating;
        add_floating_box(all, 0, 0.4, 2, 0.5, 0);
        change(all);
        const VecX u = all.scene.bodies.u;
        const std::string said = sentence_of([&] { take(all, floating, 0.01, 1); });
        CHECK(all.scene.bodies.u == u);
        return said;
    };
    CHECK(afloat([](auto& all) { all.water.depth[3] = -1; }) ==
          "depth[3] is -1 m; it must be zero or positive");
    CHECK(afloat([](auto& all) { all.scene.bodies.x[1] = NAN; }) ==
          "x[1] is nan; it must be a finite number");
    water.depth[2] = -1;
    CHECK(sentence_of([&] { require_valid(water); }) == "depth[2] is -1 m; it must be zero or positive");
    CHECK(
        sentence_of([] { dam_break(1, 2, 9.81, 0, 1); }).starts_with("a dam between depths of 1 m and 2 m"));
    CHECK(sentence_of([] { dam_break(1, 0, -9.81, 0, 1); }) ==
          "gravity is -9.81 m/s²; it must be positive and finite");
    CHECK(sentence_of([] { dam_break(1, 0.1, 9.81, NAN, 1); }) ==
          "a dam is looked at from x = nan m; it must be finite");
    CHECK(row([](auto& w) { w.depth.resize(0), w.bed = w.level = w.depth, w.u.resize(1), w.part.resize(1); },
              true) == "the water has 0 cells; it must have two or more");
    CHECK(sentence_of([] {
              WaterScene all = pond(80, 8, 1);
              add_raft(all, 0, 0);
          }) == "the raft has 0 planks; it must have one or more");
    CHECK(sentence_of([] { box_draught(1, 1.5); }) ==
          "the box has 1.5 of the water's density; it floats between 0 and 1");
    FloatSettings settings;
    settings.lid = 1;
    CHECK(sentence_of([&] { settings.require_valid(); }) ==
          "the part of a hull that lifts the surface is 1; it must be from 0 to 0.95");
    settings = {0.5, -1, 0};
    CHECK(sentence_of([&] { settings.require_valid(); }) ==
          "the drag is -1; it must be zero or positive and finite");
    WaterScene all = pond(16, 8, 0.2);
    add_body(all.scene, box(2, 2), 900.0, {0, 0.2});
    Floating floating;
    floating.settings.lid = 0.95;
    add_body(all.scene, box(0.2, 0.2), 900.0, {-3, 0.1});  // to the left of it, with water below
    const VecX depth = all.water.depth;
    CHECK(sentence_of([&] { floating.displace(all.scene, all.water); }).starts_with("bodies displace "));
    CHECK(all.water.depth == depth);
}
