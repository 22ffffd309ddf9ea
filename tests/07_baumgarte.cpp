/// Chapter 7: what a position error does, and the five ways to correct it.

#include "tests/no_allocation.hpp"

#include "chapters/02_velocity_constraints/curves.hpp"
#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/06_sequential_impulse/impulse_method.hpp"
#include "chapters/07_baumgarte/benchmark/chain_in_angles.hpp"
#include "chapters/07_baumgarte/closed_forms.hpp"
#include "chapters/07_baumgarte/corrected_method.hpp"
#include "chapters/07_baumgarte/one_row_step.hpp"
#include "chapters/07_baumgarte/overlaps.hpp"
#include "common/measure.hpp"
#include "common/program/scripted_pointer.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/order.hpp"
#include "tests/says.hpp"

#include <functional>
#include <numeric>

using namespace rigid;

namespace {

constexpr std::array all_ways = {Stabilizer::none, Stabilizer::baumgarte, Stabilizer::relaxation,
                                 Stabilizer::split_impulse, Stabilizer::projection};

/// One body and one bilateral row, without gravity: the constraint is evaluated in each step.
struct OneRow {
    OneRowScene<std::function<Constraint<2>(const VecX&)>> scene;
    StepSettings settings = {.h = 0.01};
    OneRowMethod method = {};
    StepData<2> now = {};
    Bodies<2>& bodies() { return scene.bodies; }

    void advance() { step(scene, settings, method, now); }
};

OneRow bead()
{
    OneRow run{{.gravity = {0, 0}, .at = [](const VecX& x) { return circle_constraint(x, 0, 1); }}};
    run.bodies().x << 1, 0;
    run.bodies().u << 0, 1;
    return run;
}

/// A body 0.1 m beside a straight rail along x: C is linear in x.
OneRow beside_a_rail()
{
    OneRow run{{.gravity = {0, 0},
                .at = [](const VecX& x) { return alignment_constraint<2>(x, world, 0, Vec2(0, 1), 0); }}};
    run.bodies().x << 0, 0.1;
    return run;
}

/// A scene with its settings, its method and memory.
struct Discs {
    DiscScene scene;
    StepSettings settings;
    CorrectedMethod method;
    StepData<2> now;

    explicit Discs(DiscScene start, Stabilizer stabilizer = Stabilizer::baumgarte) : scene(std::move(start))
    {
        method.correction.method = stabilizer;
    }
    void advance(int steps = 1)
    {
        for (int k = 0; k < steps; ++k) step(scene, settings, method, now);
    }
};

}  // namespace

// ---- identities ---------------------------------------------------------------------------------------

TEST_CASE("a bead that nothing corrects leaves the wire as (7.3) says", "[idea]")
{
    OneRow run = bead();
    run.method.correction.method = Stabilizer::none;
    Real r2 = 1;
    for (int n = 0; n < 1000; ++n) {
        // A millionth of a millionth: rounding of 1000 steps.
        CHECK(std::abs(run.bodies().x.norm() - std::sqrt(r2)) < 1e-12);
        r2 += run.settings.h * run.settings.h / r2;
        run.advance();
    }
    // Its velocity is that of the last move; the row makes it tangential in the next step.
    CHECK(std::abs(std::abs(cross2(run.bodies().x, run.bodies().u)) - 1) < 1e-12);
    CHECK(std::abs(run.bodies().x.norm() - 1.046637127311678) < 1e-12);
}

TEST_CASE("a linear error shrinks by 1 minus beta in each step", "[idea]")
{
    for (const Stabilizer method : all_ways) {
        if (method == Stabilizer::none) continue;
        OneRow run = beside_a_rail();
        run.method.correction.method = method;
        run.method.correction.correction_sweeps = 1;
        run.method.correction.tolerance = 0;
        for (int n = 0; n < 30; ++n) run.advance();
        INFO(to_string(method));
        CHECK(run.bodies().x[1] / 0.1 == Approx(1.237940039285e-3).epsilon(1e-12));
        // Only Baumgarte's velocity is left with what corrected the error.
        const Real left =
            method == Stabilizer::baumgarte ? 0.2 * 0.1 * std::pow(0.8, 29) / run.settings.h : 0;
        CHECK(std::abs(run.bodies().u[1] + left) < 1e-15);
    }
    OneRow run = beside_a_rail();
    run.method.correction.method = Stabilizer::none;
    for (int n = 0; n < 30; ++n) run.advance();
    CHECK(run.bodies().x[1] == 0.1);
}

TEST_CASE("the correction is monotone up to beta 1 and stable below 2 and grows beyond", "[idea]")
{
    for (const Real beta : {0.1, 0.5, 0.9, 1.0, 1.1, 1.5, 1.9, 1.99, 2.01, 2.5}) {
        OneRow run = beside_a_rail();
        run.method.correction.beta = beta;
        bool monotone = true;
        for (int n = 0; n < 1000; ++n) {
            const Real before = run.bodies().x[1];
            run.advance();
            monotone = monotone && run.bodies().x[1] >= 0 && run.bodies().x[1] <= before;
            if (n == 9)  // 10 steps of the closed form; rounding relative to the 0.1 m it began with
                CHECK(std::abs(run.bodies().x[1] - 0.1 * std::pow(1 - beta, 10)) <
                      1e-14 * std::max(1.0, std::pow(beta - 1, 10)));
        }
        INFO("beta " << beta);
        CHECK(monotone == (beta <= 1));
        CHECK((std::abs(run.bodies().x[1]) < 0.1) == (beta < 2));
    }
}

TEST_CASE("a bead with Baumgarte moves by (7.17) in each step and settles where (7.18) says", "[idea]")
{
    for (const Real beta : {0.05, 0.2, 0.5, 1.0, 1.5})
        for (const Real h : {0.01, 0.05}) {
            OneRow run = bead();
            run.settings.h = h;
            run.method.correction.beta = beta;
            Real D = 0, largest = 0;
            for (int n = 0; n < 1000; ++n) {
                D = next_bead(D, beta, h);
                run.advance();
                largest = std::max(largest, std::abs(run.bodies().x.squaredNorm() - 1 - D));
            }
            INFO("beta " << beta << " h " << h);
            CHECK(largest < 1e-12);
            CHECK(std::abs(D - settled_bead(beta, h)) < 1e-14);
        }
}

TEST_CASE("a chain that hangs with too few sweeps sags by (7.8)", "[idea]")
{
    for (const Index N : {2, 3, 5})
        for (const int sweeps : {1, 2, 3}) {
            Discs run(hanging_chain(N, 3));
            run.method.solver.sweeps.max_sweeps = sweeps;
            run.method.correction.beta = 0.3;
            run.advance(6000);  // the slowest mode is gone to the last digit
            DiscScene straight = hanging_chain(N, 3);
            std::vector<Row<2>> rows;
            for (const Link& link : straight.links)
                rows.push_back(
                    bilateral(distance_constraint(straight.bodies.x, link), straight.bodies.inverse_mass));
            const MatX A = assemble(rows, run.now.u_star).A;
            VecX lambda(N);  // (4.9): each link carries what hangs below; it pulls, so its λ is negative
            for (Index k = 0; k < N; ++k)
                lambda[k] = -static_cast<Real>(N - 1 - k + 3) * 9.81 * run.settings.h;
            const VecX C = sag(A, lambda, sweeps, 0.3, run.settings.h);
            for (Index k = 0; k < N; ++k) {
                const Real length = (run.scene.bodies.position(k + 1) - run.scene.bodies.position(k)).norm();
                INFO("N " << N << " sweeps " << sweeps << " link " << k);
                // The lengths are of order 1 m and C is their small difference from 0.1 m.
                CHECK(std::abs(length - 0.1 - C[k]) < 1e-11);
            }
        }
}

