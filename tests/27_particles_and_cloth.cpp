// Chapter 27: the closed forms of particles and cloth.
#include "chapters/27_particles_and_cloth/program/strips.hpp"
#include "tests/cloths.hpp"
#include "tests/eigenvalues.hpp"
#include "tests/order.hpp"

using namespace rigid;

namespace {

/// Masses and springs in a row along x, pinned at both ends.
ClothScene pinned_row(int masses, Real k = 1)
{
    ClothScene cloth;
    cloth.gravity.setZero();
    for (int i = 0; i <= masses + 1; ++i) {
        add_particle(cloth, {static_cast<Real>(i), 0, 0}, i == 0 || i == masses + 1 ? 0 : 1);
        if (i > 0) cloth.springs.push_back({i - 1, i, 1, k});
    }
    return cloth;
}

/// How far both masses of the example by hand have come down in one step [m].
Vec2 by_hand(ClothMethod method, int sweeps, bool keep = true)
{
    ClothScene cloth = hung_masses(2, 100);
    ClothMemory memory;
    ClothSettings how;
    how.h = 0.1, how.method = method, how.sweeps = sweeps, how.keep_lambda = keep;
    step(cloth, how, memory);
    return {-cloth.bodies.x[4] - 1, -cloth.bodies.x[7] - 2};
}

}  // namespace

TEST_CASE("three masses and two springs by hand have the numbers of the text by each method", "[idea]")
{
    const auto is = [](const Vec2& found, Real first, Real second) {
        // the numbers are fractions; what is left is rounding of x near 2 m
        CHECK(found.x() == Approx(first).margin(1e-14));
        CHECK(found.y() == Approx(second).margin(1e-14));
    };
    using M = ClothMethod;
    is(by_hand(M::explicit_euler, 0), 0.1, 0.1);
    is(by_hand(M::pbd, 1), 0.05, 0.05);
    is(by_hand(M::xpbd, 1), 1.0 / 15, 1.0 / 12);
    is(by_hand(M::xpbd, 2), 11.0 / 180, 29.0 / 360);
    is(by_hand(M::particles, 1), 1.0 / 15, 0.1);  // by colours, so the lower mass first
    is(by_hand(M::particles, 2), 11.0 / 180, 1.0 / 12);
    is(by_hand(M::threads, 1), 0.06, 0.08);
    is(by_hand(M::projective, 1), 0.06, 0.08);
    is(by_hand(M::newton, 1), 0.06, 0.08);
    is(by_hand(M::exact, 1), 0.06, 0.08);
    is(by_hand(M::midpoint, 1), 0.3 / 7.25, 0.35 / 7.25);
    const Vec2 linear = by_hand(M::implicit_euler, 1);  // by conjugate gradients, to a thousandth
    CHECK(linear.x() == Approx(0.06).epsilon(1e-3));
    CHECK(linear.y() == Approx(0.08).epsilon(1e-3));
}

TEST_CASE("sweeps that keep their impulses converge and those that forget them get stiffer", "[idea]")
{
    CHECK((by_hand(ClothMethod::xpbd, 60) - Vec2(0.06, 0.08)).norm() < 1e-15);
    const Vec2 twenty = by_hand(ClothMethod::xpbd, 20, false);
    CHECK(1000 * twenty.x() == Approx(0.7).margin(0.05));  // as the text prints it
    CHECK(1000 * twenty.y() == Approx(0.9).margin(0.05));
    CHECK(by_hand(ClothMethod::xpbd, 200, false).norm() < 1e-15);
    CHECK(by_hand(ClothMethod::pbd, 200).norm() < 1e-15);
}

