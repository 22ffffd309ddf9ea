/// Chapter 29: strings, membranes, modes, a tank: what a step of neighbours keeps, and how fast its waves are.

#include "tests/catch.hpp"
#include "tests/no_allocation.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

#include "chapters/29_waves/membrane.hpp"
#include "chapters/29_waves/modes.hpp"
#include "chapters/29_waves/spectral.hpp"
#include "chapters/29_waves/tank.hpp"
#include "common/elementary.hpp"
#include "common/random.hpp"

using namespace rigid;

namespace {

/// A string with fixed ends in its mode m, at rest.
WaveLine in_mode(Index intervals, int m, Real c = 1)
{
    WaveLine line(intervals, 1, c);
    for (Index i = 1; i < intervals; ++i)
        line.y[i] = rigid::sin(m * pi * static_cast<Real>(i) / static_cast<Real>(intervals));
    return line;
}

WaveLine random_line(Random& random, Index intervals, LineEnd left, LineEnd right)
{
    const Real length = 1 + random.uniform(), speed = 0.5 + random.uniform();
    WaveLine line(intervals, length, speed);
    line.left = left, line.right = right;
    for (Index i = 1; i < intervals; ++i) {
        line.y[i] = random.uniform(-1, 1);
        line.v[i] = random.uniform(-1, 1);
    }
    return line;
}

/// A pluck that is smooth: its corners are far below what the coarsest string of a test resolves.
Real bell(Real x) { return rigid::exp(-(x - 0.4) * (x - 0.4) / 0.01); }

/// The largest error of a bell on a fixed string of 1 m after half a second: half of it at 0.9 m, half of it upside down at
/// 0.1 m. (After a whole second each mode is at its turning point, and its error in time is of the fourth order.)
template <class Step>
Real error_of_bell(Index intervals, Real C, const Step& step)
{
    WaveLine line(intervals, 1, 1);
    for (Index i = 1; i < intervals; ++i) line.y[i] = bell(line.dx * static_cast<Real>(i));
    const auto steps = static_cast<int>(std::lround(static_cast<Real>(intervals) / (2 * C)));
    step(line, 0.5 / steps, steps);
    Real worst = 0;
    for (Index i = 1; i < intervals; ++i) {
        const Real x = line.dx * static_cast<Real>(i);
        worst = std::max(
            worst, std::abs(line.y[i] - (bell(x - 0.5) - bell(0.5 - x) + bell(x + 0.5) - bell(1.5 - x)) / 2));
    }
    return worst;
}

const auto by_leapfrog = [](WaveLine& line, Real h, int steps) {
    start_leapfrog(line, h);
    for (int n = 0; n < steps; ++n) leapfrog(line, h);
};

}  // namespace

// ------------------------------------------------------------------------------------------------ three masses

TEST_CASE("three masses at Courant number 1 have the places of section 29.1", "[idea]")
{
    WaveLine line(4, 4, 1);
    line.y[2] = 1;
    start_leapfrog(line, 1);
    const Real places[9][3] = {{0, 1, 0},       {0.5, 0, 0.5}, {0, 0, 0},     {-0.5, 0, -0.5}, {0, -1, 0},
                               {-0.5, 0, -0.5}, {0, 0, 0},     {0.5, 0, 0.5}, {0, 1, 0}};
    for (const auto& place : places) {  // sums of halves: exact
        CHECK(line.y[1] == place[0]);
        CHECK(line.y[2] == place[1]);
        CHECK(line.y[3] == place[2]);
        CHECK(leapfrog_energy(line, 1) == 0.25);
        leapfrog(line, 1);
    }
}

