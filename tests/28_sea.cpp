/// Chapter 28: shallow water in two directions, and solids afloat on it.

#include "tests/catch.hpp"
#include "tests/no_allocation.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

#include "chapters/25_world_in_space/space_method.hpp"
#include "chapters/28_waves/sea_scenes.hpp"
#include "chapters/28_waves/water_step.hpp"
#include "common/elementary.hpp"
#include "common/random.hpp"

using namespace rigid;

namespace {

/// A dam of radius 2 m breaks in a square of 10 m, ½ m of water around it; after 0.6 s, before anything comes to a wall.
ShallowGrid round_dam(Index cells)
{
    ShallowGrid water(cells, cells, 10 / static_cast<Real>(cells), 0.5);
    water.origin_x = water.origin_z = -5;
    const int parts = 8;  // a cell on the rim is filled as far as it lies within
    for (Index j = 0; j < cells; ++j)
        for (Index i = 0; i < cells; ++i) {
            int within = 0;
            for (int a = 0; a < parts; ++a)
                for (int b = 0; b < parts; ++b) {
                    const Real x = water.x_of(i) + water.dx * ((a + 0.5) / parts - 0.5),
                               z = water.z_of(j) + water.dx * ((b + 0.5) / parts - 0.5);
                    within += x * x + z * z < 4 ? 1 : 0;
                }
            water.depth[water.at(i, j)] += 0.5 * within / (parts * parts);
        }
    const auto steps = static_cast<int>(cells);
    for (int n = 0; n < steps; ++n) step(water, 0.6 / steps);
    return water;
}

void fall(SpaceScene& scene, Real h)
{
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        scene.bodies.velocity(k).head<3>() += h * scene.gravity;
        scene.bodies.integrate(k, Vec<6>(scene.bodies.velocity(k)), h);
    }
}

void take(SeaScene& all, SolidFloating& floating, Real h, int steps)
{
    for (int n = 0; n < steps; ++n) {
        floating.find(all.scene, all.water);
        floating.push(all.scene, all.water, h);
        fall(all.scene, h);
        carry_water(all.water, h);
    }
}

Vec2 whole_momentum(const SeaScene& all)
{
    Vec2 sum = momentum(all.water);
    for (Index k = 0; k < all.scene.bodies.count(); ++k)
        sum += Vec2(all.scene.bodies.u[6 * k], all.scene.bodies.u[6 * k + 2]) /
               all.scene.bodies.inverse_mass[6 * k];
    return sum;
}

/// The angle that body k has turned from upright, of a body whose axes were those of the world.
Real lean(const SeaScene& all, Index k)
{
    const Mat3 R = rotation_of(all.scene.bodies.x, k);
    return pi / 2 - rigid::asin(std::clamp(R(1, 1), -1.0, 1.0));
}

}  // namespace

// ------------------------------------------------------------------------------------------------ water alone

TEST_CASE("water in two directions that is the same across one of them is the water of a line to the bit",
          "[idea]")
{
    Random random(3);
    const Index n = 40;
    ShallowWater line(n, 4, 0);
    ShallowGrid along(n, 5, line.dx, 0), across(5, n, line.dx, 0);
    for (Index i = 0; i < n; ++i) {
        line.bed[i] = 0.4 * random.uniform();
        line.depth[i] = i > 25 ? 0 : random.uniform();  // and a shore
        for (Index j = 0; j < 5; ++j) {
            along.bed[along.at(i, j)] = across.bed[across.at(j, i)] = line.bed[i];
            along.depth[along.at(i, j)] = across.depth[across.at(j, i)] = line.depth[i];
        }
    }
    for (int k = 0; k < 200; ++k) step(line, 0.01), step(along, 0.01), step(across, 0.01);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < 5; ++j) {
            REQUIRE(along.depth[along.at(i, j)] == line.depth[i]);
            REQUIRE(across.depth[across.at(j, i)] == line.depth[i]);
            REQUIRE(along.u[along.face_x(i, j)] == line.u[i]);
            REQUIRE(across.w[across.face_z(j, i)] == line.u[i]);
        }
}