TEST_CASE("a spring keeps the part of its energy that (27.7) says by every implicit method", "[idea]")
{
    using M = ClothMethod;
    for (const M method : {M::newton, M::exact, M::xpbd, M::threads, M::particles, M::projective,
                           M::implicit_euler, M::midpoint})
        for (const Real h : {0.01, 0.1, 1.0}) {
            ClothScene cloth;
            cloth.gravity.setZero();
            add_particle(cloth, {0, 0, 0}, 0);
            add_particle(cloth, {1.1, 0, 0}, 2);
            cloth.springs.push_back({0, 1, 1, 50});
            cloth.bodies.u[3] = 0.3;
            const Real before = energy(cloth);
            one_step(cloth, method, h);
            CAPTURE(to_string(method), h);
            // rounding of x near 1 m under k x²: 1e-16 · 50 · 0.1 of 0.3 J
            CHECK(energy(cloth) / before ==
                  Approx(method == M::midpoint ? 1 : 1 / (1 + h * h * 25)).epsilon(1e-12));
        }
}

TEST_CASE("nine masses between walls have the frequencies of the discrete string", "[idea]")
{
    const VecX square = symmetric_eigenvalues(stiffness_along(pinned_row(9), {1, 0, 0}, 0.25));
    for (int k = 1; k <= 9; ++k)  // the springs are linear along their line: rounding alone
        CHECK(std::sqrt(square[k - 1]) == Approx(2 * rigid::sin(k * pi / 20)).epsilon(1e-12));
    CHECK(std::sqrt(square[0]) == Approx(0.3128689300804617).epsilon(1e-12));
    CHECK(std::sqrt(square[1]) == Approx(0.6180339887498948).epsilon(1e-12));
    CHECK(std::sqrt(square[2]) == Approx(0.9079809994790936).epsilon(1e-12));
}

TEST_CASE("a mode under the explicit step turns by the angle of (27.3) and explodes beyond its limit",
          "[idea]")
{
    for (const int mode : {1, 4, 9}) {
        const Real omega = 2 * rigid::sin(mode * pi / 20), h = 0.9;
        ClothScene cloth = pinned_row(9);
        for (int i = 1; i <= 9; ++i) cloth.bodies.x[3 * i] += 0.01 * rigid::sin(mode * pi * i / 10);
        ClothMemory memory;
        ClothSettings how;
        how.h = h, how.method = ClothMethod::explicit_euler;
        const Real twice_cosine = 2 - h * h * omega * omega;  // sin φ/2 = hω/2
        VecX older = cloth.bodies.x, old = older;
        const VecX rest = pinned_row(9).bodies.x;
        for (int n = 0; n < 50; ++n) {
            step(cloth, how, memory);
            if (n > 0) {
                const VecX left = (cloth.bodies.x - rest) - twice_cosine * (old - rest) + (older - rest);
                CHECK(left.cwiseAbs().maxCoeff() < 1e-13);  // rounding of x near 10, of four terms
            }
            older = old, old = cloth.bodies.x;
        }
    }
    const Real limit = 2 / (2 * rigid::sin(9 * pi / 20));
    for (const Real part : {0.99, 1.01}) {
        ClothScene cloth = pinned_row(9);
        for (int i = 1; i <= 9; ++i) cloth.bodies.x[3 * i] += 1e-6 * rigid::sin(9 * pi * i / 10);
        ClothMemory memory;
        ClothSettings how;
        how.h = part * limit, how.method = ClothMethod::explicit_euler;
        for (int n = 0; n < 40; ++n) step(cloth, how, memory);
        const Real off = (cloth.bodies.x - pinned_row(9).bodies.x).cwiseAbs().maxCoeff();
        // below: 1/√(1 − part²) of the start at most; above: e^{40 arcosh …} = e^{11}
        if (part < 1) CHECK(off < 1e-5);
        else CHECK(off > 1e-3);
    }
}