TEST_CASE("nine masses between springs have the frequencies of the reference", "[idea]")
{
    const Real dx = 1, c = 1;
    const Real expected[3] = {0.3128689300804617, 0.6180339887498948, 0.9079809994790936};
    for (int k = 1; k <= 3; ++k)
        CHECK(masses_frequency(k * pi / 10, c, dx) == Approx(expected[k - 1]).epsilon(1e-14));
    // as an eigenvalue of the matrix: a strip of the membrane whose y motion adds a known number
    const Modes modes = lowest_modes(rectangle_stiffness(10, 2, 10, 2, 1), 3);
    REQUIRE(modes.solved);
    for (int k = 0; k < 3; ++k)  // ω² = ω_k² + 4 sin²(π/4); the residual is 1e-10
        CHECK(modes.omega[k] * modes.omega[k] - 2 == Approx(expected[k] * expected[k]).epsilon(1e-9));
}

// ------------------------------------------------------------------------------------------------ dispersion

TEST_CASE("a mode under leapfrog and under the trapezoidal rule swings at the frequency of its closed form",
          "[idea]")
{
    for (const int m : {1, 7, 15})
        for (const Real C : {0.3, 0.9, 1.0}) {
            WaveLine line = in_mode(16, m, 2), implicit = line;
            const Real h = C * line.dx / line.c, k = m * pi, start = line.y[3];
            const Real omega = leapfrog_frequency(k, line.c, line.dx, h),
                       slower = trapezoidal_frequency(k, line.c, line.dx, h);
            start_leapfrog(line, h);
            ThetaMemory memory;
            for (int n = 1; n <= 400; ++n) {
                leapfrog(line, h);
                theta_step(implicit, h, 0.5, memory);
                // roundings of 400 steps add up as n²ε/2 at worst
                REQUIRE(std::abs(line.y[3] - start * rigid::cos(omega * h * n)) < 1e-11);
                REQUIRE(std::abs(implicit.y[3] - start * rigid::cos(slower * h * n)) < 1e-11);
            }
        }
}

TEST_CASE("leapfrog at Courant number 1 is the exact wave and any shape comes back after a period", "[idea]")
{
    Random random(21);
    WaveLine line = random_line(random, 37, LineEnd::fixed, LineEnd::fixed);
    line.v.setZero();
    const VecX start = line.y;
    const Real h = line.dx / line.c;
    start_leapfrog(line, h);
    for (int n = 0; n < 37; ++n) leapfrog(line, h);
    for (Index i = 0; i <= 37; ++i) CHECK(line.y[i] == Approx(-start[37 - i]).margin(1e-12));
    for (int n = 0; n < 37; ++n) leapfrog(line, h);
    for (Index i = 0; i <= 37; ++i) CHECK(line.y[i] == Approx(start[i]).margin(1e-12));
}

TEST_CASE("errors of a bell fall with the second power of interval and step", "[idea]")
{
    std::vector<Real> explicit_errors, implicit_errors, euler_errors;
    for (const Index n : {100, 200, 400, 800}) {
        explicit_errors.push_back(error_of_bell(n, 0.5, by_leapfrog));
        const auto by_theta = [](Real theta) {
            return [theta](WaveLine& line, Real h, int steps) {
                ThetaMemory memory;
                for (int i = 0; i < steps; ++i) theta_step(line, h, theta, memory);
            };
        };
        implicit_errors.push_back(error_of_bell(n, 1, by_theta(0.5)));
        euler_errors.push_back(error_of_bell(n, 0.02, by_theta(1)));
    }
    CHECK(order_of(explicit_errors) == Approx(2).margin(0.15));
    CHECK(order_of(implicit_errors) == Approx(2).margin(0.15));
    CHECK(order_of(euler_errors) == Approx(1).margin(0.25));  // at C = 0.02 the order of space still shows
    // at C = 1 nothing is left but what the bell has at the fixed end, e^{-16}, and rounding
    CHECK(error_of_bell(100, 1, by_leapfrog) < 2 * bell(0) + 1e-12);
}