TEST_CASE("one pass through the rows is a push and a carry to the bit", "[house]")
{
    Random random(4);
    ShallowGrid one(13, 9, 0.1, 0), two = one;
    for (Index c = 0; c < one.depth.size(); ++c)
        one.bed[c] = two.bed[c] = random.uniform(), one.depth[c] = two.depth[c] = random.uniform();
    for (int n = 0; n < 100; ++n) {
        step(one, 0.005);
        push_water(two, 0.005);
        carry_water(two, 0.005);
        REQUIRE(one.depth == two.depth);
        REQUIRE(one.u == two.u);
        REQUIRE(one.w == two.w);
    }
}

TEST_CASE("a lake at rest stays at rest around islands and moving water keeps its mass over a hundred "
          "thousand steps",
          "[idea]")
{
    Random random(5);
    ShallowGrid rest(12, 9, 0.1, 0), moving = rest;
    for (Index j = 0; j < 9; ++j)
        for (Index i = 0; i < 12; ++i) {
            const Index c = rest.at(i, j);
            const Real x = rest.x_of(i) - 0.6, z = rest.z_of(j) - 0.45;
            rest.bed[c] = moving.bed[c] = 1.4 * rigid::exp(-8 * (x * x + z * z)) + 0.1 * random.uniform();
            rest.depth[c] = std::max(0.0, 1 - rest.bed[c]);
            moving.depth[c] = rest.depth[c] > 0 ? rest.depth[c] + 0.2 * random.uniform() : 0;
        }
    const Real at_rest = volume(rest), in_motion = volume(moving);
    Real least = 1;
    for (int n = 0; n < 100000; ++n) {
        step(rest, 0.01);
        step(moving, 0.01);
        least = std::min(least, moving.depth.minCoeff());
    }
    // as along a line: a rounding of a level makes a speed of 1e-16 m/s a step
    CHECK(rest.u.cwiseAbs().maxCoeff() < 1e-11);
    CHECK(rest.w.cwiseAbs().maxCoeff() < 1e-11);
    CHECK(volume(rest) == Approx(at_rest).epsilon(1e-12));
    CHECK(volume(moving) == Approx(in_motion).epsilon(1e-12));
    CHECK(least >= 0);
}

TEST_CASE("water in two directions over a level bed keeps both momenta to rounding", "[idea]")
{
    Random random(7);
    ShallowGrid water(80, 80, 0.1, 1);
    for (Index j = 30; j < 50; ++j)
        for (Index i = 30; i < 50; ++i) {
            water.depth[water.at(i, j)] += 0.5 * random.uniform();
            water.u[water.face_x(i, j)] = random.uniform();
            water.w[water.face_z(i, j)] = -random.uniform();
        }
    const Vec2 start = momentum(water);
    for (int n = 0; n < 28; ++n) step(water, 0.01);  // nothing has come to the walls
    for (Index k = 0; k < 80; ++k) {
        REQUIRE(water.depth[water.at(0, k)] == 1);
        REQUIRE(water.depth[water.at(k, 79)] == 1);
    }
    CHECK(start.x() > 100);
    CHECK(momentum(water).x() == Approx(start.x()).epsilon(1e-11));  // 28 steps, 6400 cells of 98 N a face
    CHECK(momentum(water).y() == Approx(start.y()).epsilon(1e-11));
}