TEST_CASE("with one sweep a step link k of N hangs too long by N minus k times (7.20)", "[idea]")
{
    const Index N = 10;
    for (const int substeps : {1, 2, 8}) {
        Discs run(hanging_chain(N));
        run.method.solver.sweeps.max_sweeps = 1;
        run.settings.substeps = substeps;
        run.advance(3000);
        for (Index k = 1; k <= N; ++k) {
            const Real length = (run.scene.bodies.position(k) - run.scene.bodies.position(k - 1)).norm();
            const Real C = one_sweep_sag(k, N, 9.81, 0.2, run.settings.h / substeps);
            INFO("link " << k << " in " << substeps << " substeps");
            CHECK(std::abs(length - 0.1 - C) < 1e-12);  // lengths are of order 0.1 m
        }
    }
}

TEST_CASE("the bead of exercise 7.3 runs 6.16 mm outside its wire", "[idea]")
{
    const Real D = settled_bead(0.2, 3.0 / 60);
    CHECK(D == Approx(0.01236).epsilon(1e-3));                     // its printed digits
    CHECK(std::sqrt(1 + D) - 1 == Approx(6.16e-3).epsilon(1e-3));  // likewise
}

TEST_CASE("a part of 0.054 in each quarter of a step is one of 0.2 in the whole as exercise 7.2 says",
          "[idea]")
{
    const Real steps = std::log(0.5) / std::log(0.8);
    CHECK(steps == Approx(3.1).margin(0.05));             // its printed digits
    CHECK(1000 * steps / 60 == Approx(52).margin(0.5));   // likewise, in ms
    CHECK(1000 * steps / 240 == Approx(13).margin(0.5));  // likewise
    const Real part = 1 - std::pow(0.8, 0.25);
    CHECK(part == Approx(0.054).margin(5e-4));  // likewise
    OneRow whole = beside_a_rail(), quarters = beside_a_rail();
    whole.settings.h = 1.0 / 60;
    quarters.settings.h = 1.0 / 240;
    quarters.method.correction.beta = part;
    for (int n = 0; n < 20; ++n) {
        whole.advance();
        for (int k = 0; k < 4; ++k) quarters.advance();
        // Rounding, beside the 0.1 m that it began with.
        CHECK(std::abs(whole.bodies().x[1] - quarters.bodies().x[1]) < 1e-15);
    }
}

TEST_CASE("two links sag by the formulas of exercise 7.4 and sweeps are better from five on", "[idea]")
{
    const Real h = 1.0 / 60, unit = 9.81 * h * h / 0.2;
    const auto sag_of = [](int sweeps, int substeps) {
        Discs run(hanging_chain(2));
        run.method.solver.sweeps.max_sweeps = sweeps;
        run.settings.substeps = substeps;
        run.advance(6000);  // the slowest mode is gone to the last digit
        const auto error = [&run](Index k) {
            return (run.scene.bodies.position(k + 1) - run.scene.bodies.position(k)).norm() - 0.1;
        };
        CHECK(std::abs(error(1)) < 1e-12);  // lengths are of order 0.1 m
        return error(0);
    };
    for (int s = 1; s <= 6; ++s) {
        const Real swept = sag_of(s, 1), stepped = sag_of(1, s);
        INFO(s);
        CHECK(std::abs(swept - unit / (std::pow(2, s) - 1)) < 1e-12);
        CHECK(std::abs(stepped - unit / (s * s)) < 1e-12);
        if (s > 1) CHECK((swept < stepped) == (s >= 5));
    }
}

TEST_CASE("with a part that depends on the error two links have two places of rest as exercise 7.6 says",
          "[idea]")
{
    const auto part = [](Real error) { return std::abs(error) < 1e-3 ? 1 : 0.1; };
    StabilizerSettings settings;
    const Real h = 1.0 / 60;
    settings.beta = 1;
    CHECK(baumgarte_bias(1e-3, ConstraintKind::bilateral, settings, h) == Approx(0.06).epsilon(1e-12));
    settings.beta = 0.1;
    CHECK(baumgarte_bias(1e-3, ConstraintKind::bilateral, settings, h) == Approx(0.006).epsilon(1e-12));

    // (7.5): from 10 mm by 0.9 a step, and the first step below a millimetre removes it.
    OneRow rail = beside_a_rail();
    rail.bodies().x[1] = 0.01;
    for (int n = 1; n <= 23; ++n) {
        rail.method.correction.beta = part(rail.bodies().x[1]);
        rail.advance();
        CHECK(rail.bodies().x[1] == Approx(n < 23 ? 0.01 * std::pow(0.9, n) : 0).margin(1e-15));
    }

    // Three sweeps: the first link is too long by g h² / (7 β), exercise 7.4, that is by 0.39 mm with 1, 3.9 mm with 0.1.
    for (const Real from : {1.0, 0.1}) {
        Discs run(hanging_chain(2));
        run.method.solver.sweeps.max_sweeps = 3;
        run.method.correction.beta = from;
        run.advance(3000);
        const auto error = [&run] {
            return (run.scene.bodies.position(1) - run.scene.bodies.position(0)).norm() - 0.1;
        };
        for (int n = 0; n < 3000; ++n) {
            run.method.correction.beta = part(error());
            run.advance();
        }
        CHECK(std::abs(error() - 9.81 * h * h / (7 * from)) < 1e-12);
    }
}

TEST_CASE("a column whose floor is visited last sags as exercise 7.5 says", "[idea]")
{
    constexpr Index N = 6;
    const Real g = 9.81, h = 1.0 / 60, beta = 0.2, unit = g * h * h / beta;
    MatX J = MatX::Zero(N, N);  // contacts from the bottom, then the floor; discs of 1 kg
    VecX lambda(N);
    for (Index k = 0; k + 1 < N; ++k) {
        J(k, k) = -1;
        J(k, k + 1) = 1;
        lambda[k] = static_cast<Real>(N - 1 - k) * g * h;
    }
    J(N - 1, 0) = 1;
    lambda[N - 1] = static_cast<Real>(N) * g * h;
    const MatX A = J * J.transpose();
    const VecX C = sag(A, lambda, 1, beta, h);  // overlaps are negative
    CHECK(C[0] == Approx(-2 * (N - 1) * unit).epsilon(1e-11));
    for (Index k = 1; k + 1 < N; ++k)
        CHECK(C[k] == Approx(-static_cast<Real>(N - 2 - k) * unit).margin(1e-11 * unit));
    CHECK(std::abs(C[N - 1]) <= 1e-11 * unit);
}