TEST_CASE("a step beyond Courant number 1 is refused and explodes where nobody refuses it", "[house]")
{
    WaveLine line(4, 4, 1);
    line.y[2] = 1;
    CHECK(sentence_of([&] { leapfrog(line, 1.1); }) ==
          "the time step is 1.1 s; a wave goes 1.1 intervals in it, and leapfrog is stable up to one");
    CHECK(line.y[2] == 1);  // nothing moved
    // the largest frequency of the three masses, 2 sin(3π/8), is stable to h = 2/ω = 1.0824
    const auto farthest = [](Real h) {
        Vec<3> y(0, 1, 0), v(0, 0, 0);
        Real most = 0;
        for (int n = 0; n < 200; ++n) {
            const Vec<3> a(y[1] - 2 * y[0], y[0] - 2 * y[1] + y[2], y[1] - 2 * y[2]);
            v += (n == 0 ? h / 2 : h) * a;
            y += h * v;
            most = std::max(most, y.cwiseAbs().maxCoeff());
        }
        return most;
    };
    CHECK(farthest(1.08) < 20);
    CHECK(farthest(1.09) > 1e6);
}

// ------------------------------------------------------------------------------------------------ energy

TEST_CASE("leapfrog keeps its energy to rounding over a hundred thousand steps with fixed and free ends",
          "[idea]")
{
    Random random(1);
    for (const LineEnd right : {LineEnd::fixed, LineEnd::free}) {
        WaveLine line = random_line(random, 24, LineEnd::fixed, right);
        const Real h = 0.9 * line.dx / line.c;
        start_leapfrog(line, h);
        leapfrog(line, h);
        const Real start = leapfrog_energy(line, h);
        for (int n = 0; n < 100000; ++n) leapfrog(line, h);
        // 1e5 roundings of either sign: 300 ε, and a factor for the shortest waves, whose two parts nearly cancel
        CHECK(leapfrog_energy(line, h) == Approx(start).epsilon(1e-11));
    }
}

TEST_CASE("the trapezoidal rule keeps the energy at any step and implicit Euler never adds to it", "[idea]")
{
    Random random(2);
    for (const Real C : {0.5, 10.0, 1000.0}) {
        WaveLine line = random_line(random, 24, LineEnd::fixed, LineEnd::free), euler = line;
        const Real h = C * line.dx / line.c, start = wave_energy(line);
        ThetaMemory memory;
        Real before = start;
        for (int n = 0; n < 1000; ++n) {
            theta_step(line, h, 0.5, memory);
            theta_step(euler, h, 1, memory);
            const Real now = wave_energy(euler);
            REQUIRE(now <= before * (1 + 1e-12));
            before = now;
        }
        // the tridiagonal system has the condition number 1 + C², which a step multiplies its rounding by
        CHECK(wave_energy(line) == Approx(start).epsilon(1e-12 * (10 + C * C)));
        CHECK(before < 0.9 * start);
    }
}

// ------------------------------------------------------------------------------------------------ ends

TEST_CASE("an open end swallows all at Courant number 1 and sends back what its closed form says", "[idea]")
{
    for (const Real C : {1.0, 0.5}) {
        const Index N = 1200;
        WaveLine line(N, N, 1);
        line.right = LineEnd::open;
        const Real h = C, k = 2 * pi / 12;
        // a long packet of waves of twelve intervals, moving to the right
        const Real omega = leapfrog_frequency(k, 1, 1, h), centre = 700, width = 120;
        const Real group = rigid::sin(k) * C / rigid::sin(omega * h);  // dω/dk of (29.5)
        const auto packet = [&](Real x, Real t) {
            const Real s = (x - centre - group * t) / width;
            return s * s < 1 ? (1 - s * s) * (1 - s * s) * rigid::cos(k * (x - centre) - omega * t) : 0;
        };
        for (Index i = 1; i < N; ++i) {
            const auto x = static_cast<Real>(i);
            line.y[i] = packet(x, 0);
            line.v[i] = (packet(x, 0) - packet(x, -h)) / h;
        }
        const Real start = leapfrog_energy(line, h);
        const auto steps = static_cast<int>(900 / h);
        for (int n = 0; n < steps; ++n) leapfrog(line, h);
        const Real back = std::sqrt(leapfrog_energy(line, h) / start);
        // a packet of twenty waves has others in it: a twentieth
        if (C == 1) CHECK(back < 1e-10);
        else CHECK(back == Approx(open_end_reflection(k, 1, 1, h)).epsilon(0.1));
        CHECK(open_end_reflection(k, 1, 1, 1) < 1e-14);
    }
}