TEST_CASE("a round dam break tends to that of rings and is as round", "[idea]")
{
    // rings ten times as fine as the finest squares
    RadialWater rings(2000, 5, 0.5);
    for (Index i = 0; i < 2000; ++i)
        if (rings.radius_of(i) < 2) rings.depth[i] = 1;
    for (int n = 0; n < 2000; ++n) step(rings, 0.6 / 2000);
    std::vector<Real> errors;
    for (const Index n : {50, 100, 200}) {
        const ShallowGrid water = round_dam(n);
        Real sum = 0;
        for (Index j = 0; j < n; ++j)
            for (Index i = 0; i < n; ++i) {
                const Real x = water.x_of(i), z = water.z_of(j), s = std::sqrt(x * x + z * z);
                if (!(s < 4.9)) continue;
                sum += water.dx * water.dx *
                       std::abs(water.depth[water.at(i, j)] - rings.depth[static_cast<Index>(s / rings.dr)]);
            }
        errors.push_back(sum);
    }
    // the first order at best, as along a line: a bore lies between two cells
    CHECK(order_of(errors) == Approx(0.75).margin(0.2));
    CHECK(errors.back() < 0.3);
    const ShallowGrid water = round_dam(100);
    for (Index i = 0; i < 100; ++i)
        for (Index j = 0; j < 100; ++j) {
            REQUIRE(std::abs(water.depth[water.at(i, j)] - water.depth[water.at(j, i)]) < 1e-12);
            REQUIRE(std::abs(water.depth[water.at(i, j)] - water.depth[water.at(99 - i, j)]) < 1e-12);
        }
}

TEST_CASE("a mode of a square tank swings in leapfrog's time with the frequency of its grid", "[idea]")
{
    const Index nx = 24, nz = 16;
    const Real dx = 1.0 / 24, a = 1e-7, h = 0.3 * dx;
    ShallowGrid water(nx, nz, dx, 1);
    water.g = 1;
    const Real kx = 3 * pi, kz = 2 * pi / (16.0 / 24);
    for (Index j = 0; j < nz; ++j)
        for (Index i = 0; i < nx; ++i)
            water.depth[water.at(i, j)] +=
                a * rigid::cos(kx * water.x_of(i)) * rigid::cos(kz * water.z_of(j));
    for (Index j = 0; j < nz; ++j)
        for (Index i = 0; i < nx; ++i) {
            const Index c = water.at(i, j);
            if (i > 0) water.u[water.face_x(i, j)] = h / 2 * (water.depth[c] - water.depth[c - 1]) / dx;
            if (j > 0) water.w[water.face_z(i, j)] = h / 2 * (water.depth[c] - water.depth[c - nx]) / dx;
        }
    const Real sx = rigid::sin(kx * dx / 2), sz = rigid::sin(kz * dx / 2);
    const Real omega = 2 / h * rigid::asin(h / dx * std::sqrt(sx * sx + sz * sz));
    const Index watched = water.at(1, 1);
    const Real start = water.depth[watched] - 1;
    for (int n = 1; n <= 200; ++n) {
        step(water, h);
        // the square of the amplitude, times the radians that it went
        REQUIRE(std::abs(water.depth[watched] - 1 - start * rigid::cos(omega * h * n)) < a * a * 60);
    }
    // and that is the tank's, πc √((p/a)² + (q/b)²), to a hundredth
    CHECK(omega == Approx(std::sqrt(kx * kx + kz * kz)).epsilon(0.03));
}

TEST_CASE("water of any depths in two directions never becomes negative or infinite", "[idea]")
{
    Random random(8);
    for (int round = 0; round < 20; ++round) {
        const Real size = rigid::pow(10.0, random.uniform(-3, 3));
        ShallowGrid water(11, 14, size, 0);
        for (Index c = 0; c < water.depth.size(); ++c) {
            water.bed[c] = size * random.uniform(0, 2);
            water.depth[c] = random.uniform() < 0.3 ? 0 : size * random.uniform();
        }
        for (Index j = 0; j < 14; ++j)
            for (Index i = 1; i < 11; ++i)
                water.u[water.face_x(i, j)] = std::sqrt(9.81 * size) * random.uniform(-2, 2);
        for (Index j = 1; j < 14; ++j)
            for (Index i = 0; i < 11; ++i)
                water.w[water.face_z(i, j)] = std::sqrt(9.81 * size) * random.uniform(-2, 2);
        const Real whole = volume(water);
        for (int n = 0; n < 200; ++n) step(water, 0.9 * stable_step(water));
        CHECK(water.depth.minCoeff() >= 0);
        CHECK(water.depth.allFinite());
        CHECK(water.u.allFinite());
        CHECK(volume(water) == Approx(whole).epsilon(1e-12));
    }
}