TEST_CASE("n substeps of one sweep sag by the square of n less and n sweeps by about n less", "[idea]")
{
    const auto sag_of = [](int substeps, int sweeps, Real carry) {
        Discs run(hanging_chain(10));
        run.settings.substeps = substeps;
        run.method.solver.sweeps.max_sweeps = sweeps;
        run.method.start.factor = carry;
        run.advance(1500);
        return largest_link_error(run.scene);
    };
    const Real one = sag_of(1, 1, 0);
    for (const int n : {2, 4, 8}) {
        CHECK(sag_of(n, 1, 0) == Approx(one / (n * n)).epsilon(1e-6));
        const Real sweeps = sag_of(1, n, 0);
        CHECK(sweeps < one / n);
        CHECK(sweeps > 0.8 * one / n);  // ten rows: G to the n is not near zero yet
    }
}

TEST_CASE("split impulses sag by (7.21) which is about the square of what Baumgarte's sag is multiplied by",
          "[idea]")
{
    const Index N = 4;
    for (const int sweeps : {1, 2, 4}) {
        Discs run(hanging_chain(N), Stabilizer::split_impulse);
        run.method.solver.sweeps.max_sweeps = sweeps;
        run.method.correction.correction_sweeps = sweeps;
        run.advance(8000);
        DiscScene straight = hanging_chain(N);
        std::vector<Row<2>> rows;
        for (const Link& link : straight.links)
            rows.push_back(
                bilateral(distance_constraint(straight.bodies.x, link), straight.bodies.inverse_mass));
        const MatX A = assemble(rows, run.now.u_star).A;
        VecX lambda(N);
        for (Index k = 0; k < N; ++k) lambda[k] = -static_cast<Real>(N - k) * 9.81 * run.settings.h;
        const VecX C = split_sag(A, lambda, sweeps, sweeps, 0.2, run.settings.h);
        for (Index k = 0; k < N; ++k) {
            const Real length = (run.scene.bodies.position(k + 1) - run.scene.bodies.position(k)).norm();
            INFO("sweeps " << sweeps << " link " << k);
            CHECK(std::abs(length - 0.1 - C[k]) < 1e-10);
        }
    }
}

TEST_CASE("ten links sag as much as the text prints with beta 0.2 and with beta 1", "[idea]")
{
    const auto sag_in_mm = [](Stabilizer method, Real beta, int sweeps, int repaying, int steps) {
        Discs run(hanging_chain(10), method);
        run.method.correction.beta = beta;
        run.method.correction.correction_sweeps = repaying;
        run.method.solver.sweeps.max_sweeps = sweeps;
        run.advance(steps);
        return 1000 * largest_link_error(run.scene);
    };
    // 16 visits of each row: as sweeps on velocities, or half of them on pseudo-velocities.
    const Real b02 = sag_in_mm(Stabilizer::baumgarte, 0.2, 16, 0, 1500);
    const Real s02 = sag_in_mm(Stabilizer::split_impulse, 0.2, 8, 8, 1500);
    const Real b1 = sag_in_mm(Stabilizer::baumgarte, 1, 16, 0, 1500);
    const Real s1 = sag_in_mm(Stabilizer::split_impulse, 1, 8, 8, 1500);
    CHECK(says("chapters/07_baumgarte/README.md", "hang " + printed(b02, 1) +
                                                      " mm too long under Baumgarte's 16 sweeps, and " +
                                                      printed(s02, 0) + " mm under 8 and 8 sweeps"));
    CHECK(says("chapters/07_baumgarte/in_depth.md",
               "16 visits a row and β = 0.2, " + printed(s02, 0) + " mm instead of " + printed(b02, 1) +
                   " mm; with the β = 1 that split impulses may take, " + printed(s1, 1) + " mm instead of " +
                   printed(b1, 1) + " mm."));
    // Relaxation is not in (7.21): at rest its biased sweeps leave u = 0, and the others find nothing to take back.
    const Real r02 = sag_in_mm(Stabilizer::relaxation, 0.2, 8, 8, 1500);
    CHECK(std::abs(r02 - sag_in_mm(Stabilizer::baumgarte, 0.2, 8, 0, 1500)) <= 1e-9);  // rounding of 1 m
    CHECK(says("chapters/07_baumgarte/in_depth.md", "here by " + printed(r02, 2) + " mm, as Baumgarte's 8"));
    CHECK(says("chapters/07_baumgarte/README.md",
               "it is " + printed(sag_in_mm(Stabilizer::split_impulse, 0.2, 8, 8, 90), 0) +
                   " mm too long in its worst link and settles at " + printed(s02, 0) + " mm."));
}

TEST_CASE("a bounce from inside the floor leaves at the faster of its own speed and the repaying one",
          "[idea]")
{
    // 5 cm deep, h = 1/60 s, e = 0.5, down at 0.8 m/s: the bounce alone gives 0.4 m/s. β = 0.1 repays at 0.3 m/s and
    // β = 0.2 at 0.6 m/s. Down at 0.2 m/s, below the threshold of 2 g h = 0.33 m/s, there is no bounce.
    const auto leaves_at = [](Real beta, Real down) {
        DiscScene scene;
        scene.bodies = Bodies<2>(1);
        scene.radius = VecX::Constant(1, 0.1);
        scene.walls = {{{0, 1}, 0}};
        scene.bodies.x << 0, 0.05;
        scene.bodies.u << 0, -down;
        Discs run(std::move(scene));
        run.method.correction.restitution = 0.5;
        run.method.correction.beta = beta;
        run.method.solver.sweeps.max_sweeps = 10;
        run.advance();
        return run.scene.bodies.u[1];
    };
    CHECK(leaves_at(0.1, 0.8) == Approx(0.4).epsilon(1e-12));
    CHECK(leaves_at(0.2, 0.8) == Approx(0.6).epsilon(1e-12));
    CHECK(leaves_at(0.1, 0.2) == Approx(0.3).epsilon(1e-12));
}

TEST_CASE("no error is repaid faster than the maximum correction speed on either side", "[idea]")
{
    StabilizerSettings settings;
    settings.max_correction_speed = 3;
    const Real h = 0.01;  // β / h = 20 1/s
    for (const Real C : {1.0, 0.15, 0.1, -0.1, -0.15, -1.0}) {
        CHECK(baumgarte_bias(C, ConstraintKind::bilateral, settings, h) ==
              Approx(std::clamp(20 * C, -3.0, 3.0)).epsilon(1e-14));
        CHECK(baumgarte_bias(C, ConstraintKind::unilateral, settings, h) ==
              Approx(std::clamp(20 * std::min(C, 0.0), -3.0, 3.0)).epsilon(1e-14));
    }
}

TEST_CASE("what repays an overlap may use up a gap beside it and neither keeps nor closes it", "[idea]")
{
    // Two equal discs overlap by 1 cm; the left one has a gap of 2 cm to a wall. Each moves by half a centimetre: the
    // gap is 1.5 cm afterwards. With 0.3 cm it is used up and the right disc moves the rest.
    for (const Stabilizer method : {Stabilizer::split_impulse, Stabilizer::projection})
        for (const Real gap : {0.02, 0.003}) {
            DiscScene scene;
            scene.bodies = Bodies<2>(2);
            scene.radius = VecX::Constant(2, 0.1);
            scene.walls = {{{1, 0}, 0}};
            scene.gravity.setZero();
            scene.bodies.x << 0.1 + gap, 0, 0.1 + gap + 0.19, 0;
            Discs run(std::move(scene), method);
            run.settings.margin = 0.05;
            run.method.correction.beta = 1;
            run.method.correction.correction_sweeps = 200;
            run.advance();
            INFO(to_string(method) << " with a gap of " << gap << " m");
            const Real left = std::max(0.1, 0.1 + gap - 0.005);
            CHECK(run.scene.bodies.x[0] == Approx(left).epsilon(1e-8));  // repaying ends at 1e-9 m/s
            CHECK(run.scene.bodies.x[2] == Approx(left + 0.2).epsilon(1e-8));
        }
}