TEST_CASE("a sponge of thirty points lets less than a hundredth of a wave of twelve come back", "[house]")
{
    const Index N = 600;
    WaveLine line(N, N, 1);
    add_sponge(line, 30, 0.6, false, true);
    for (Index i = 1; i < N; ++i) {
        const Real s = (static_cast<Real>(i) - 400) / 60;
        const auto wave = [&](Real shift) {
            const Real r = s - shift / 60;
            return r * r < 1 ? (1 - r * r) * (1 - r * r) * rigid::cos(2 * pi / 12 * 60 * r) : 0;
        };
        line.y[i] = wave(0);
        line.v[i] = (wave(0) - wave(-0.5)) / 0.5;
    }
    const Real start = leapfrog_energy(line, 0.5);
    for (int n = 0; n < 800; ++n) leapfrog(line, 0.5);
    const Real back = std::sqrt(leapfrog_energy(line, 0.5) / start);
    CHECK(back < 0.01);
    CHECK(back > 1e-6);  // it is no perfect end
}

// ------------------------------------------------------------------------------------------------ spectral

TEST_CASE(
    "a spectral step is the wave of Courant number 1 and a period in any number of steps brings all back",
    "[idea]")
{
    Random random(4);
    WaveLine line = random_line(random, 64, LineEnd::fixed, LineEnd::fixed), exact = line;
    line.v.setZero(), exact.v.setZero();
    const VecX start = line.y;
    const Real h = line.dx / line.c, period = 2 * line.length() / line.c;
    SpectralStep one(exact, h, SpectralStep::Of::equation),
        seventh(exact, period / 7, SpectralStep::Of::equation);
    start_leapfrog(line, h);
    for (int n = 0; n < 100; ++n) {
        leapfrog(line, h);
        one.step(exact);
        REQUIRE((line.y - exact.y).cwiseAbs().maxCoeff() < 1e-11);  // 100 steps of log2(128) roundings each
    }
    exact.y = start, exact.v.setZero();
    for (int n = 0; n < 7; ++n) seventh.step(exact);
    CHECK((exact.y - start).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("a spectral step of the masses is what small steps of leapfrog tend to", "[idea]")
{
    std::vector<Real> errors;
    for (const int parts : {4, 8, 16, 32}) {
        WaveLine line = in_mode(16, 9), exact = line;
        line.y[3] += 0.3, exact.y[3] += 0.3;
        SpectralStep whole(exact, 0.7, SpectralStep::Of::masses);
        whole.step(exact);
        const int steps = 16 * parts;
        by_leapfrog(line, 0.7 / steps, steps);
        errors.push_back((line.y - exact.y).cwiseAbs().maxCoeff());
    }
    CHECK(order_of(errors) == Approx(2).margin(0.15));
}

TEST_CASE("sines transformed twice are what they were", "[house]")
{
    Random random(9);
    for (const Index N : {2, 8, 256}) {
        SineTransform transform(N);
        VecX values = VecX::Zero(N + 1);
        for (Index i = 1; i < N; ++i) values[i] = random.normal();
        VecX twice = values;
        transform.apply(twice);
        Real first = 0;  // against the sum itself
        for (Index i = 1; i < N; ++i)
            first += values[i] * rigid::sin(pi * static_cast<Real>(i) / static_cast<Real>(N));
        CHECK(twice[1] == Approx(first).margin(1e-12));
        transform.apply(twice);
        CHECK((twice * 2 / static_cast<Real>(N) - values).cwiseAbs().maxCoeff() < 1e-13);
    }
}

// ------------------------------------------------------------------------------------------------ membranes and modes

TEST_CASE("a membrane keeps its energy to rounding over a hundred thousand steps and water with free edges "
          "its volume",
          "[idea]")
{
    for (const bool fixed : {true, false}) {
        Membrane membrane(12, 8, 0.1, 1.3, fixed);
        const Real h = 0.65 * membrane.dx / membrane.c;
        touch(membrane, 0.4, 0.3, 0.25, 0.1);
        const auto whole = [&] {
            Real sum = 0;
            for (Index j = 0; j <= membrane.ny; ++j)
                for (Index i = 0; i <= membrane.nx; ++i)
                    sum += membrane.y[membrane.at(i, j)] * (i % membrane.nx == 0 ? 0.5 : 1) *
                           (j % membrane.ny == 0 ? 0.5 : 1);
            return sum;
        };
        start_leapfrog(membrane, h);
        const Real start = leapfrog_energy(membrane, h);
        for (int n = 0; n < 100000; ++n) leapfrog(membrane, h);
        CHECK(leapfrog_energy(membrane, h) == Approx(start).epsilon(1e-11));  // as on the string
        // what is rounded in 117 velocities adds up by chance, and once more in the places: 1e5^1.5 times 1e-17 m
        if (!fixed) CHECK(std::abs(whole()) < 1e-8);
    }
}

TEST_CASE(
    "modes of a rectangle are those of its grid to the residual and of the membrane to the second power",
    "[idea]")
{
    const Real a = 1.3, b = 0.9, c = 2;
    std::vector<Real> errors;
    for (const Index n : {8, 16, 32}) {
        const Modes modes = lowest_modes(rectangle_stiffness(n, n, a, b, c), 3);
        REQUIRE(modes.solved);
        const auto N = static_cast<Real>(n);
        const Real kx = rigid::sin(pi / (2 * N)) * 2 * N / a, ky = rigid::sin(pi / (2 * N)) * 2 * N / b;
        CHECK(modes.omega[0] == Approx(c * std::sqrt(kx * kx + ky * ky)).epsilon(1e-10));
        errors.push_back(modes.omega[0] - pi * c * std::sqrt(1 / (a * a) + 1 / (b * b)));
        CHECK(modes.shapes.col(0).norm() == Approx(1).epsilon(1e-12));
        CHECK(std::abs(modes.shapes.col(0).dot(modes.shapes.col(1))) < 1e-12);
    }
    CHECK(order_of(errors) == Approx(2).margin(0.15));
}

TEST_CASE("modes of a drum tend to the zeros of the Bessel functions with the second power", "[idea]")
{
    std::vector<Real> first, second, third;
    for (const Index n : {5, 10, 20, 40}) {
        const Modes modes = lowest_modes(drum_stiffness(n, 1, 1), 4);
        REQUIRE(modes.solved);
        first.push_back(modes.omega[0] - 2.404825557695773);   // j01
        second.push_back(modes.omega[1] - 3.831705970207512);  // j11, twice
        third.push_back(modes.omega[3] - 5.135622301840683);   // j21
        CHECK(modes.omega[2] ==
              Approx(modes.omega[1]).epsilon(1e-8));  // one is the other turned by a quarter
    }
    CHECK(std::abs(third.back()) < 4e-3);
    CHECK(order_of(first) == Approx(2).margin(0.15));
    CHECK(order_of(second) == Approx(2).margin(0.15));
    CHECK(order_of(third) == Approx(2).margin(0.15));
}

TEST_CASE("a mode of the grid swings alone under leapfrog with the frequency of its eigenvalue", "[idea]")
{
    const Index n = 12;
    const Modes modes = lowest_modes(rectangle_stiffness(n, n, 1.2, 1.2, 1), 1);
    Membrane membrane(n, n, 0.1, 1, true);
    for (Index j = 1; j < n; ++j)
        for (Index i = 1; i < n; ++i)
            membrane.y[membrane.at(i, j)] = modes.shapes((j - 1) * (n - 1) + i - 1, 0);
    const VecX start = membrane.y;
    const Real h = 0.05, omega = 2 / h * rigid::asin(modes.omega[0] * h / 2);
    start_leapfrog(membrane, h);
    for (int k = 1; k <= 200; ++k) leapfrog(membrane, h);
    // 200 steps of a shape that is right to 1e-10
    CHECK((membrane.y - start * rigid::cos(omega * h * 200)).cwiseAbs().maxCoeff() < 1e-8);
}

TEST_CASE("a standing wave in a tank tends to the frequency of deep water with the second power", "[idea]")
{
    std::vector<Real> errors;
    for (const Index n : {8, 16, 32}) {
        Tank tank(n, n / 2, 1, 0.5, 9.81);
        for (Index i = 0; i < n; ++i)
            tank.level[i] = rigid::cos(pi * (static_cast<Real>(i) + 0.5) / static_cast<Real>(n));
        VecX speed;
        tank.vertical_speed(tank.level, speed);
        const Real omega = std::sqrt(9.81 * speed[0] / tank.level[0]);
        errors.push_back(omega - 5.316553374316751);
        // and it swings so, in leapfrog's time
        const Real h = tank.stable_step() / 4, start = tank.level[0];
        const Real slowed = 2 / h * rigid::asin(omega * h / 2);
        tank.potential = h / 2 * 9.81 * tank.level;
        for (int k = 1; k <= 100; ++k) tank.step(h);
        CHECK(tank.level[0] == Approx(start * rigid::cos(slowed * h * 100)).margin(1e-10));
    }
    CHECK(order_of(errors) == Approx(2).margin(0.15));
    CHECK(std::sqrt(9.81 * 0.5) * pi > 1.3 * 5.316553374316751);  // what shallow water says of it
}

// ------------------------------------------------------------------------------------------------ house

TEST_CASE("the numbers of sections 29.C and 29.E are those of the drum and of the tank", "[house]")
{
    const auto close = [](Real stated, int decimals) {
        return Approx(stated).margin(0.51 * rigid::pow(10.0, -decimals));  // as it is printed
    };
    struct Line {
        Index n;
        Real lowest, second, fourth;
    };
    for (const auto& [n, lowest, second, fourth] : {Line{5, 2.3901, 3.7651, 4.9330},
                                                    {10, 2.4013, 3.8154, 5.0860},
                                                    {20, 2.4040, 3.8277, 5.1234},
                                                    {40, 2.4046, 3.8307, 5.1326}}) {
        const StiffnessMatrix K = drum_stiffness(n, 1, 1);
        const Modes modes = lowest_modes(K, 4);
        CHECK(modes.omega[0] == close(lowest, 4));
        CHECK(modes.omega[1] == close(second, 4));
        CHECK(modes.omega[3] == close(fourth, 4));
        if (n == 40) CHECK(K.rows() == 5013);
    }
    const std::array<Real, 4> stated{5.24104, 5.29728, 5.31171, 5.31534};
    for (std::size_t k = 0; k < 4; ++k) {
        const Index n = Index{8} << k;
        Tank tank(n, n / 2, 1, 0.5, 9.81);
        for (Index i = 0; i < n; ++i)
            tank.level[i] = rigid::cos(pi * (static_cast<Real>(i) + 0.5) / static_cast<Real>(n));
        VecX speed;
        tank.vertical_speed(tank.level, speed);
        CHECK(std::sqrt(9.81 * speed[0] / tank.level[0]) == close(stated[k], 5));
    }
    CHECK(std::sqrt(9.81 * 0.5) * pi == close(6.958, 3));
    CHECK(std::sqrt(9.81 * 0.5) * pi / 5.316553374316751 == close(1.31, 2));
}

TEST_CASE("steps of waves ask for no memory", "[house]")
{
    WaveLine line = in_mode(64, 3), spectral = line;
    Membrane membrane(16, 16, 1, 1, false);
    ThetaMemory memory;
    SpectralStep exact(spectral, 0.3, SpectralStep::Of::equation);
    theta_step(line, 0.01, 0.5, memory);
    int violations = 0;
    {
        const NoAllocation forbidden;
        for (int n = 0; n < 10; ++n) {
            leapfrog(line, 0.01);
            theta_step(line, 0.01, 0.5, memory);
            exact.step(spectral);
            leapfrog(membrane, 0.5);
        }
        violations = NoAllocation::violations();
    }
    CHECK(violations == 0);
}

TEST_CASE("strings membranes and modes that make no sense are refused by name", "[house]")
{
    const auto string = [](const auto& change, const auto& move) {
        WaveLine line(4, 4, 1);
        change(line);
        return sentence_of([&] { move(line); });
    };
    const auto start = [](WaveLine& line) { start_leapfrog(line, 0.5); };
    const auto go = [](WaveLine& line) { leapfrog(line, 0.5); };
    ThetaMemory theta;
    const auto turn = [&](WaveLine& line) { theta_step(line, 0.5, 0.5, theta); };
    CHECK(string([](WaveLine& l) { l.y[3] = NAN; }, start) == "y[3] is nan; it must be a finite number");
    CHECK(string([](WaveLine& l) { l.damping[2] = -1; }, start) ==
          "damping[2] is -1 1/s; it must be zero or positive");
    CHECK(string([](WaveLine& l) { l.c = -1; }, go) ==
          "the speed of its waves is -1 m/s; it must be positive and finite");
    CHECK(string([](WaveLine& l) { l.c = NAN; }, turn) ==
          "the speed of its waves is nan m/s; it must be positive and finite");
    CHECK(string([](WaveLine& l) { l.v.conservativeResize(3); }, go) ==
          "the string has 5 places, 3 velocities and 5 dampings; they must be as many");
    const auto shrink = [](WaveLine& l) { l.y.setZero(1), l.v = l.damping = l.y, l.left = LineEnd::free; };
    CHECK(string(shrink, go) == "the string has 0 intervals; it must have two or more");
    CHECK(string(shrink, turn) == "the string has 0 intervals; it must have two or more");
    CHECK(string([](WaveLine& l) { l.c = infinity; }, turn) ==
          "the speed of its waves is inf m/s; it must be positive and finite");
    SpectralStep sines(WaveLine(4, 4, 1), 0.5, SpectralStep::Of::equation);
    const auto sing = [&](WaveLine& line) { sines.step(line); };
    CHECK(string([](WaveLine&) {}, sing) == "accepted");
    CHECK(string([](WaveLine& l) { l.c = 2; }, sing) ==
          "the string has 4 intervals of 1 m and waves of 2 m/s; the step was made for 4, 1 m and 1 m/s");
    CHECK(string([](WaveLine& l) { l = WaveLine(8, 8, 1); }, sing) ==
          "the string has 8 intervals of 1 m and waves of 1 m/s; the step was made for 4, 1 m and 1 m/s");
    CHECK(string([](WaveLine& l) { l.right = LineEnd::free; }, sing) ==
          "a spectral step in sines needs both ends of the string fixed");
    CHECK(string([](WaveLine& l) { l.damping[2] = 3; }, sing).starts_with("damping[2] is 3 1/s; "));
    CHECK(string([](WaveLine& l) { l.v.conservativeResize(3); }, sing) ==
          "the string has 5 places, 3 velocities and 5 dampings; they must be as many");
    CHECK(sentence_of([] {
              VecX five = VecX::Ones(5);
              SineTransform(8).apply(five);
          }) == "a sine transform of 8 intervals has 5 numbers; it must have one more");
    Membrane skin(4, 4, 1, 1, true);
    skin.v[7] = infinity;
    CHECK(sentence_of([&] { start_leapfrog(skin, 0.5); }) == "v[7] is inf; it must be a finite number");
    skin.v.conservativeResize(3);
    CHECK(sentence_of([&] { leapfrog(skin, 0.5); }) ==
          "the membrane has 25 points, 25 places and 3 velocities; they must be as many");
    CHECK(sentence_of([] { WaveLine(1, 1, 1); }) == "the string has 1 intervals; it must have two or more");
    CHECK(sentence_of([] { WaveLine(4, -1, 1); }) ==
          "the length of the string is -1 m; it must be positive and finite");
    WaveLine line(4, 1, 1);
    ThetaMemory memory;
    CHECK(sentence_of([&] { theta_step(line, 0.1, 0.4, memory); }) ==
          "theta is 0.4; it must be from 1/2 to 1");
    CHECK(sentence_of([&] { leapfrog(line, 0); }) ==
          "the time step h is 0 s; it must be positive and finite");
    line.damping[2] = -1;
    CHECK(sentence_of([&] { require_valid(line); }) == "damping[2] is -1 1/s; it must be zero or positive");
    CHECK(sentence_of([] { SineTransform(12); }) ==
          "a sine transform of 12 intervals; it must be a power of two, from 2");
    line.damping[2] = 0, line.right = LineEnd::free;
    CHECK(sentence_of([&] { SpectralStep(line, 0.1, SpectralStep::Of::masses); }) ==
          "a spectral step in sines needs both ends of the string fixed");
    CHECK(sentence_of([] { Membrane(1, 4, 1, 1, true); }) ==
          "the membrane has 1 by 4 intervals; it must have two or more each way");
    Membrane membrane(4, 4, 1, 1, true);
    CHECK(sentence_of([&] { leapfrog(membrane, 0.8); }) ==
          "the time step is 0.8 s; a wave goes 0.8 intervals in it, and on a grid leapfrog is stable up to "
          "1/sqrt(2)");
    for (const Real damping : {-3.0, static_cast<Real>(NAN)}) {
        Membrane braked(4, 4, 1, 1, true);
        braked.damping = damping;
        CHECK(sentence_of([&] { leapfrog(braked, 0.5); }) ==
              "the damping of the membrane is " + shortest(damping) +
                  " 1/s; it must be zero or positive and finite");
    }
    membrane.nx = 0, membrane.ny = 24;
    CHECK(sentence_of([&] { leapfrog(membrane, 0.5); }) ==
          "the membrane has 0 by 24 intervals; it must have two or more each way");
    CHECK(sentence_of([] { lowest_modes(rectangle_stiffness(3, 3, 1, 1, 1), 2); }) ==
          "2 modes of a matrix of 4 rows and 4 columns; it must be square, and have three rows a mode");
    CHECK(sentence_of([] {
              StiffnessMatrix K = rectangle_stiffness(4, 4, 1, 1, 1);
              lowest_modes(StiffnessMatrix(-K), 1);
          }) == "the stiffness matrix is not positive definite");
    for (const Real entry : {static_cast<Real>(NAN), infinity})
        for (const int at : {3, 48})
            CHECK(sentence_of([&] {
                      StiffnessMatrix K = rectangle_stiffness(8, 8, 1, 1, 1);
                      K.coeffRef(at, at) = entry;
                      lowest_modes(K, 2);
                  }) == "the stiffness matrix is not positive definite");
    CHECK(sentence_of([] { lowest_modes(rectangle_stiffness(8, 8, 1, 1, 1), 2, 1e-10, 0); }) ==
          "inverse iteration has 0 rounds; it must have one or more");
    const Modes early = lowest_modes(rectangle_stiffness(8, 8, 1, 1, 1), 2, 1e-30, 5);
    CHECK(early.rounds == 5);  // those that were made
    CHECK_FALSE(early.solved);
    Tank tank(4, 4, 1, 1, 9.81);
    tank.level[1] = NAN;
    CHECK(sentence_of([&] { tank.step(0.01); }) == "level[1] is nan; it must be a finite number");
    tank.level.setZero(), tank.potential.setZero(3);
    CHECK(sentence_of([&] { tank.step(0.01); }) == "potential has 3 entries; the tank has 4 cells along it");
    CHECK(sentence_of([] { Tank(1, 2, 1, 1, 1); }) ==
          "the tank has 1 by 2 cells; it must have two or more each way");
}
