/// Chapter 9, the step whose repair does no work: its order, what it keeps, and what it says where it can't.

#include "chapters/09_active_sets/linkages.hpp"
#include "chapters/09_active_sets/rattle.hpp"
#include "chapters/10_skipping_work/awake_bodies.hpp"
#include "chapters/10_skipping_work/enter_awake.hpp"
#include "common/measure.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace rigid;

namespace {

Real energy(const DiscScene& scene)
{
    return kinetic_energy(scene.bodies) + potential_energy(scene.bodies, scene.gravity);
}

struct Path {
    VecX x, u;
    Real gain = 0, loss = 0;  ///< of energy, at worst [J]
    Real off = 0;             ///< of links and contacts, at worst [m]
    int unsolved = 0;         ///< steps that do not call themselves solved
};

template <class Method>
Path run(DiscScene scene, Method method, const StepSettings& settings, int steps)
{
    StepData<2> now;
    const Real start = energy(scene);
    Path path;
    for (int n = 0; n < steps; ++n) {
        step(scene, settings, method, now);
        path.gain = std::max(path.gain, energy(scene) - start);
        path.loss = std::max(path.loss, start - energy(scene));
        path.off = std::max({path.off, largest_link_error(scene), deepest_penetration(scene)});
        path.unsolved += now.solution.status != Status::solved;
    }
    path.x = scene.bodies.x;
    path.u = scene.bodies.u;
    return path;
}

/// Two rods of 1 m, the upper one level, the lower one straight down, discs of 1 kg, at rest.
DiscScene double_pendulum() { return linked_discs(2); }

/// The angles of the double pendulum of unit lengths and masses, from straight down, and their rates.
using Angles = std::array<Real, 4>;

Angles rates_of(const Angles& y)
{
    const Real g = 9.81, d = y[0] - y[1], c = std::cos(d), s = std::sin(d);
    // 2 a + c b = −s ω₂² − 2 g sin θ₁,   c a + b = s ω₁² − g sin θ₂
    const Real p = -s * y[3] * y[3] - 2 * g * std::sin(y[0]), q = s * y[2] * y[2] - g * std::sin(y[1]);
    const Real det = 2 - c * c;
    return {y[2], y[3], (p - c * q) / det, (2 * q - c * p) / det};
}

/// By Runge and Kutta's classical method in steps of 1/10000 s: its error is below 1e-12.
Vec2 lower_disc_after(Real seconds)
{
    Angles y = {pi / 2, 0, 0, 0};
    const int steps = static_cast<int>(std::lround(seconds * 10000));
    const Real h = seconds / steps;
    const auto moved = [](Angles a, const Angles& b, Real t) {
        for (std::size_t i = 0; i < 4; ++i) a[i] += t * b[i];
        return a;
    };
    for (int n = 0; n < steps; ++n) {
        const Angles k1 = rates_of(y), k2 = rates_of(moved(y, k1, h / 2)), k3 = rates_of(moved(y, k2, h / 2)),
                     k4 = rates_of(moved(y, k3, h));
        for (std::size_t i = 0; i < 4; ++i) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    return {std::sin(y[0]) + std::sin(y[1]), -std::cos(y[0]) - std::cos(y[1])};
}

struct Orders {
    Real position = 0, energy = 0;
};

/// Of a method on the double pendulum, a second long, from four halvings of 1/60 s.
template <class Method>
Orders orders(const Method& method, int substeps = 1)
{
    const Vec2 exact = lower_disc_after(1);
    std::vector<Real> h, position, drift;
    for (const int per_second : {60, 120, 240, 480, 960}) {
        const Path path =
            run(double_pendulum(), method, {.h = 1.0 / per_second, .substeps = substeps}, per_second);
        CHECK(path.unsolved == 0);
        h.push_back(1.0 / per_second);
        position.push_back((path.x.tail<2>() - exact).norm());
        drift.push_back(std::max(path.gain, path.loss));
    }
    return {slope(h, position), slope(h, drift)};
}

ExactMethod by_exact_split()
{
    ExactMethod method;
    method.correction = exact_correction();
    return method;
}

}  // namespace

TEST_CASE("one step of a rod that falls from level is RATTLE's in closed form", "[house]")
{
    // (9.27): u½ = −gh/2 downwards and λ along the rod; x' on the circle with y' = −gh²/2; then half of gravity, and the
    // velocity along the rod goes.
    DiscScene scene = linked_discs(1);
    RattleMethod method;
    StepData<2> now;
    const Real h = 0.1, g = 9.81;
    step(scene, {.h = h}, method, now);
    const Real y = -g * h * h / 2, x = std::sqrt(1 - y * y);
    const Vec2 half((x - 1) / h, -g * h / 2), u = half + Vec2(0, -g * h / 2), n(x, y);
    const Vec2 along = u - n * n.dot(u);
    // Newton's method ends at 1e-12 m; in the velocity that is 1e-11 m/s.
    CHECK((scene.bodies.position(1) - n).norm() < 2e-12);
    CHECK((scene.bodies.velocity(1) - along).norm() < 5e-11);
    CHECK(now.solution.status == Status::solved);
    CHECK(method.correction.repairs == 0);
}

TEST_CASE("a rod that turns without gravity keeps its energy to rounding with RATTLE and loses sin² of its "
          "angle with the split")
{
    DiscScene scene = linked_discs(1);
    scene.gravity = {0, 0};
    scene.bodies.velocity(1) = Vec2(0, 3);
    const StepSettings settings{.h = 1.0 / 60};
    const Path rattle = run(scene, RattleMethod{}, settings, 600);
    CHECK(rattle.unsolved == 0);
    CHECK(std::max(rattle.gain, rattle.loss) <
          1e-8);  // 600 times Newton's 1e-12 m, as velocities of 6e-11 m/s
    StepData<2> now;
    ExactMethod split = by_exact_split();
    step(scene, settings, split, now);
    step(scene, settings, split, now);
    // tan θ = hu/L = 0.05: u² cos²θ is left of u² when the second step begins.
    CHECK(energy(scene) == Approx(4.5 / (1 + 0.05 * 0.05)).epsilon(1e-5));
}

TEST_CASE("RATTLE is of second order on the double pendulum in position and in energy", "[house]")
{
    const Orders found = orders(RattleMethod{});
    CHECK(found.position == Approx(2).margin(0.15));
    CHECK(found.energy == Approx(2).margin(0.15));
    const Orders in_four = orders(RattleMethod{}, 4);
    CHECK(in_four.position == Approx(2).margin(0.15));
    CHECK(in_four.energy == Approx(2).margin(0.15));
    // The exact split corrects as exactly, and is of first order at best.
    CHECK(orders(by_exact_split()).position < 1.15);
}

TEST_CASE("a four-bar linkage of 30.9 J keeps its energy for ten seconds with RATTLE and loses it with the "
          "exact split")
{
    ExactMethod whole;
    whole.correction.method = Stabilizer::baumgarte;
    whole.correction.beta = 1;
    REQUIRE(energy(four_bar()) == Approx(30.9));
    std::vector<Real> h, drift;
    for (const int per_second : {60, 120, 240, 480, 960}) {
        const StepSettings settings{.h = 1.0 / per_second};
        const Path rattle = run(four_bar(), RattleMethod{}, settings, 10 * per_second);
        const Path split = run(four_bar(), by_exact_split(), settings, 10 * per_second);
        const Path errors = run(four_bar(), whole, settings, 10 * per_second);
        INFO("h = 1/" << per_second << " s");
        CHECK(rattle.unsolved == 0);
        CHECK(rattle.off < 1e-11);
        CHECK(rattle.loss < errors.loss);
        CHECK(20 * rattle.loss < errors.loss + errors.gain);
        CHECK(split.gain < 1e-9);
        CHECK(100 * rattle.loss < split.loss);
        h.push_back(settings.h);
        drift.push_back(rattle.loss + rattle.gain);
    }
    CHECK(drift.front() < 0.08);   // J: 0.23 % of 30.9 J, at 1/60 s
    CHECK(drift.back() < 0.0003);  // and at 1/960 s
    CHECK(slope(h, drift) == Approx(2).margin(0.15));
}

TEST_CASE("a chain that swings for ten seconds keeps its links to rounding and its energy within a bound "
          "that falls with h squared")
{
    // Ten links of 0.1 m without contacts: lashing, with angles that turn by a radian in 1/240 s.
    DiscScene chain = swinging_chain(10);
    chain.linked = PairSet::all();
    for (const int per_second : {480, 960, 1920}) {
        const Path path = run(chain, RattleMethod{}, {.h = 1.0 / per_second}, 10 * per_second);
        INFO("h = 1/" << per_second << " s");
        CHECK(path.unsolved == 0);
        CHECK(path.off < 1e-11);
        // 49 J go up and down. The path is chaotic, so the bound is one of size: 0.46 J at 1/960 s.
        CHECK(path.loss + path.gain < 49 * 0.05 * std::pow(480.0 / per_second, 2) + 1e-3);
    }
}

TEST_CASE("free linked discs keep linear and angular momentum under RATTLE", "[house]")
{
    DiscScene scene = swinging_chain(6);
    scene.linked = PairSet::all();
    scene.bodies.inverse_mass.setOnes();
    scene.gravity = {0, 0};
    Random random(3);
    for (Real& entry : scene.bodies.u) entry = random.uniform(-1, 1);
    // The velocities that the links allow.
    RattleMethod method;
    StepData<2> now;
    step(scene, {.h = 1e-3}, method, now);
    const Vec2 p = momentum(scene.bodies);
    const Real L = angular_momentum(scene.bodies), E = energy(scene);
    for (int n = 0; n < 500; ++n) {
        step(scene, {.h = 1.0 / 240, .substeps = 2}, method, now);
        REQUIRE(now.solution.status == Status::solved);
    }
    CHECK((momentum(scene.bodies) - p).norm() < 1e-12);  // rounding of 1000 sub-steps
    // A repair moves discs of 1 m/s by some 1e-12 m and leaves their velocity; 1000 sub-steps may each have one.
    CHECK(std::abs(angular_momentum(scene.bodies) - L) < 1e-9);
    CHECK(energy(scene) == Approx(E).epsilon(1e-2));
}

TEST_CASE("run backwards RATTLE comes back to where it began", "[house]")
{
    DiscScene scene = double_pendulum();
    RattleMethod method;
    StepData<2> now;
    const VecX start = scene.bodies.x;
    for (int n = 0; n < 60; ++n) step(scene, {.h = 1.0 / 120}, method, now);
    CHECK((scene.bodies.x - start).norm() > 0.5);
    scene.bodies.u *= -1;
    for (int n = 0; n < 60; ++n) step(scene, {.h = 1.0 / 120}, method, now);
    // Newton's 1e-12 m of each step, as a velocity, grown by the pendulum's own sensitivity.
    CHECK((scene.bodies.x - start).norm() < 1e-7);
}

TEST_CASE("with contacts RATTLE stands still where a pile stands and lands without a bounce", "[house]")
{
    for (const int substeps : {1, 4}) {
        const StepSettings settings{.h = 1.0 / 60, .substeps = substeps};
        const Path pile = run(triangle(4), RattleMethod{}, settings, 120);
        CHECK(pile.unsolved == 0);
        CHECK(pile.off < 1e-11);
        CHECK(pile.u.cwiseAbs().maxCoeff() < 1e-9);
        CHECK((pile.x - triangle(4).bodies.x).cwiseAbs().maxCoeff() < 1e-9);
        const Path heavy = run(column_between_walls(10, 1000), RattleMethod{}, settings, 120);
        CHECK(heavy.unsolved == 0);
        CHECK(heavy.off < 1e-9);

        // The ten discs fall 0.4 m and stay out of each other; an impact only takes energy away.
        const Path ten = run(ten_discs(), RattleMethod{}, {.h = 1.0 / 480, .substeps = substeps}, 960);
        CHECK(ten.unsolved == 0);
        CHECK(ten.off < 1e-9);
        CHECK(ten.gain < 1e-9);
        CHECK(ten.loss > 1);
    }
}

TEST_CASE("a disc that falls on a floor bounces with RATTLE by its restitution and stops with none",
          "[house]")
{
    DiscScene fall = column(1);
    fall.bodies.position(0).y() += 1;
    for (const Real e : {0.0, 0.5, 1.0}) {
        DiscScene scene = fall;
        RattleMethod method;
        method.correction.restitution = e;
        StepData<2> now;
        Real before = 0, after = 0;
        for (int n = 0; n < 600 && !(after > 0); ++n) {
            before = scene.bodies.velocity(0).y();
            step(scene, {.h = 1.0 / 480}, method, now);
            if (scene.bodies.velocity(0).y() > before) {
                after = scene.bodies.velocity(0).y();
                break;
            }
        }
        CHECK(before == Approx(-std::sqrt(2 * 9.81)).epsilon(0.01));
        CHECK(after == Approx(-e * before).margin(1e-9));
        CHECK(deepest_penetration(scene) < 1e-11);
    }
}

TEST_CASE("an overlap that was there before RATTLE is moved out and leaves no velocity", "[house]")
{
    DiscScene scene = column(3);
    scene.gravity = {0, 0};
    scene.bodies.position(2).y() -= 0.01;
    scene.bodies.position(1).y() -= 0.004;
    RattleMethod method;
    StepData<2> now;
    step(scene, {.h = 1.0 / 60}, method, now);
    CHECK(method.correction.repairs == 1);
    CHECK(now.solution.status == Status::solved);
    CHECK(deepest_penetration(scene) < 1e-12);
    CHECK(scene.bodies.u.cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("rods that contradict each other are called unsolved by RATTLE and nothing explodes", "[house]")
{
    DiscScene scene = linked_discs(2);
    scene.links.push_back(Link{0, 1, 1.2});
    RattleMethod method;
    StepData<2> now;
    const Real start = energy(scene);
    int unsolved = 0;
    for (int n = 0; n < 240; ++n) {
        step(scene, {.h = 1.0 / 120}, method, now);
        unsolved += method.solver.unsolved > 0 && now.solution.status != Status::solved;
        REQUIRE(energy(scene) < start + 1);
    }
    CHECK(unsolved == 240);
    CHECK(largest_link_error(scene) < 0.13);  // half of 0.2 m: both win a part
}

TEST_CASE("a rod that turns further than a step can follow is said not to converge", "[house]")
{
    DiscScene scene = linked_discs(1);
    scene.bodies.velocity(1) = Vec2(0, 200);  // 3.3 rad in a step; there is no x' on M⁻¹Jᵀ
    RattleMethod method;
    StepData<2> now;
    step(scene, {.h = 1.0 / 60}, method, now);
    CHECK(now.solution.status == Status::iteration_limit);
    CHECK(method.correction.not_converged == 1);
    CHECK(scene.bodies.u.allFinite());
    CHECK(kinetic_energy(scene.bodies) <= 0.5 * 200 * 200 + 1);
    for (int n = 0; n < 100; ++n) step(scene, {.h = 1.0 / 60}, method, now);
    CHECK(kinetic_energy(scene.bodies) <= 0.5 * 200 * 200 + 20);
}

TEST_CASE("a pile that sleeps under RATTLE stays where it is and wakes by a push", "[house]")
{
    struct Sleeping {
        AwakeBodies contacts;
        Rattle correction;
        ColdStart start;
        ExactSolver solver;
    };
    DiscScene scene = triangle(3);
    Sleeping method;
    method.contacts.reset(scene, filter_of(scene));
    StepData<2> now;
    const VecX start = scene.bodies.x;
    for (int n = 0; n < 120; ++n) step(scene, {.h = 1.0 / 60}, method, now);
    for (Index k = 0; k < scene.bodies.count(); ++k) CHECK(method.contacts.set.is_asleep(k));
    CHECK((scene.bodies.x - start).cwiseAbs().maxCoeff() < 1e-9);
    // What it remembers is the force of the whole sub-step: three columns' worth of weight on the floor.
    Real force = 0;
    for (std::size_t i = 0; i < now.sources.size(); ++i)
        if (now.sources[i].of == Source::Of::contact &&
            now.contacts[static_cast<std::size_t>(now.sources[i].index)].a == world &&
            now.contacts[static_cast<std::size_t>(now.sources[i].index)].normal.y() > 0.5)
            force += now.solution.lambda[static_cast<Index>(i)] * 60;
    CHECK(force == Approx(6 * 9.81));
}

TEST_CASE("RATTLE refuses settings that make no sense", "[house]")
{
    const auto say = [](auto change) {
        return sentence_of([&] {
            DiscScene scene = column(1);
            RattleMethod method;
            change(method.correction);
            StepData<2> now;
            step(scene, {}, method, now);
        });
    };
    CHECK(say([](Rattle& r) { r.tolerance = 0; }) ==
          "the tolerance of the positions is 0; it must be positive and finite");
    CHECK(say([](Rattle& r) { r.tolerance = infinity; }) ==
          "the tolerance of the positions is inf; it must be positive and finite");
    CHECK(say([](Rattle& r) { r.max_iterations = 0; }) ==
          "max_iterations of the positions is 0; it must be 1 or more");
    CHECK(say([](Rattle& r) { r.restitution = 2; }) == "the restitution is 2; it must be from 0 to 1");
    DiscScene scene = column(1);
    RattleMethod method;
    StepData<2> now;
    CHECK(sentence_of([&] { step(scene, {.h = 0}, method, now); }) ==
          "the time step h is 0 s; it must be positive and finite");
}