TEST_CASE("a hanging chain swings as its Bessel function says with the square of its links", "[idea]")
{
    const Real zero[]{2.404825557695773, 5.520078110286311, 8.653727912911012};
    std::vector<Real> errors[3];
    for (const int n : {20, 40, 80}) {
        ClothScene cloth;
        RopeSpec rope;
        rope.segments = n, rope.stiffness = 1e6;
        add_rope(cloth, {0, 0, 0}, {0, -1, 0}, rope);
        pin(cloth, 0);
        settle(cloth);
        // 1e-8 m across: what stretches by its square pulls 1e-7 of the rope's weight
        const VecX square = symmetric_eigenvalues(stiffness_along(cloth, {0, 0, 1}, 1e-8));
        for (int k = 0; k < 3; ++k)
            errors[k].push_back(std::sqrt(square[k]) / (zero[k] / 2 * std::sqrt(9.81)) - 1);
    }
    for (int k = 0; k < 3; ++k) {
        CAPTURE(k);
        CHECK(std::abs(errors[k].back()) < 3e-3);
        CHECK(order_of(errors[k]) == Approx(2).margin(0.15));
    }
}

TEST_CASE("a chain hangs in the discrete catenary and that in the catenary with the square of its links",
          "[idea]")
{
    // between pins 1.2 m apart, 1.5 m long: sinh(d)/d = 1.25 with d = 0.6/a
    const auto cosh = [](Real x) { return (rigid::exp(x) + rigid::exp(-x)) / 2; };
    const auto sinh = [](Real x) { return (rigid::exp(x) - rigid::exp(-x)) / 2; };
    Real d = 2;
    for (int i = 0; i < 50; ++i) d -= (sinh(d) - 1.25 * d) / (cosh(d) - 1.25);
    const Real sag = 0.6 / d * (cosh(d) - 1);
    std::vector<Real> errors;
    for (const int n : {10, 20, 40}) {
        ClothScene cloth;
        RopeSpec rope;
        rope.segments = n, rope.stiffness = 1e7;  // stretched by a millionth
        add_rope(cloth, {-0.75, 0, 0}, {0.75, 0, 0}, rope);
        // from a shallow arc to its place
        for (int i = 0; i <= n; ++i) {
            const Real s = Real(i) / n * 2 - 1;
            cloth.bodies.position(i) << 0.6 * s, 0.4 * (s * s - 1), 0;
        }
        pin(cloth, 0), pin(cloth, n);
        settle(cloth);
        // (27.26): slopes grow by one weight over the horizontal pull, link by link
        std::vector<Real> slope;
        for (int i = 0; i < n; ++i) {
            const Vec3 e = cloth.bodies.position(i + 1) - cloth.bodies.position(i);
            slope.push_back(e.y() / e.x());
        }
        for (std::size_t i = 2; i < slope.size(); ++i)
            CHECK(slope[i] - slope[i - 1] == Approx(slope[1] - slope[0]).epsilon(1e-6));
        errors.push_back(std::abs(-cloth.bodies.position(n / 2).y() - sag));
    }
    CHECK(order_of(errors) == Approx(2).margin(0.15));
}

TEST_CASE("a rope and a cloth stretch under their own weight as (27.2) says", "[idea]")
{
    ClothScene rope;
    RopeSpec spec;
    spec.segments = 20, spec.mass = 2, spec.stiffness = 500;
    add_rope(rope, {0, 0, 0}, {0, -1, 0}, spec);
    pin(rope, 0);
    settle(rope);
    // half masses at the ends: the sum is the integral ρ g L²/2E exactly
    CHECK(-rope.bodies.x[61] - 1 == Approx(2 * 9.81 / (2 * 500)).epsilon(1e-11));

    ClothScene cloth;
    SheetSpec sheet;
    sheet.columns = sheet.rows = 10, sheet.spacing = 0.1, sheet.stiffness = 100, sheet.shear = 1e-6;
    add_sheet(cloth, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}, sheet);
    for (int i = 0; i <= 10; ++i) pin(cloth, i);
    settle(cloth);
    // threads at the sides carry half of a square and stretch half as much: ρ g L² d/(2 k d) with d = L/10
    for (const int i : {0, 5})
        CHECK(-cloth.bodies.x[3 * (i + 110) + 1] - 1 ==
              Approx((i == 0 ? 0.5 : 1) * 0.2 * 9.81 / (2 * 100))
                  .epsilon(1e-5));  // the diagonals' 1e-8 of k, times 100
}