// ---- order of convergence -----------------------------------------------------------------------------

TEST_CASE("a pendulum on a distance row converges with order 1 under each way to correct", "[idea]")
{
    for (const Stabilizer method : all_ways) {
        std::vector<Real> steps, errors, lengths;
        for (const Real h : {1.0 / 400, 1.0 / 800, 1.0 / 1600, 1.0 / 3200, 1.0 / 6400}) {
            DiscScene scene = swinging_chain(1);
            scene.bodies.position(1) = Vec2(1, 0);
            scene.links[0].length = 1;
            Discs run(std::move(scene), method);
            run.settings.h = h;
            Real length = 0;
            for (Index k = 0; k < std::lround(1 / h); ++k) {
                run.advance();
                length = std::max(length, largest_link_error(run.scene));
            }
            const Vec2 p = run.scene.bodies.position(1);
            steps.push_back(h);
            // A4: from 90 degrees at rest, the angle from straight down after 1 s.
            errors.push_back(std::abs(std::atan2(p.x(), -p.y()) + 1.405027311524799));
            lengths.push_back(length);
        }
        INFO(to_string(method));
        CHECK(std::abs(slope(steps, errors) - 1) < 0.15);
        if (method == Stabilizer::none) {
            CHECK(std::abs(slope(steps, lengths) - 1) < 0.15);  // h² in each of 1/h steps
        } else {
            CHECK(std::abs(slope(steps, lengths) - 2) < 0.15);  // as (7.18): h² over β
        }
    }
}

TEST_CASE("the reference of a swinging chain keeps its energy and is the pendulum where it has one link",
          "[house]")
{
    ChainInAngles pendulum(VecX::Ones(1), 1, pi / 2, 9.81);
    for (int k = 0; k < 10000; ++k) pendulum.step(1e-4);
    // A4: the angle after 1 s. Order 4 at h = 1e-4 leaves rounding.
    CHECK(std::atan2(pendulum.tip().x(), -pendulum.tip().y()) == Approx(-1.405027311524799).epsilon(1e-11));
    VecX mass = VecX::Ones(10);
    mass[9] = 5;
    ChainInAngles chain(mass, 0.1, pi / 2, 9.81);
    const Real before = chain.energy();
    for (int k = 0; k < 1000; ++k) chain.step(1e-3);
    CHECK(std::abs(chain.energy() - before) < 1e-6);  // it moves some 40 J; order 4
    CHECK_THROWS_AS(ChainInAngles(VecX::Ones(2), 0, 0, 9.81), std::invalid_argument);
}

TEST_CASE("a swinging chain in small steps of one sweep converges to its equations without constraints",
          "[idea]")
{
    ChainInAngles exact(VecX::Ones(5), 0.1, pi / 2, 9.81);
    for (int k = 0; k < 5000; ++k) exact.step(1e-4);
    std::vector<Real> steps, errors;
    for (const int n : {128, 256, 512, 1024, 2048}) {
        DiscScene scene = swinging_chain(5);
        scene.linked = PairSet::all();
        Discs run(std::move(scene));
        run.method.solver.sweeps.max_sweeps = 1;
        run.settings.substeps = n;
        run.advance(30);
        steps.push_back(1.0 / n);
        errors.push_back((run.scene.bodies.position(5) - exact.tip()).norm());
    }
    CHECK(errors.back() < 1e-4);
    INFO(errors[0] << " " << errors[1] << " " << errors[2] << " " << errors[3] << " " << errors[4]);
    CHECK(std::abs(slope(steps, errors) - 1) < 0.15);
}

TEST_CASE("projection with beta 1 holds a bead on its wire to the last digits", "[idea]")
{
    OneRow run = bead();
    run.method.correction.method = Stabilizer::projection;
    run.method.correction.beta = 1;
    run.method.correction.tolerance = 0;
    for (int n = 0; n < 1000; ++n) {
        run.advance();
        // Newton's method: a few visits reach the rounding of r² - 1.
        REQUIRE(std::abs(run.bodies().x.norm() - 1) < 1e-15);
    }
    // exercise 7.1: 1/v² grows by h² a step, but for the first, in which it goes along the wire
    CHECK(run.bodies().u.norm() == Approx(1 / std::sqrt(1 + 999e-4)).epsilon(1e-10));
}

// ---- physics ------------------------------------------------------------------------------------------

TEST_CASE("an overlap that is released leaves at beta C over h and hops by (7.11)", "[idea]")
{
    const Real h = 1.0 / 60, C = 0.1, g = 9.81;
    Discs run(sunken_disc(C));
    run.settings.h = h;
    run.method.correction.beta = 0.2;
    run.advance();
    const Real v = run.scene.bodies.u[1];
    CHECK(v == Approx(1.2).epsilon(1e-12));
    const Real start = run.scene.bodies.x[1] - h * v;
    CHECK(start == Approx(0.4).epsilon(1e-14));
    run.scene.walls.clear();  // what it overlapped is gone
    Real highest = 0;
    for (int k = 0; k < 60; ++k) {
        run.advance();
        highest = std::max(highest, run.scene.bodies.x[1] - start);
    }
    CHECK(highest == Approx(rise(v, g, h)).epsilon(1e-12));
    CHECK(v * v / (2 * g) == Approx(0.0734).margin(5e-5));  // the reference has three digits
    // Symplectic Euler rises v h / 2 higher than a parabola, to within the part of the last step.
    CHECK(std::abs(highest - v * v / (2 * g) - v * h / 2) < g * h * h / 8 + 1e-12);
}

TEST_CASE("split impulse and projection and relaxation correct an overlap and leave no velocity", "[idea]")
{
    for (const Stabilizer method :
         {Stabilizer::split_impulse, Stabilizer::projection, Stabilizer::relaxation}) {
        Discs run(sunken_disc(0.1), method);
        run.scene.gravity.setZero();
        Real fastest = 0;
        for (int k = 0; k < 30; ++k) {
            run.advance();
            fastest = std::max(fastest, run.scene.bodies.u.norm());
        }
        INFO(to_string(method));
        CHECK(fastest < 1e-14);
        CHECK(0.5 - run.scene.bodies.x[1] == Approx(0.1 * std::pow(0.8, 30)).epsilon(1e-10));
        CHECK(run.scene.bodies.x[1] < 0.5 + 1e-12);
    }
}

TEST_CASE("a disc that Baumgarte pushes out of the floor jumps and with the other ways it does not", "[idea]")
{
    const auto highest = [](Stabilizer method, Real fastest) {
        Discs run(sunken_disc(0.1), method);
        run.method.correction.beta = 0.5;
        run.method.correction.max_correction_speed = fastest;
        Real top = 0;
        for (int k = 0; k < 120; ++k) {
            run.advance();
            top = std::max(top, run.scene.bodies.x[1] - 0.5);
        }
        return top;
    };
    const Real h = 1.0 / 60, v = 0.5 * 0.1 / h;
    CHECK(highest(Stabilizer::baumgarte, infinity) == Approx(rise(v, 9.81, h) - 0.1).epsilon(1e-12));
    CHECK(highest(Stabilizer::baumgarte, 0.5) < 0.5 * 0.5 / (2 * 9.81) + 0.5 * h);
    for (const Stabilizer method :
         {Stabilizer::split_impulse, Stabilizer::projection, Stabilizer::relaxation})
        CHECK(highest(method, infinity) < 1e-12);
}

