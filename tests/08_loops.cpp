/// Chapter 8, loops of rods and impacts: what a remembered impulse must not do to the energy.

#include "chapters/04_pgs/rates.hpp"
#include "chapters/08_warm_starting/looped_trusses.hpp"
#include "chapters/08_warm_starting/memory_rates.hpp"
#include "chapters/08_warm_starting/small_steps.hpp"
#include "chapters/08_warm_starting/warm_method.hpp"
#include "common/measure.hpp"

#include "tests/catch.hpp"
#include "tests/eigenvalues.hpp"

#include <Eigen/LU>

namespace rigid::loops_tests {

constexpr Stabilizer outside_of_the_impulses[] = {Stabilizer::none, Stabilizer::split_impulse,
                                                  Stabilizer::projection};

/// A step with its method.
struct WarmSteps {
    StepSettings settings;
    WarmMethod method;
    StepData<2> now;

    WarmSteps(Start start, int sweeps, Stabilizer correction = Stabilizer::none)
    {
        settings.h = 1.0 / 480;
        method.start.from = start;
        method.solver.sweeps.max_sweeps = sweeps;
        method.correction.method = correction;
    }
    void operator()(DiscScene& scene) { step(scene, settings, method, now); }
};

/// A in the order of the visits.
MatX matrix_of(const std::vector<Row<2>>& rows, const std::vector<int>& order, Index numbers)
{
    const auto m = static_cast<Index>(rows.size());
    const auto row = [&](Index i) -> const Row<2>& {
        const auto place = static_cast<std::size_t>(i);
        return rows[order.empty() ? place : static_cast<std::size_t>(order[place])];
    };
    MatX A(m, m);
    for (Index j = 0; j < m; ++j) {
        VecX change = VecX::Zero(numbers);
        row(j).apply(1, change);
        for (Index i = 0; i < m; ++i) A(i, j) = row(i).velocity(change) - row(i).bias;
    }
    return A;
}

constexpr bool forwards = false, backwards = true;

/// What a sweep leaves of the error of λ: G, and the same for a sweep backwards.
MatX sweep_matrix(const MatX& A, bool way)
{
    MatX triangle = A.triangularView<Eigen::Lower>();
    if (way == backwards) triangle = A.triangularView<Eigen::Upper>();
    return MatX::Identity(A.rows(), A.cols()) - triangle.partialPivLu().solve(A);
}

/// The greatest rise of the kinetic energy above an earlier value, as a part of what there was at the beginning.
template <class Step>
Real energy_gained(DiscScene scene, int steps, const Step& step)
{
    const Real began = kinetic_energy(scene.bodies);
    Real least = began, gained = 0;
    for (int n = 0; n < steps; ++n) {
        step(scene);
        const Real energy = kinetic_energy(scene.bodies);
        if (!std::isfinite(energy)) return infinity;
        gained = std::max(gained, energy - least);
        least = std::min(least, energy);
    }
    return gained / began;
}

Real gained_in_small_steps(const DiscScene& scene, const SmallStepSettings& settings, int steps)
{
    SmallStep now;
    return energy_gained(scene, steps, [&](DiscScene& s) { small_steps(s, settings, now); });
}

Real gained_in_warm_steps(const DiscScene& scene, WarmSteps& warm, int steps)
{
    return energy_gained(scene, steps, [&](DiscScene& s) { warm(s); });
}

/// By (8.15) nothing; rounding errors of 1e-16 in each visit of up to 9600 sweeps over 30 rows.
constexpr Real rounding = 1e-11;

/// Presets and orders in turns, 100 to 600 steps, at 1 m/s and at 1e-6 m/s; where the truss turns by much and where
/// its rows stay.
/// \return  trusses whose energy rose
int trusses_that_gain(int count, std::uint64_t seed, Real& most)
{
    Random random(seed);
    int gained = 0;
    most = 0;
    for (int sample = 0; sample < count; ++sample) {
        DiscScene scene = looped_truss(random);
        SmallStepSettings settings = sample % 2 ? careful_steps() : quick_steps();
        settings.coloured = sample % 4 < 2;
        if (sample % 8 < 4) scene.bodies.u *= 1e-6;
        const Real energy = gained_in_small_steps(scene, settings, 100 * (1 + sample % 6));
        gained += energy > rounding ? 1 : 0;
        most = std::max(most, energy);
    }
    return gained;
}

TEST_CASE("a matrix of huge numbers has its own largest factor and one of no numbers has none", "[house]")
{
    const MatX turn{{0.6, -0.8}, {0.8, 0.6}};
    for (const Real size : {1e-200, 1.0, 1e200})
        CHECK(spectral_radius(MatX(size * turn)) == Approx(size).epsilon(1e-12));
    CHECK(spectral_radius(MatX::Zero(2, 2).eval()) == 0);
    CHECK(std::isnan(spectral_radius(MatX(std::nan("") * turn))));
    CHECK(std::isnan(memory_rate(std::nan("") * turn)));
}

TEST_CASE("a remembered start settles for complex modes exactly where (8.14) says", "[idea]")
{
    Random random(87);
    int settled = 0;
    for (int sample = 0; sample < 20000; ++sample) {
        const Real radius = random.uniform(0, 1.1), angle = random.uniform(-pi, pi);
        const std::complex<Real> gamma = std::polar(radius, angle);
        const std::complex<Real> root = std::sqrt(gamma * gamma - gamma);  // (8.7)
        const Real largest = std::max(std::abs(gamma + root), std::abs(gamma - root));
        if (std::abs(largest - 1) < 1e-9) continue;  // on the border both sides are right
        REQUIRE(memory_settles(gamma) == (largest < 1));
        settled += largest < 1 ? 1 : 0;
    }
    CHECK(settled > 2000);
    CHECK(settled < 15000);
    for (Real gamma = 0; gamma < 1; gamma += 0.01) CHECK(memory_settles(gamma));  // chains, columns
    CHECK(memory_settles(-0.333));
    CHECK(!memory_settles(-0.334));
    CHECK(memory_settles({0.963, 0.004}));
    CHECK(!memory_settles({0.96323, 0.01192}));  // the five discs
}

TEST_CASE(
    "five discs in loops explode from one sweep a step as (8.6) predicts and settle from a best multiple",
    "[idea]")
{
    for (const Order order : {Order::given, Order::coloured}) {
        CAPTURE(to_string(order));
        DiscScene scene = five_discs_in_loops();
        WarmSteps warm(Start::previous, 1), best(Start::best_multiple, 1);
        warm.method.solver.ordering = best.method.solver.ordering = order;
        warm(scene);
        const MatX A = matrix_of(warm.now.rows, warm.method.solver.order, scene.bodies.u.size());
        const MatX G = sweep_matrix(A, forwards);
        const Real theory = memory_rate(G);
        bool all_settle = true, complex = false;
        const Eigen::VectorXcd modes = eigenvalues(G);
        for (const std::complex<Real>& mode : modes) {
            CHECK(std::abs(mode) < 1);  // the sweeps alone converge
            all_settle = all_settle && memory_settles(mode);
            complex = complex || std::abs(mode.imag()) > 1e-3;
        }
        CHECK(complex);
        CHECK(!all_settle);
        CHECK(theory > 1.01);

        // The mode turns as it grows: compare peaks over whole swings, of some 35 steps.
        Real early = 0, late = 0;
        for (int n = 1; n < 700; ++n) {
            warm(scene);
            const Real speed = scene.bodies.u.norm();
            if (n >= 200 && n < 300) early = std::max(early, speed);
            if (n >= 600) late = std::max(late, speed);
        }
        CHECK(std::pow(late / early, 1.0 / 400) == Approx(theory).epsilon(1e-3));

        CHECK(gained_in_warm_steps(five_discs_in_loops(), best, 700) < rounding);
    }
}

TEST_CASE("a sweep there and back has real modes from 0 to 1 so that memory settles in loops too", "[idea]")
{
    Random random(88);
    int complex_modes = 0;
    for (int sample = 0; sample < 200; ++sample) {
        DiscScene scene = sample ? looped_truss(random) : five_discs_in_loops();
        scene.bodies.u *= 1e-6;
        WarmSteps cold(Start::cold, 1);
        cold(scene);
        const MatX A = matrix_of(cold.now.rows, {}, scene.bodies.u.size());
        const MatX there = sweep_matrix(A, forwards), back = sweep_matrix(A, backwards);
        const Eigen::VectorXcd once = eigenvalues(there), twice = eigenvalues(back * there);
        for (const std::complex<Real>& mode : once) complex_modes += std::abs(mode.imag()) > 1e-6 ? 1 : 0;
        CAPTURE(sample);
        for (const std::complex<Real>& mode : twice) {
            // Redundant rods: modes of 1, which move nothing. Where several are equal the square root of rounding.
            CHECK(std::abs(mode.imag()) < 1e-7);
            CHECK(mode.real() > -1e-7);
            CHECK(mode.real() < 1 + 1e-7);
        }
    }
    CHECK(complex_modes > 200);

    // Two sweeps of an alternating order are one there and one back. One sweep a step, in turns there and back, is not:
    // the five discs explode all the faster.
    WarmSteps warm(Start::previous, 2);
    warm.method.solver.ordering = Order::alternating;
    DiscScene scene = five_discs_in_loops();
    const Real began = kinetic_energy(scene.bodies);
    for (int n = 0; n < 2000; ++n) warm(scene);
    CHECK(kinetic_energy(scene.bodies) < began);
}

TEST_CASE("no truss with loops gains energy in small steps", "[idea]")
{
    Real most = 0;
    CHECK(trusses_that_gain(300, 89, most) == 0);
    CHECK(most < rounding);
    SmallStepSettings settings = quick_steps();
    CHECK(gained_in_small_steps(five_discs_in_loops(), settings, 600) < rounding);
}

TEST_CASE("ten thousand trusses with loops and none gains energy in small steps", "[.whole][idea]")
{
    Real most = 0;
    CHECK(trusses_that_gain(10000, 90, most) == 0);
    WARN("the greatest gain of 10000 trusses is " << most << " of the energy at the start");
}

TEST_CASE("no truss with loops gains energy in warm steps from a best multiple", "[idea]")
{
    Random random(91);
    for (int sample = 0; sample < 200; ++sample) {
        const DiscScene scene = looped_truss(random);
        WarmSteps warm(Start::best_multiple, 1 + sample % 4, outside_of_the_impulses[sample % 3]);
        warm.method.solver.ordering = static_cast<Order>(sample / 3 % 4);
        warm.settings.substeps = 1 + sample % 2 * 7;
        CAPTURE(sample);
        CHECK(gained_in_warm_steps(scene, warm, 100) < rounding);
    }
}

/// A disc of 1 kg over a groove whose walls rise at this angle, `above` its place of rest.
DiscScene groove(Real degrees, Real above)
{
    const Real angle = degrees * pi / 180, c = std::cos(angle), s = std::sin(angle);
    DiscScene scene;
    scene.bodies = Bodies<2>(1);
    scene.bodies.inverse_mass.setOnes();
    scene.radius = VecX::Constant(1, 0.1);
    scene.walls = {{{s, c}, 0}, {{-s, c}, 0}};
    scene.bodies.position(0) << 0, 0.1 / c + above;
    return scene;
}

/// How far a disc rises that has fallen into a groove, and how fast: both as parts of the fall.
struct Rise {
    Real height = 0, energy = 0;
};
Rise rise_from_groove(Real degrees, Real fall, const SmallStepSettings& settings)
{
    DiscScene scene = groove(degrees, fall);
    const Real rest = groove(degrees, 0).bodies.position(0).y(), speed = std::sqrt(2 * 9.81 * fall);
    SmallStep now;
    Rise rise;
    bool falling = false, arrived = false;
    for (int n = 0; n < 200; ++n) {
        small_steps(scene, settings, now);
        if (arrived) {
            rise.height = std::max(rise.height, (scene.bodies.position(0).y() - rest) / fall);
            rise.energy = std::max(rise.energy, std::max(Real{0}, scene.bodies.u[1]) / speed);
        }
        falling = falling || scene.bodies.u[1] < -0.9 * speed;
        arrived = arrived || (falling && scene.bodies.u[1] > -0.9 * speed);
    }
    CHECK(arrived);
    rise.energy *= rise.energy;
    return rise;
}

TEST_CASE("a disc that falls into a groove without restitution rises by what one sweep leaves", "[idea]")
{
    // The fall is varied so that the impact comes at any part of a substep.
    for (const Real degrees : {1, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60, 65, 70, 75, 80, 85, 89})
        for (const bool careful : {false, true}) {
            SmallStepSettings settings = careful ? careful_steps() : quick_steps();
            CAPTURE(degrees, careful);
            const Real a = degrees * pi / 180, left = std::sin(a) * std::cos(2 * a);
            const Real one_sweep = degrees < 45 ? left * left : 0;  // (8.16)
            Rise most;
            for (int phase = 0; phase < 8; ++phase) {
                const Rise rise = rise_from_groove(degrees, 1 + 0.01 * phase, settings);
                most.height = std::max(most.height, rise.height);
                most.energy = std::max(most.energy, rise.energy);
            }
            // What was remembered adds up to 1.6 % of the fall (steep grooves; up to twice the best multiple may be
            // taken, which keeps what energy is left), 2 % of the energy. The whole impulse gave back 35 %.
            CHECK(most.height < one_sweep + 0.02);
            CHECK(most.energy < one_sweep + 0.025);
            // and (8.16) is what there is, where the impact comes within a substep: no bound out of reach
            if (degrees > 5 && degrees < 35) CHECK(most.height > 0.9 * one_sweep);
            settings.sweeps = 10;
            if (degrees < 45) CHECK(rise_from_groove(degrees, 1, settings).height < 0.01);
        }
}

TEST_CASE("a disc that arrives in a groove with its first step does not leave it", "[idea]")
{
    // Remembered as a load, the impulse of the impact threw it back at up to 3.2 times its speed.
    for (const Real degrees : {60, 70, 80, 85})
        for (const SmallStepSettings& settings : {quick_steps(), careful_steps()}) {
            CAPTURE(degrees, settings.substeps);
            DiscScene scene = groove(degrees, 0);
            scene.bodies.velocity(0) << 0, -1;
            const Real rest = scene.bodies.position(0).y();
            SmallStep now;
            for (int n = 0; n < 300; ++n) {
                small_steps(scene, settings, now);
                // 4 % of the speed was seen (0.2 % of the energy), where the whole impulse gave back 14 to 310 %
                REQUIRE(scene.bodies.u[1] < 0.25);
                REQUIRE(scene.bodies.position(0).y() - rest < 0.015);
            }
        }
}

/// Discs of up to 10⁴ : 1 kg that fly at each other and at the walls of a box, some of them linked.
DiscScene crash(Random& random)
{
    DiscScene scene;
    const Index count = 3 + random.index(10);
    scene.bodies = Bodies<2>(count);
    scene.radius = VecX::Constant(count, 0.1);
    for (Index k = 0; k < count; ++k) {
        const Real x = static_cast<Real>(k % 3) - 1, y = static_cast<Real>(k / 3) - 1;
        scene.bodies.position(k) << 0.3 * x, 0.3 * y;
        const Real vx = random.uniform(-5, 5), vy = random.uniform(-5, 5);
        scene.bodies.velocity(k) << vx, vy;
        scene.bodies.inverse_mass.segment<2>(2 * k).setConstant(std::pow(10, random.uniform(-2, 2)));
    }
    for (Index k = 0; k + 1 < count; ++k)
        if (random.index(3) == 0)
            scene.links.push_back(
                {k, k + 1, (scene.bodies.position(k + 1) - scene.bodies.position(k)).norm()});
    link_neighbours(scene);
    const Real angle = random.uniform(0, 1.4);  // two of the walls make a groove
    scene.walls = {{{std::sin(angle), std::cos(angle)}, -1},
                   {{-std::sin(angle), std::cos(angle)}, -1},
                   {{0, -1}, -1},
                   {{1, 0}, -1},
                   {{-1, 0}, -1}};
    scene.gravity = {0, 0};
    return scene;
}

TEST_CASE("no impact without restitution gains energy whatever hits and whatever remembers", "[idea]")
{
    Random random(92);
    for (int sample = 0; sample < 300; ++sample) {
        DiscScene scene = sample % 3 ? crash(random) : looped_truss(random);
        if (sample % 3 == 0) {  // a truss that flies into a corner and whose discs collide
            scene.walls = {{{0, 1}, -1.2}, {{1, 0}, -1.2}};
            scene.linked.clear();
            link_neighbours(scene);
            scene.bodies.u.array() -= 2;
        }
        SmallStepSettings small = sample % 2 ? careful_steps() : quick_steps();
        small.coloured = sample % 4 < 2;
        CAPTURE(sample);
        CHECK(gained_in_small_steps(scene, small, 120) < rounding);
        WarmSteps warm(Start::best_multiple, 1 + sample % 5, outside_of_the_impulses[sample % 3]);
        warm.settings.h = 1.0 / 60;
        warm.settings.substeps = 1 + sample % 4;
        warm.method.solver.ordering = static_cast<Order>(sample / 2 % 4);
        CHECK(gained_in_warm_steps(scene, warm, 120) < rounding);
    }
}

TEST_CASE("every multiple that a rule allows has a merit of zero at most", "[idea]")
{
    Random random(93);
    for (int sample = 0; sample < 1000; ++sample) {
        const Real curvature = std::pow(10, random.uniform(-9, 9));
        const Real best = random.uniform(-0.5, 3);
        const Real near_one = random.uniform(), greatest = random.uniform(1, 4);
        const MultipleRule rule = {near_one, greatest};
        const Real slope = -best * curvature, s = multiple_of(slope, curvature, rule);
        CHECK(s * slope + s * s * curvature / 2 <= 1e-15 * curvature);
        CHECK(s >= 0);
        CHECK(s <= rule.most);
    }
    CHECK(multiple_of(-1.01, 1, {}) == 1.01);
    CHECK(multiple_of(-1.01, 1, {0.05, 10}) == 1);
    CHECK(multiple_of(-0.96, 1, {0.05, 10}) == 1);
    CHECK(multiple_of(-0.75, 1, {0.25, 10}) == 1);
    CHECK(multiple_of(-0.5, 1, {0.25, 10}) == 0.75);
    CHECK(multiple_of(-0.125, 1, {0.25, 10}) == 0.25);
    CHECK(multiple_of(-2, 1, {0.25, 10}) == 1.75);
    CHECK(multiple_of(-20, 1, {0, 10}) == 10);
    CHECK(multiple_of(-20, 1, {}, 1) == 1);
    CHECK(multiple_of(0, 0, {}) == 1);
}

TEST_CASE("up to a hundred million kilograms on four discs sink by centimetres and nothing rises", "[idea]")
{
    for (const Stabilizer method : outside_of_the_impulses)
        for (int power = -9; power <= 8; ++power) {
            CAPTURE(to_string(method), power);
            DiscScene scene = column_between_walls(5, std::pow(10, power), 0.001);
            WarmSteps warm(Start::best_multiple, 10, method);
            warm.settings.h = 1.0 / 60;
            warm.method.correction.beta = 1;
            warm.method.correction.slop = 0.0005;
            const VecX began = scene.bodies.x;
            Real highest = -1, lowest = 1;
            for (int n = 0; n < 600; ++n) {
                warm(scene);
                highest = std::max(highest, (scene.bodies.x - began).maxCoeff());
                lowest = std::min(lowest, (scene.bodies.x - began).minCoeff());
            }
            CHECK(highest < 1e-6);
            CHECK(lowest > -0.03);  // what the cold first step sinks by: (8.8) of a column with such a top
            CHECK(scene.bodies.u.lpNorm<Eigen::Infinity>() < 1e-6);
        }
}

TEST_CASE("rules of multiples that make no sense are refused", "[house]")
{
    const auto sentence = [](const MultipleRule& rule) -> std::string {
        DiscScene scene = column(2);
        SmallStepSettings settings;
        settings.start = rule;
        SmallStep now;
        try {
            small_steps(scene, settings, now);
        } catch (const std::invalid_argument& refused) {
            return refused.what();
        }
        return "accepted";
    };
    CHECK(sentence({0.5, infinity}) == "accepted");
    CHECK(sentence({-0.6, 10}).find("near_one is -0.6") != std::string::npos);
    CHECK(sentence({0.1, 0.5}).find("0.5") != std::string::npos);
    CHECK(sentence({std::nan(""), 10}).find("near_one") != std::string::npos);
}

}  // namespace rigid::loops_tests