// ------------------------------------------------------------------------------------------------ Archimedes in space

TEST_CASE("the part of a solid below a level has its volume centroid and waterline", "[idea]")
{
    const Hull box = solid_box({1, 2, 3});
    const SubmergedSolid part = submerged(box, {0, 0, 0}, Mat3::Identity(), 0.5);
    CHECK(part.volume == Approx(4.5).epsilon(1e-14));
    CHECK(part.centroid.y() == Approx(-0.25).epsilon(1e-14));
    CHECK(part.area == Approx(3).epsilon(1e-14));
    Random random(9);
    for (int n = 0; n < 100; ++n) {
        const Vec3 turn(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)),
            at(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5));
        const Mat3 R = rotation_matrix(turn);
        // a box is its own image in its centre, so any plane through it leaves half
        const SubmergedSolid half = submerged(box, at, R, at.y()), whole = submerged(box, at, R, at.y() + 5);
        CHECK(half.volume == Approx(3).epsilon(1e-13));
        CHECK((half.middle - at).norm() < 1e-13);
        CHECK(whole.volume == Approx(6).epsilon(1e-13));
        CHECK((whole.centroid - at).norm() < 1e-12);
        // the waterline is what the volume grows by; with 2e-4 its change is of the second order
        const Real more =
            submerged(box, at, R, at.y() + 0.3001).volume - submerged(box, at, R, at.y() + 0.2999).volume;
        CHECK(submerged(box, at, R, at.y() + 0.3).area == Approx(more / 2e-4).epsilon(1e-4));
    }
}

TEST_CASE("columns cut a solid into parts of the whole", "[house]")
{
    SeaScene all = sea(20, 4, 1);
    SolidFloating floating;
    floating.settings.displace = false;
    add_body(all.scene, {solid_box({1.1, 0.7, 0.9})}, 500.0, {0.123, 1.05, -0.2}, {0.4, 0.9, -0.3});
    floating.find(all.scene, all.water);
    const SubmergedSolid whole = submerged(all.scene.shapes[0][0], centre_of(all.scene.bodies.x, 0),
                                           rotation_of(all.scene.bodies.x, 0), 1);
    Real volume = 0, area = 0;
    Vec3 moment(0, 0, 0);
    for (const SolidSlice& s : floating.slices) {
        volume += s.below.volume, area += s.below.area;
        moment += s.below.volume * s.below.centroid;
    }
    CHECK(floating.slices.size() > 20);
    CHECK(volume == Approx(whole.volume).epsilon(1e-12));
    CHECK(area == Approx(whole.area).epsilon(1e-12));
    CHECK((moment / volume - whole.centroid).norm() < 1e-12);
}

TEST_CASE("a solid heaves with the frequency of its waterline", "[idea]")
{
    SeaScene all = sea(12, 6, 2);
    SolidFloating floating;
    floating.settings = {false, 0, 0};
    add_floating_box(all, {0.1, 0, 0.2}, {1, 0.5, 1.4}, 0.6, 0);
    const Real rest = all.scene.bodies.x[1], a = 0.05, h = 1.0 / 120;
    const Real omega = std::sqrt(9.81 / box_draught(0.5, 0.6)), slowed = 2 / h * rigid::asin(omega * h / 2);
    CHECK(rest == Approx(2 - 0.3 + 0.25).epsilon(1e-15));
    all.scene.bodies.x[1] += a;
    all.scene.bodies.u[1] = h / 2 * omega * omega * a;
    for (int n = 1; n <= 500; ++n) {
        floating.find(all.scene, all.water);
        floating.push(all.scene, all.water, h);
        fall(all.scene, h);
        // sums over some forty columns
        REQUIRE(std::abs(all.scene.bodies.x[1] - rest - a * rigid::cos(slowed * h * n)) < 1e-11);
    }
}