TEST_CASE("ten discs that overlap recover at the greatest speed and nothing is thrown out", "[idea]")
{
    const Real pushing = 0.3;  // [m/s], each contact
    for (const Stabilizer method :
         {Stabilizer::baumgarte, Stabilizer::split_impulse, Stabilizer::projection, Stabilizer::relaxation}) {
        Discs run(crowd(10, 0.2), method);
        run.method.correction.max_correction_speed = pushing;
        run.method.solver.sweeps.max_sweeps = 400;
        run.method.correction.correction_sweeps = 400;
        Real highest = 0, opening = 0;
        for (int k = 0; k < 1200; ++k) {
            const VecX before = run.scene.bodies.x;
            const Real depth = deepest_penetration(run.scene);
            run.advance();
            highest = std::max(highest, run.scene.bodies.position(9).y());
            if (depth > 0.05)  // while they still overlap: how fast do the gaps open?
                for (Index i = 0; i < 9; ++i)
                    opening = std::max(opening, (run.scene.bodies.x[2 * i + 3] - before[2 * i + 3] -
                                                 run.scene.bodies.x[2 * i + 1] + before[2 * i + 1]) /
                                                    run.settings.h);
        }
        INFO(to_string(method));
        CHECK(deepest_penetration(run.scene) < 5e-3);
        // The speeds of ten contacts add up; sweeps that are not converged add up to 2 % on top of it.
        CHECK(opening < 1.02 * pushing);
        const Real stacked = 0.25 + 9 * 0.5;  // where the tenth has its place
        if (method == Stabilizer::baumgarte) CHECK(highest < stacked + rise(10 * pushing, 9.81, 1.0 / 60));
        else CHECK(highest < stacked + 1e-3);
    }
}

TEST_CASE("without a greatest speed Baumgarte throws the tenth of ten overlapping discs metres high",
          "[idea]")
{
    Discs run(crowd(10, 0.2));
    run.method.solver.sweeps.max_sweeps = 400;
    Real highest = 0;
    for (int k = 0; k < 600; ++k) {
        run.advance();
        highest = std::max(highest, run.scene.bodies.position(9).y());
    }
    CHECK(highest > 10);
}

TEST_CASE("a slop leaves an overlap of its size alone and none larger", "[idea]")
{
    StabilizerSettings settings;
    settings.slop = 0.005;
    settings.bilateral_slop = 0.001;
    CHECK(position_error(-0.004, ConstraintKind::unilateral, settings) == 0);
    CHECK(position_error(0.01, ConstraintKind::unilateral, settings) == 0);
    CHECK(position_error(-0.015, ConstraintKind::unilateral, settings) == Approx(-0.01).epsilon(1e-14));
    CHECK(position_error(0.0005, ConstraintKind::bilateral, settings) == 0);
    CHECK(position_error(-0.003, ConstraintKind::bilateral, settings) == Approx(-0.002).epsilon(1e-14));
    CHECK(position_error(0.003, ConstraintKind::bilateral, settings) == Approx(0.002).epsilon(1e-14));
    Discs run(sunken_disc(0.1), Stabilizer::split_impulse);
    run.method.correction.slop = 0.005;
    run.advance(300);
    CHECK(0.5 - run.scene.bodies.x[1] == Approx(0.005).epsilon(1e-10));
}

TEST_CASE("a gap closes to zero and not beyond under each way", "[idea]")
{
    for (const Stabilizer method : all_ways) {
        DiscScene scene = sunken_disc(0);
        scene.bodies.x[1] += 0.01;
        scene.bodies.u[1] = -3;  // it would pass the floor in this step
        Discs run(std::move(scene), method);
        run.advance();
        INFO(to_string(method));
        CHECK(std::abs(run.scene.bodies.x[1] - 0.5) < 1e-15);
        if (method == Stabilizer::relaxation) CHECK(std::abs(run.scene.bodies.u[1]) < 1e-15);
    }
}

TEST_CASE("a disc that does not reach the floor in a step is not slowed down by its row", "[idea]")
{
    for (const Stabilizer method : all_ways) {
        DiscScene scene = sunken_disc(-0.019);
        scene.bodies.u[1] = -0.5;
        Discs run(std::move(scene), method);
        run.scene.gravity.setZero();
        run.advance();
        INFO(to_string(method));
        REQUIRE(run.now.rows.size() == 1);
        CHECK(run.scene.bodies.u[1] == -0.5);
        CHECK(run.scene.bodies.x[1] == Approx(0.519 - 0.5 / 60).epsilon(1e-14));
    }
}

TEST_CASE("contacts move with their bodies within a step so that n substeps correct n times", "[idea]")
{
    // Two discs and a wall: C of a pair, and of the wall.
    for (const Stabilizer method :
         {Stabilizer::relaxation, Stabilizer::split_impulse, Stabilizer::projection}) {
        Discs wall(sunken_disc(0.1), method);
        DiscScene two = column(2);
        two.walls.clear();
        two.bodies.position(1).y() -= 0.05;
        Discs pair(std::move(two), method);
        for (Discs* run : {&wall, &pair}) {
            run->scene.gravity.setZero();
            run->settings.substeps = 4;
            run->method.correction.tolerance = 0;
            run->advance();
        }
        INFO(to_string(method));
        CHECK(deepest_penetration(wall.scene) == Approx(0.1 * std::pow(0.8, 4)).epsilon(1e-12));
        CHECK(deepest_penetration(pair.scene) == Approx(0.05 * std::pow(0.8, 4)).epsilon(1e-12));
    }
}

TEST_CASE("projection once in a step corrects what one step may and no faster than the greatest speed",
          "[idea]")
{
    Discs run(sunken_disc(0.1), Stabilizer::projection);
    run.scene.gravity.setZero();
    run.settings.substeps = 4;
    run.method.correction.at_the_end = true;
    run.advance();
    CHECK(deepest_penetration(run.scene) == Approx(0.1 * 0.8).epsilon(1e-12));
    run.method.correction.max_correction_speed = 0.3;
    run.advance();
    CHECK(deepest_penetration(run.scene) == Approx(0.08 - 0.3 / 60).epsilon(1e-12));
}

TEST_CASE("a column of ten and a chain of ten stand and hang with each way that corrects", "[idea]")
{
    for (const Stabilizer method :
         {Stabilizer::baumgarte, Stabilizer::relaxation, Stabilizer::split_impulse, Stabilizer::projection})
        for (const bool chain : {false, true}) {
            Discs run(chain ? hanging_chain(10) : column_between_walls(10), method);
            run.method.solver.sweeps.max_sweeps = 200;
            run.method.correction.correction_sweeps = 100;
            run.advance(600);
            INFO(to_string(method) << (chain ? " chain" : " column"));
            // 200 sweeps leave cos²(π/20)^200 = 0.7 % of each step's error, (7.8) and (7.21).
            CHECK(std::max(largest_link_error(run.scene), deepest_penetration(run.scene)) < 1e-3);
            CHECK(kinetic_energy(run.scene.bodies) < 1e-3);
        }
}