TEST_CASE("a strip bends as the elastica under an end load and under its weight", "[idea]")
{
    struct Case {
        bool end;
        Real load, x, y;
    };
    const Case cases[]{
        {true, 1, 0.943566763717, 0.301720773800},  {true, 5, 0.612371639276, 0.713791523612},
        {true, 10, 0.445004402246, 0.810609024880}, {false, 1, 0.991246395347, 0.123471401983},
        {false, 5, 0.846657179954, 0.495905044622}, {false, 10, 0.656353761239, 0.700199715514}};
    for (const Case& one : cases) {
        std::vector<Real> errors;
        for (const int n : {10, 20, 40}) {
            ClothScene strip = clamped_strip(n);
            if (one.end) strip.bodies.f.segment<3>(3 * n) << 0, -one.load, 0;
            else strip.gravity = {0, -one.load, 0};
            settle(strip);
            const Vec3 tip = strip.bodies.position(n);
            errors.push_back(Vec2(tip.x() - one.x, -tip.y() - one.y).norm());
        }
        CAPTURE(one.end, one.load);
        CHECK(errors.back() < 2e-3);
        CHECK(order_of(errors) == Approx(2).margin(0.15));
    }
}

TEST_CASE(
    "a strip of squares bends as the elastica by lines and by angles and a strip of triangles is softer",
    "[idea]")
{
    const auto tip = [](int n, Bending how, bool alternate, Real diagonals, Real load) -> Vec2 {
        ClothScene strip = clamped_strip(n, 2, how, alternate, diagonals);
        strip.gravity = {0, -load, 0};
        settle(strip);
        const Vec3 p = strip.bodies.position(n + 1 + (n + 2));  // in the middle of its end
        return {p.x(), -p.y()};
    };
    const Vec2 exact(0.846657179954, 0.495905044622);
    const auto order = [&](Bending how, bool alternate, Real diagonals) {
        std::vector<Real> errors;
        for (const int n : {6, 12, 24})
            errors.push_back((tip(n, how, alternate, diagonals, 5) - exact).norm());
        return order_of(errors);
    };
    CHECK(order(Bending::quadratic, true, 1) == Approx(2).margin(0.15));
    CHECK(order(Bending::angle, true, 1e4) == Approx(2).margin(0.15));  // squares that do not twist
    // the same B about all edges: what is lost does not come back with finer squares
    for (const bool alternate : {false, true})
        for (const int n : {16, 24}) {
            const Vec2 found = tip(n, Bending::angle, alternate, 1, 5);
            CAPTURE(alternate, n, found.x(), found.y());
            CHECK(found.y() - exact.y() > 0.05);
        }
}

TEST_CASE("the elastica that strips are held to has the ends of its exact solution", "[idea]")
{
    struct End {
        bool load;
        Real of, x, down;
    };
    const End ends[]{{true, 1, 0.943566763717, 0.301720773800},  {true, 5, 0.612371639276, 0.713791523612},
                     {true, 10, 0.445004402246, 0.810609024880}, {false, 1, 0.991246395347, 0.123471401983},
                     {false, 5, 0.846657179954, 0.495905044622}, {false, 10, 0.656353761239, 0.700199715514}};
    for (const End& one : ends) {
        std::vector<Real> errors;
        for (const int n : {50, 100}) {
            const Vec2 tip = elastica(one.of, one.load, n).tip();
            errors.push_back((tip - Vec2(one.x, one.down)).norm());
        }
        CAPTURE(one.load, one.of);
        CHECK((elastica(one.of, one.load).tip() - Vec2(one.x, one.down)).norm() < 1e-9);
        CHECK(order_of(errors) == Approx(4).margin(0.4));
    }
}