TEST_CASE("the solid with the metacentre below its centre capsizes and the other one stays upright in space",
          "[idea]")
{
    for (const Real ratio : {1.2, 1.25}) {
        SeaScene all = sea(16, 4, 1);
        SolidFloating floating;
        add_floating_box(all, {0.013, 0, 0.027}, {0.5 * ratio, 0.5, 1.3}, 0.5, 0.02);
        floating.displace(all.scene, all.water);
        Real most = 0;
        for (int n = 0; n < 840; ++n) {
            take(all, floating, 1.0 / 60, 1);
            most = std::max(most, lean(all, 0));
        }
        INFO(ratio);
        if (box_metacentric_height(ratio, 1, 0.5) < 0) CHECK(most > 0.1);
        else CHECK(most < 0.021);  // of 0.02 at the start
    }
}

TEST_CASE("water and solids keep the momenta of both and the water its volume to rounding", "[idea]")
{
    SeaScene all = sea(80, 16, 1);
    SolidFloating floating;
    add_floating_box(all, {0, 0, 0.3}, {1, 0.5, 1.3}, 0.6, 0.3);
    add_floating_box(all, {1.5, 0, -0.4}, {0.8, 0.6, 0.7}, 0.5, 0.2);
    floating.displace(all.scene, all.water);
    all.scene.bodies.u[0] = 1, all.scene.bodies.u[2] = -0.6, all.scene.bodies.u[7] = -0.5;
    const Vec2 start = whole_momentum(all);
    const Real whole = volume(all.water);
    take(all, floating, 1.0 / 120, 30);
    REQUIRE(all.water.depth[0] == 1);
    CHECK(start.x() > 100);
    // rounding of 6400 columns, each of which a face pushes with 2e3 N: 30 steps
    CHECK((whole_momentum(all) - start).norm() < 1e-9 * start.norm());
    CHECK(volume(all.water) == Approx(whole).epsilon(1e-13));
    CHECK(std::abs(all.scene.bodies.u[0] - 1) > 0.05);  // and something was exchanged
}

TEST_CASE("a solid at rest makes no waves and one that is dropped in raises the level by what it displaces",
          "[idea]")
{
    SeaScene all = sea(24, 4, 1);
    SolidFloating floating;
    add_floating_box(all, {0.1, 0, 0}, {0.9, 0.4, 1.1}, 0.5, 0);
    floating.displace(all.scene, all.water);
    take(all, floating, 1.0 / 120, 120);
    CHECK(all.water.u.cwiseAbs().maxCoeff() < 1e-11);  // rounding of levels, as along a line
    CHECK(std::abs(all.scene.bodies.x[1] - 1) < 1e-11);

    SeaScene dropped = sea(16, 4, 1);
    SolidFloating other;
    other.settings.drag = 0;
    add_floating_box(dropped, {0.1, 0, 0}, {0.9, 0.4, 1.1}, 0.5, 0);
    dropped.scene.bodies.x[1] += 0.3;
    other.displace(dropped.scene, dropped.water);
    take(dropped, other, 1.0 / 60, 900);
    // Archimedes in a vessel: the level has risen by V over the area, and the box with it
    const Real rise = 0.9 * 0.2 * 1.1 / 16;
    CHECK(volume(dropped.water) == Approx(16).epsilon(1e-12));
    CHECK(dropped.scene.bodies.x[1] == Approx(1 + rise).margin(0.05));  // it still heaves: no wave leaves the vessel
}