TEST_CASE("a puck tows two discs and momentum stays what it was", "[idea]")
{
    for (const Stabilizer method : all_ways) {
        DiscScene scene = towed_discs();
        scene.bodies.u << 1, 0.5, 0, 0, 0, 0;
        Discs run(std::move(scene), method);
        run.method.solver.sweeps.max_sweeps = 30;
        const Vec2 before = momentum(run.scene.bodies);
        run.advance(600);
        INFO(to_string(method));
        // 600 steps of rounding, relative to 11 kg m/s.
        CHECK((momentum(run.scene.bodies) - before).norm() < 1e-12 * before.norm());
        if (method != Stabilizer::none) CHECK(largest_link_error(run.scene) < 2e-3);
    }
}

/// A start stage: each step begins with a part of the impulses of the step before. Where that had another number of
/// rows, as in the first step, the sweeps begin at zero.
struct CarryOver : PlainStart {
    Real part = 0;
    VecX lambda = {};  ///< of the step before [N s]

    void recall(const StepSettings&, StepData<2>& now) const
    {
        now.solution.lambda = part * lambda;
        now.same_rows = false;
    }
    void choose(const Bodies<2>&, StepData<2>&) const {}
    void remember(const StepSettings&, const StepData<2>& now) { lambda = now.solution.lambda; }
};

struct CarryingMethod {
    AllPairs contacts;
    Correction correction;
    CarryOver start;
    ImpulseSolver<2> solver;
};

TEST_CASE("carrying the impulses on is stable while enough of them is forgotten and not beyond", "[idea]")
{
    const auto worst = [](Real part) {
        DiscScene scene = hanging_chain(20);
        CarryingMethod method;
        method.solver.sweeps.max_sweeps = 1;
        method.correction.beta = 0.2;
        method.start.part = part;
        StepData<2> now;
        Real error = 0;
        for (int k = 0; k < 8000; ++k) {
            step(scene, {}, method, now);
            if (k >= 7500) error = std::max(error, largest_link_error(scene));
        }
        return error;
    };
    const Real cold = worst(0);
    CHECK(worst(0.5) == Approx(0.5 * cold).epsilon(1e-6));  // (7.22)
    CHECK(worst(0.75) == Approx(0.25 * cold).epsilon(1e-3));
    CHECK(worst(0.9) > 3 * 0.1 * cold);  // it should be a tenth, and swings instead
}

// ---- the ten discs ------------------------------------------------------------------------------------

/// The ten discs under the seeded pointer, as the program runs them.
struct TenDiscs : Discs {
    ScriptedPointer pointer{1, {{0, 0}, {0.8, 0.55}}};
    Real time = 0;

    explicit TenDiscs(Stabilizer stabilizer) : Discs(ten_discs(), stabilizer)
    {
        settings.h = 1.0 / 480;
        settings.stiffness = 1;
        settings.damping = 1;
        method.solver.sweeps.max_sweeps = 60;
        method.correction.correction_sweeps = 20;
    }
    void move(int steps)
    {
        for (int k = 0; k < steps; ++k) {
            const Vec2 tilt = pointer.at(time).cwiseQuotient(scene.half_size);
            scene.gravity = 9.81 * tilt / std::max(Real{1}, tilt.norm());
            advance();
            time += settings.h;
        }
    }
};

TEST_CASE("600 steps of the ten discs keep links and contacts to a millimetre under each way that corrects",
          "[idea]")
{
    for (const Stabilizer method :
         {Stabilizer::baumgarte, Stabilizer::relaxation, Stabilizer::split_impulse, Stabilizer::projection}) {
        TenDiscs run(method);
        Real worst = 0;
        for (int k = 0; k < 600; ++k) {
            run.move(1);
            worst = std::max({worst, largest_link_error(run.scene), deepest_penetration(run.scene)});
        }
        INFO(to_string(method) << " " << worst);
        CHECK(worst < 1e-3);
    }
}

TEST_CASE("the ten discs are the same bits when run again under each way", "[house]")
{
    for (const Stabilizer method : all_ways) {
        TenDiscs first(method), second(method);
        first.settings.substeps = second.settings.substeps = 2;
        first.move(600);
        second.move(600);
        CHECK(first.scene.bodies.x == second.scene.bodies.x);
        CHECK(first.scene.bodies.u == second.scene.bodies.u);
    }
}

TEST_CASE("a steady step allocates nothing under each way", "[house]")
{
    for (const Stabilizer method : all_ways)
        for (const int substeps : {1, 4}) {
            Discs run(triangle(5), method);
            run.settings.substeps = substeps;
            run.method.solver.sweeps.max_sweeps = 40;
            run.advance(200);
            const auto contacts = run.now.contacts.size();
            {
                const NoAllocation guard;
                run.advance(20);
            }
            CHECK(run.now.contacts.size() == contacts);
            CHECK(NoAllocation::violations() == 0);
        }
}

TEST_CASE("the guard against allocations notices them", "[house]")
{
    VecX grows;
    {
        const NoAllocation guard;
        grows.resize(10);
    }
    CHECK(NoAllocation::violations() >= 1);
}

TEST_CASE("correcting sweeps that stop when nothing changes give the same bits as all of them", "[house]")
{
    // A sweep that changed nothing is followed by sweeps that change nothing.
    for (const Stabilizer method : {Stabilizer::relaxation, Stabilizer::split_impulse}) {
        Discs stops(column(3), method), goes_on(column(3), method);
        for (Discs* run : {&stops, &goes_on}) {
            run->scene.bodies.x *= 0.99;  // some overlap
            run->method.solver.sweeps.max_sweeps = 50;
            run->method.correction.correction_sweeps = 2000;
            run->method.correction.tolerance = 0;
        }
        goes_on.method.correction.correction_sweeps = 4000;
        stops.advance(50);
        goes_on.advance(50);
        INFO(to_string(method));
        CHECK(stops.scene.bodies.x == goes_on.scene.bodies.x);
        CHECK(stops.now.visits == goes_on.now.visits);
        CHECK(stops.now.visits < 1000 * static_cast<std::int64_t>(stops.now.rows.size()));
    }
    // Where there is nothing to correct one sweep finds it out; projection needs its first look alone.
    for (const Stabilizer method :
         {Stabilizer::relaxation, Stabilizer::split_impulse, Stabilizer::projection}) {
        Discs free(sunken_disc(-0.01), method);
        free.scene.gravity.setZero();
        free.method.solver.sweeps.max_sweeps = 1;
        free.advance();
        CHECK(free.now.visits == 2);
    }
}

TEST_CASE("projection that stops early is as near to its goal as the tolerance says", "[idea]")
{
    Discs stops(column(3), Stabilizer::projection), goes_on(column(3), Stabilizer::projection);
    for (Discs* run : {&stops, &goes_on}) {
        run->scene.bodies.x *= 0.99;
        run->method.solver.sweeps.max_sweeps = 200;
        run->method.correction.correction_sweeps = 2000;
    }
    goes_on.method.correction.tolerance = 0;
    stops.advance(50);
    goes_on.advance(50);
    const std::int64_t sweeping = 200 * 3;  // for the velocities
    CHECK(10 * (stops.now.visits - sweeping) < goes_on.now.visits - sweeping);
    // Three rows, each within h times the tolerance in each of 50 steps.
    CHECK((stops.scene.bodies.x - goes_on.scene.bodies.x).lpNorm<Eigen::Infinity>() < 150 * 1e-9 / 60);
}