TEST_CASE("a strip shows the part of its stiffness that the table of 27.D says by each model of bending",
          "[idea]")
{
    struct Line {
        StripSpec spec;
        Real weight_1, weight_10, end_1, end_10;
    };
    const Line table[]{{{.model = 0}, 0.996, 0.991, 0.998, 0.988},
                       {{.model = 2}, 0.732, 0.873, 0.764, 0.918},
                       {{.model = 1}, 0.732, 0.875, 0.764, 0.921},
                       {{.model = 1, .alternate = false}, 0.693, 0.765, 0.709, 0.834},
                       {{.model = 1, .diagonals = 1e4}, 0.996, 0.995, 0.998, 0.994},
                       {{.model = 3, .segments = 8}, 0.397, 1.656, 0.702, 2.602}};
    for (const Line& line : table)
        for (const bool at_the_end : {false, true})
            for (const Real load : {1.0, 10.0}) {
                const Real part = at_the_end ? load > 1 ? line.end_10 : line.end_1
                                  : load > 1 ? line.weight_10
                                             : line.weight_1;
                const Real exact = elastica(load / part, at_the_end).height_over_width();
                CAPTURE(line.spec.model, line.spec.alternate, at_the_end, load);
                // the table has three decimals; height over width is no steeper than its load
                CHECK(height_over_width(line.spec, load, at_the_end) == Approx(exact).epsilon(0.0006 / part));
            }
}

TEST_CASE("bends along lines and by twist are as stiff in every direction", "[idea]")
{
    for (const int n : {16, 32})
        for (const Real degrees : {0.0, 20.0, 45.0, -45.0}) {
            ClothScene cloth;
            SheetSpec spec;
            spec.columns = spec.rows = n, spec.spacing = 1.0 / n, spec.bending = 1;
            add_sheet(cloth, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, spec);
            cloth.springs.clear();
            const Real angle = degrees * pi / 180, kappa = 1;
            const Vec3 along(rigid::cos(angle), 0, rigid::sin(angle)),
                across(-rigid::sin(angle), 0, rigid::cos(angle));
            for (int k = 0; k < cloth.count(); ++k) {  // rolled onto a cylinder of radius 1/κ
                const Vec3 p = cloth.bodies.position(k);
                const Real s = kappa * along.dot(p);
                cloth.bodies.position(k) = across.dot(p) * across + rigid::sin(s) / kappa * along +
                                           Vec3(0, (1 - rigid::cos(s)) / kappa, 0);
            }
            // ½ B κ² of an area of 1; lines at the border that would need a neighbour beyond it are missing, which is
            // 1/n of each of both directions at most
            const Real ratio = row_energy(cloth, cloth.bodies.x) / (kappa * kappa / 2);
            CAPTURE(n, degrees);
            CHECK(ratio < 1.001);
            CHECK(ratio > 1 - 1.05 / n);
        }
}

TEST_CASE("a column buckles under its own weight where (27.19) says", "[idea]")
{
    std::vector<Real> loads, errors;
    for (const int n : {8, 16, 32}) {
        const auto softest = [n](Real load) {
            ClothScene strip = clamped_strip(n);  // turned upright
            for (Index k = 0; k < strip.bodies.count(); ++k) {
                auto p = strip.bodies.position(k);
                p = Vec3(0, p.x(), 0);
            }
            strip.gravity = {0, -load, 0};
            settle(strip);
            return symmetric_eigenvalues(stiffness_along(strip, {0, 0, 1}, 1e-7))[0];  // as for the chain
        };
        Real low = 6, high = 9;
        for (int i = 0; i < 24; ++i) (softest((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
        loads.push_back(low);
        errors.push_back(low - 7.837347438943484);
    }
    CHECK(order_of(errors) == Approx(2).margin(0.15));
    CHECK(loads.back() == Approx(7.837347438943484).epsilon(0.005));
    // Richardson's value of both finest
    CHECK((4 * loads[2] - loads[1]) / 3 == Approx(7.837347438943484).epsilon(1e-3));
}