TEST_CASE("a boat a duck and a raft on ball joints ride a wave upright", "[idea]")
{
    SeaScene all = sea(36, 12, 1.2);
    SolidFloating floating;
    const Index boat = add_boat(all, -2, 1), duck = add_duck(all, 2, 2);
    add_raft(all, 1.5, -2, 2, 2);
    floating.displace(all.scene, all.water);
    add_mound(all.water, -5, 0, 2, 0.3);
    const Vec3 boat_up = rotation_of(all.scene.bodies.x, boat).transpose() * Vec3(0, 1, 0),
               duck_up = rotation_of(all.scene.bodies.x, duck).transpose() * Vec3(0, 1, 0);
    TouchingBoxes method;
    StepData<6> now;
    Real least = 1, gap = 0, most = 0;
    for (int n = 0; n < 250; ++n) {
        step(all.scene, all.water, floating, {.h = 0.02}, method, now);
        least = std::min({least, (rotation_of(all.scene.bodies.x, boat) * boat_up).y(),
                          (rotation_of(all.scene.bodies.x, duck) * duck_up).y()});
        most = std::max(most, std::abs(all.scene.bodies.u[6 * boat + 1]));
        for (const SpaceJoint& joint : all.scene.joints)
            gap = std::max(gap, (point_of_solid(all.scene.bodies.x, joint.a, joint.at_a) -
                                 point_of_solid(all.scene.bodies.x, joint.b, joint.at_b))
                                    .norm());
    }
    CHECK(least > 0.8);
    CHECK(most > 0.05);  // they ride
    CHECK(most < 2);
    CHECK(gap < 0.01);
}

// ------------------------------------------------------------------------------------------------ house

TEST_CASE("a step of water and solids asks for no memory once it runs", "[house]")
{
    SeaScene all = sea(24, 6, 1);
    SolidFloating floating;
    add_floating_box(all, {0, 0, 0.3}, {1, 0.5, 1.3}, 0.6, 0.3);
    floating.displace(all.scene, all.water);
    take(all, floating, 0.01, 200);
    int violations = 0;
    {
        const NoAllocation forbidden;
        take(all, floating, 0.01, 20);
        step(all.water, 0.01);
        violations = NoAllocation::violations();
    }
    CHECK(violations == 0);
}

TEST_CASE("water in two directions and solids that make no sense are refused by name", "[house]")
{
    CHECK(sentence_of([] { ShallowGrid(1, 3, 1, 1); }) ==
          "the water has 1 by 3 cells; it must have two or more each way");
    CHECK(sentence_of([] { ShallowGrid(3, 3, 1, -1); }) ==
          "the depth of the water is -1 m; it must be zero or positive and finite");
    CHECK(sentence_of([] { ShallowGrid(3, 3, 0, 1); }) ==
          "the side of a cell is 0 m; it must be positive and finite");
    ShallowGrid water(3, 3, 1, 1);
    CHECK(sentence_of([&] { step(water, 1); }) ==
          "the time step is 1 s; water and waves pass as much of a cell as is stable in " +
              shortest(1 / std::sqrt(2 * 9.81)) + " s");
    water.depth[4] = -1;
    CHECK(sentence_of([&] { require_valid(water); }) == "depth[4] is -1 m; it must be zero or positive");
    CHECK(sentence_of([] { RadialWater(1, 1, 1); }).starts_with("1 rings of water have the radius 1 m"));
    SeaScene all = sea(8, 4, 1);
    add_body(all.scene, {solid_ball(0.2)}, 500.0, {0, 1, 0});
    SolidFloating floating;
    CHECK(sentence_of([&] { floating.find(all.scene, all.water); }) ==
          "body 0 has a hull of the radius 0.2 m; only hulls with flat faces float");
    SeaScene low = sea(8, 4, 0.2);
    add_body(low.scene, {solid_box({2, 2, 2})}, 900.0, {0, 0.2, 0});
    CHECK(sentence_of([&] { floating.displace(low.scene, low.water); }).starts_with("solids displace "));
}