// ---- bounces and joints -------------------------------------------------------------------------------

TEST_CASE("a ball bounces as in chapter 6 whatever corrects the error", "[idea]")
{
    for (const Stabilizer method : all_ways) {
        DiscScene scene = sunken_disc(-0.5);
        scene.bodies.u[1] = -2;
        Discs run(std::move(scene), method);
        run.method.correction.restitution = 0.8;
        run.settings.h = 1.0 / 240;
        ImpulseMethod plain;
        plain.correction.restitution = 0.8;
        DiscScene other = run.scene;
        StepData<2> now;
        bool bounced = false;
        for (int k = 0; k < 200; ++k) {
            run.advance();
            step(other, run.settings, plain, now);
            bounced = bounced || run.scene.bodies.u[1] > 2;
            INFO(to_string(method) << " step " << k);
            REQUIRE(run.scene.bodies.x[1] == Approx(other.bodies.x[1]).epsilon(1e-12));
        }
        CHECK(bounced);
    }
}

TEST_CASE("a motor keeps its speed whatever corrects the error", "[idea]")
{
    for (const Stabilizer method : all_ways) {
        DiscScene scene = sunken_disc(0.02);
        scene.joints.push_back({.kind = Joint::Kind::motor,
                                .a = world,
                                .b = 0,
                                .direction = {1, 0},
                                .speed = 0.7,
                                .force = 100});
        Discs run(std::move(scene), method);
        run.advance(60);
        INFO(to_string(method));
        CHECK(run.scene.bodies.u[0] == Approx(0.7).epsilon(1e-12));
        CHECK(run.scene.bodies.x[0] == Approx(0.7).epsilon(1e-12));
    }
}

TEST_CASE("a motor does not hold back what split impulse corrects")
{
    // A disc 0.1 m behind a stop, and a motor of speed zero along the same line. The pseudo-velocity takes a fifth of the
    // error in a step; a motor that had a say in it would hold the disc where it is.
    DiscScene scene;
    scene.gravity = {0, 0};
    add_disc(scene, {0, 0}, 1, 0.1);
    scene.joints.push_back(
        {.kind = Joint::Kind::stop, .a = world, .b = 0, .direction = {1, 0}, .length = 0.1});
    scene.joints.push_back(
        {.kind = Joint::Kind::motor, .a = world, .b = 0, .direction = {1, 0}, .speed = 0, .force = 1e6});
    Discs run(std::move(scene), Stabilizer::split_impulse);
    run.advance(1);
    CHECK(run.scene.bodies.x[0] == Approx(0.02).epsilon(1e-12));
    CHECK(run.scene.bodies.u[0] == 0);
}

// ---- properties ---------------------------------------------------------------------------------------

/// Six to ten discs here and there, some of them overlapping, three links that are a little off, two walls.
static DiscScene random_scene(Random& random)
{
    const Index K = 6 + random.index(5);
    DiscScene scene;
    scene.bodies = Bodies<2>(K);
    scene.radius.resize(K);
    for (Index k = 0; k < K; ++k) {
        const Real y = random.uniform(-1, 1), x = random.uniform(-1, 1);
        const Real uy = random.uniform(-1, 1), ux = random.uniform(-1, 1);
        scene.bodies.position(k) = Vec2(x, y);
        scene.bodies.velocity(k) = Vec2(ux, uy);
        scene.bodies.inverse_mass.segment<2>(2 * k).setConstant(1 / random.uniform(0.3, 3));
        scene.radius[k] = random.uniform(0.1, 0.3);
    }
    for (Index k = 0; k < 3; ++k) {
        const Real distance = (scene.bodies.position(2 * k + 1) - scene.bodies.position(2 * k)).norm();
        scene.links.push_back({2 * k, 2 * k + 1, distance * random.uniform(0.95, 1.05)});
    }
    scene.walls = {{{0, 1}, -1}, {{1, 0}, -1}};
    link_neighbours(scene);
    return scene;
}

/// Settings that are not the default ones, for the properties.
static void choose(Discs& run, Random& random)
{
    run.method.correction.restitution = random.index(2) == 0 ? 0 : 0.5;
    run.settings.substeps = 1 + static_cast<int>(random.index(3));
    run.method.start.factor = random.uniform(0, 0.5);
    run.method.correction.slop = random.uniform(0, 0.01);
    run.method.correction.max_correction_speed = random.uniform(0.2, 2);
    run.method.correction.tolerance = 0;
}

TEST_CASE("turned or mirrored scenes move turned or mirrored", "[idea]")
{
    Random random(70);
    for (int sample = 0; sample < 100; ++sample) {
        const Stabilizer method = all_ways[static_cast<std::size_t>(sample) % 5];
        Discs here(random_scene(random), method);
        choose(here, random);
        Discs there = here;
        const Real angle = random.uniform(0, 2 * pi);
        Eigen::Matrix<Real, 2, 2> R;
        R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        if (sample % 2 == 0) R.col(0) *= -1;
        for (Index k = 0; k < here.scene.bodies.count(); ++k) {
            there.scene.bodies.position(k) = R * here.scene.bodies.position(k);
            there.scene.bodies.velocity(k) = R * here.scene.bodies.velocity(k);
        }
        for (HalfSpace& wall : there.scene.walls) wall.normal = R * wall.normal;
        there.scene.gravity = R * here.scene.gravity;
        here.advance(20);
        there.advance(20);
        Real difference = 0;
        for (Index k = 0; k < here.scene.bodies.count(); ++k)
            difference = std::max(
                difference, (there.scene.bodies.position(k) - R * here.scene.bodies.position(k)).norm());
        INFO(to_string(method) << " sample " << sample);
        // Rounding of positions of size 1, grown by 20 steps with impacts between round bodies.
        CHECK(difference < 1e-9);
    }
}

TEST_CASE("other units of mass and length and time give the same motion in those units", "[idea]")
{
    Random random(71);
    for (int sample = 0; sample < 100; ++sample) {
        const Stabilizer method = all_ways[static_cast<std::size_t>(sample) % 5];
        Discs here(random_scene(random), method);
        choose(here, random);
        here.scene.length = 1;
        Discs there = here;
        // Powers of two round nothing: the same bits.
        const Real mass = 0x1.0p9, length = 0x1.0p-5, time = 0x1.0p-2, speed = length / time;
        there.scene.bodies.x *= length;
        there.scene.bodies.u *= speed;
        there.scene.bodies.inverse_mass /= mass;
        there.scene.radius *= length;
        for (HalfSpace& wall : there.scene.walls) wall.offset *= length;
        for (Link& link : there.scene.links) link.length *= length;
        there.settings.h *= time;
        there.scene.gravity *= length / (time * time);
        there.scene.length = length;  // in which the settings are lengths
        there.method.correction.max_correction_speed /= time;
        here.advance(30);
        there.advance(30);
        INFO(to_string(method) << " sample " << sample);
        CHECK(there.scene.bodies.x == here.scene.bodies.x * length);
        CHECK(there.scene.bodies.u == here.scene.bodies.u * speed);
        CHECK(there.now.solution.lambda == here.now.solution.lambda * (mass * speed));
    }
}

/// A contacts stage: the rows come in the order of the rows of another run, whose body k is called name[k] here.
struct InOrderOf : AllPairs {
    const StepData<2>& other;
    const std::vector<int>& name;
    std::vector<Source> arranged = {};

    Index called(Index k) const { return k == world ? world : Index(name[std::size_t(k)]); }
    template <class Method>
    void begin(const DiscScene& scene, const StepSettings& settings, Method&, StepData<2>& now)
    {
        find(scene, settings, now);
        REQUIRE(now.sources.size() == other.rows.size());
        arranged.clear();
        for (const Row<2>& row : other.rows)
            for (std::size_t i = 0; i < now.sources.size(); ++i) {
                const Constraint<2> c = constraint_at(scene, now, i, scene.bodies.x);
                const bool same = c.b == called(row.b) && c.a == called(row.a);
                const bool swapped = c.a == called(row.b) && c.b == called(row.a);
                const bool direction = row.a != world || c.Jb.isApprox(row.Jb, 1e-6);
                if ((same || swapped) && direction) arranged.push_back(now.sources[i]);
            }
        REQUIRE(arranged.size() == now.sources.size());
        now.sources = arranged;
    }
};

struct RenumberedMethod {
    InOrderOf contacts;
    Correction correction;
    ColdStart start;
    ImpulseSolver<2> solver;
};

TEST_CASE("renumbered bodies whose rows are visited in the old order move as before", "[idea]")
{
    Random random(72);
    int compared = 0;
    for (int sample = 0; sample < 100; ++sample) {
        const Stabilizer method = all_ways[static_cast<std::size_t>(sample) % 5];
        Discs here(random_scene(random), method);
        const Index K = here.scene.bodies.count();
        std::vector<int> name;  // body k is now called name[k]
        shuffle_rows(static_cast<std::size_t>(K), random, name);
        const auto called = [&name](Index k) { return k == world ? world : Index(name[std::size_t(k)]); };
        DiscScene there = here.scene;
        for (Index k = 0; k < K; ++k) {
            there.bodies.position(called(k)) = here.scene.bodies.position(k);
            there.bodies.velocity(called(k)) = here.scene.bodies.velocity(k);
            there.bodies.inverse_mass.segment<2>(2 * called(k)) =
                here.scene.bodies.inverse_mass.segment<2>(2 * k);
            there.radius[called(k)] = here.scene.radius[k];
        }
        for (Link& link : there.links) link = {called(link.a), called(link.b), link.length};
        link_neighbours(there);
        RenumberedMethod renumbered{{{}, here.now, name}, here.method.correction, {}, {}};
        StepData<2> now;
        for (int k = 0; k < 10; ++k) {
            here.advance();
            step(there, here.settings, renumbered, now);
        }
        for (Index k = 0; k < K; ++k, ++compared)
            CHECK((there.bodies.position(called(k)) - here.scene.bodies.position(k)).norm() < 1e-9);
    }
    CHECK(compared > 500);
}

// ---- bad input ----------------------------------------------------------------------------------------

TEST_CASE("200 bad scenes are refused by a sentence or run without a NaN", "[house]")
{
    Random random(73);
    int refused = 0, ran = 0;
    for (int sample = 0; sample < 200; ++sample) {
        Discs run(random_scene(random), all_ways[static_cast<std::size_t>(sample) % 5]);
        choose(run, random);
        DiscScene& scene = run.scene;
        const Index k = random.index(scene.bodies.count());
        bool must_refuse = true;
        switch (sample / 5 % 10) {
        case 0:
            scene.radius[k] = 0;
            break;
        case 1:
            scene.bodies.x[2 * k] = std::nan("");
            break;
        case 2:
            scene.links[0].b = scene.links[0].a;
            break;
        case 3:
            scene.links[0].length = 0;
            break;
        case 4:
            scene.bodies.inverse_mass[2 * k] = -1;
            break;
        case 5:  // all on one point
            must_refuse = false;
            scene.bodies.x.setZero();
            break;
        case 6:  // static against static, linked and overlapping
            must_refuse = false;
            scene.bodies.inverse_mass.head<8>().setZero();
            scene.bodies.u.head<8>().setZero();
            scene.bodies.position(1) = scene.bodies.position(0);
            break;
        case 7:  // 1e-12 kg beside 1 kg
            must_refuse = false;
            scene.bodies.inverse_mass.segment<2>(2 * k).setConstant(1e12);
            break;
        case 8:  // ten deep in a wall
            must_refuse = false;
            scene.bodies.x.array() -= 5;
            break;
        default:  // conflicting links
            must_refuse = false;
            scene.links.push_back({scene.links[0].a, scene.links[0].b, 3 * scene.links[0].length});
            break;
        }
        INFO("sample " << sample);
        bool thrown = false;
        try {
            require_valid(scene);
            run.advance(120);
        } catch (const std::invalid_argument& sentence) {
            thrown = true;
            CHECK(std::string(sentence.what()).size() > 20);
        }
        CHECK(thrown == must_refuse);
        (thrown ? refused : ran) += 1;
        if (!thrown) {
            CHECK(scene.bodies.x.allFinite());
            CHECK(scene.bodies.u.allFinite());
        }
    }
    CHECK(refused == 100);
    CHECK(ran == 100);
}

TEST_CASE("settings that make no sense are refused by a sentence that names them", "[house]")
{
    const auto sentence = [](const std::function<void(Discs&)>& spoil) -> std::string {
        Discs run(column(2));
        spoil(run);
        const VecX before = run.scene.bodies.x;
        try {
            run.advance();
        } catch (const std::invalid_argument& error) {
            CHECK(run.scene.bodies.x == before);
            return error.what();
        }
        return "";
    };
    CHECK(sentence([](Discs& run) { run.method.correction.beta = -0.1; }) ==
          "beta is -0.1; it must be zero or positive and finite");
    CHECK(sentence([](Discs& run) { run.method.correction.beta = std::nan(""); }) ==
          "beta is nan; it must be zero or positive and finite");
    CHECK(sentence([](Discs& run) { run.method.correction.slop = -1; }) ==
          "slop is -1; it must be zero or positive and finite");
    CHECK(sentence([](Discs& run) { run.method.correction.bilateral_slop = infinity; }) ==
          "bilateral_slop is inf; it must be zero or positive and finite");
    CHECK(sentence([](Discs& run) { run.method.correction.max_correction_speed = -2; }) ==
          "max_correction_speed is -2; it must be zero or positive");
    CHECK(sentence([](Discs& run) { run.method.correction.correction_sweeps = -3; }) ==
          "correction_sweeps is -3; it must be zero or positive");
    CHECK(sentence([](Discs& run) { run.method.correction.tolerance = -3; }) ==
          "the tolerance of the repaying sweeps is -3; it must be zero or positive");
    CHECK(sentence([](Discs& run) { run.settings.substeps = 0; }) == "substeps is 0; it must be 1 or more");
    CHECK(sentence([](Discs& run) { run.method.start.factor = 1.5; }) ==
          "the warm start factor is 1.5; it must be from 0 to 1");
    CHECK(sentence([](Discs& run) { run.settings.h = 0; }) ==
          "the time step h is 0 s; it must be positive and finite");
    CHECK(sentence([](Discs& run) { run.method.correction.max_correction_speed = infinity; }).empty());
    CHECK_THROWS_WITH(power(MatX::Identity(2, 2), -1),
                      "the number of sweeps is -1; it must be zero or positive");
}
