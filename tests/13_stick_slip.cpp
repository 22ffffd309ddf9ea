/// Chapter 13: two coefficients of friction, small islands solved exactly, and heavy bodies on light ones.

#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/13_friction/slopes.hpp"
#include "chapters/13_friction/stick_slip.hpp"

#include "tests/catch.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

#include <array>

using namespace rigid;

namespace {

/// What a run of the block on the belt shows, from its first slip on.
struct Cycle {
    Real period = 0, largest = -infinity, least = infinity;
    int cycles = 0;
};

template <class Method>
Cycle run_cycles(const StickSlip& block, Method method, Real h, int cycles)
{
    RoughScene scene = block_on_belt(block);
    const StickSlipByHand hand(block);
    StepData<3> now;
    Cycle seen;
    Real first = 0, last = 0;
    bool slid = false;
    const Real end = (hand.balance + hand.beyond) / block.belt + (cycles + 0.1) * hand.period();
    const long steps = std::lround(end / h);
    for (long i = 1; i <= steps; ++i) {
        step(scene, {.h = h}, method, now);
        bool slides = false;
        for (const Slider& slider : method.solver.sliders) slides = slides || slider.slides;
        if (slides && !slid) {
            last = static_cast<Real>(i) * h;
            if (seen.cycles++ == 0) first = last;
        }
        slid = slides;
        if (seen.cycles == 0) continue;
        seen.largest = std::max(seen.largest, scene.bodies.x[0]);
        seen.least = std::min(seen.least, scene.bodies.x[0]);
    }
    if (seen.cycles > 1) seen.period = (last - first) / (seen.cycles - 1);
    return seen;
}

/// A block of 1 kg on a rough floor, its spring of 40 N/m drawn out by x [m].
RoughScene drawn_block(Real x, Real mu_s, Real mu_k)
{
    StickSlip block;
    block.belt = 0;
    block.mu_s = mu_s;
    block.mu_k = mu_k;
    RoughScene scene = block_on_belt(block);
    scene.bodies.x[0] = x;
    return scene;
}

template <class Method>
Real end_of(RoughScene scene, Method method, Real h, int steps)
{
    StepData<3> now;
    for (int i = 0; i < steps; ++i) step(scene, {.h = h}, method, now);
    CHECK(std::abs(scene.bodies.u[0]) <= 1e-3);  // it has come to rest
    return scene.bodies.x[0];
}

/// Towers of one to four boxes apart on one floor, each box with a push of its own.
RoughScene pushed_towers()
{
    RoughScene scene;
    scene.walls.push_back({{0, 1}, 0});
    for (int tower = 0; tower < 4; ++tower)
        for (int i = 0; i <= tower; ++i) {
            const Index k = add_body(scene, box(1, 1), 1 + tower, {4.0 * tower + 0.03 * i, 0.5 + i});
            scene.bodies.velocity(k) << 0.3 * (tower - i), 0, 0.1 * i;
        }
    cover(scene, {.friction = 0.5});
    return scene;
}

}  // namespace

TEST_CASE("a block that a belt drags from its spring sticks and slips with the period and stretch of (13.18)",
          "[idea]")
{
    const Real h = 1.0 / 2000;
    StickSlip far;  // 3 mu_k < mu_s: it is held where it turns around, by more than mu_k could
    far.mu_k = 0.1;
    for (const StickSlip& block : {StickSlip{}, far}) {
        const StickSlipByHand hand(block);
        // The spring is implicit: it takes πωh/2 of the amplitude in half a swing, 0.5 % at ω = 6.3/s and this h, and
        // the events are found to a step.
        for (const Cycle& seen : {run_cycles(block, ExactFriction<AllBodies>{}, h, 3),
                                  run_cycles(block, LemkeFriction<AllBodies>{}, h, 3)}) {
            CHECK(seen.cycles == 4);
            CHECK(std::abs(seen.period / hand.period() - 1) <= 0.005);
            CHECK(std::abs(seen.largest - hand.largest) <= 0.005 * hand.largest);
            CHECK(std::abs(seen.least - hand.least) <= 0.01 * hand.largest);
        }
        // Sweeps hold on until 1e-4 ℓ/s: √(2 · 1e-4 m / (k v)) = 4 ms too long in about a second.
        const Cycle swept = run_cycles(block, FrictionSweeps<AllBodies>{}, h, 3);
        CHECK(std::abs(swept.period / hand.period() - 1) <= 0.01);
        CHECK(std::abs(swept.largest - hand.largest) <= 0.01 * hand.largest);
    }
}

TEST_CASE("the stretch of stick and slip is found to first order in h", "[idea]")
{
    const StickSlip block;
    const StickSlipByHand hand(block);
    std::vector<Real> errors;
    // At the end of the first slip; the times of the events are known to a step, which the mean over a cycle smooths.
    for (const int halvings : {0, 1, 2, 3, 4}) {
        const Real h = 1.0 / (250 << halvings);
        RoughScene scene = block_on_belt(block);
        ExactFriction<AllBodies> method;
        StepData<3> now;
        Real sum = 0;
        const long steps = std::lround(((hand.balance + hand.beyond) / block.belt + hand.period()) / h);
        for (long i = 1; i <= steps; ++i) {
            step(scene, {.h = h}, method, now);
            sum += h * std::abs(scene.bodies.x[0] - hand.stretch(block, static_cast<Real>(i) * h));
        }
        errors.push_back(sum);
    }
    CHECK(order_of(errors) == Approx(1).margin(0.15));
}

TEST_CASE("a block between the two angles stays if it is at rest and slides on if it slides", "[idea]")
{
    // tan 20° = 0.364, between 0.3 and 0.5
    const Real h = 1.0 / 240;
    for (const Real start : {0.0, 0.5}) {
        const auto end = [&](auto method) {
            RoughScene scene = on_a_slope(box(1, 0.5), 0.25, 20, 0.5);
            cover(scene, {.friction = 0.5, .kinetic = 0.3});
            scene.bodies.velocity(0).head<2>() = -start * perpendicular(scene.walls[0].normal);
            StepData<3> now;
            for (int i = 0; i < 240; ++i) step(scene, {.h = h}, method, now);
            return down_the_slope(scene);
        };
        // (13.1) with mu_k, in steps: a t²/2 (1 + h/t) at t = 1 s
        const Real wanted = start > 0 ? start + block_by_hand(20, 0.3) * (1 + h) / 2 : 0;
        CHECK(std::abs(end(ExactFriction<AllBodies>{}) - wanted) <= 1e-9);
        CHECK(std::abs(end(LemkeFriction<AllBodies>{}) - wanted) <= 1e-9);
        // ten sweeps of two corners: a thousandth of the way
        CHECK(std::abs(end(FrictionSweeps<Manifolds>{}) - wanted) <= 1e-3);
        CHECK(std::abs(end(SkippingFriction{}) - wanted) <= 1e-3);
    }
}

TEST_CASE("boxes that hold on a slope are not taken for sliding because sweeps are not finished", "[idea]")
{
    // Two sweeps leave one block, and ten leave three on one another, more speed than counts as creeping; but their
    // friction rows are within their bounds. At 20 degrees mu_s = 0.5 holds and mu_k = 0.3 would not.
    for (const auto& [boxes, sweeps] : {std::pair{1, 2}, {2, 10}, {3, 10}}) {
        RoughScene scene;
        const Real a = 20 * pi / 180;
        const Vec2 up(std::sin(a), std::cos(a));
        scene.walls.push_back({up, 0});
        for (int i = 0; i < boxes; ++i) add_body(scene, box(1, 0.5), 1, up * (0.25 + 0.5 * i), -a);
        cover(scene, {.friction = 0.5, .kinetic = 0.3});
        FrictionSweeps<Manifolds> method;
        method.solver.sweeps.max_sweeps = sweeps;
        StepData<3> now;
        const VecX start = scene.bodies.x;
        for (int i = 0; i < 240; ++i) step(scene, {.h = 1.0 / 240}, method, now);
        // They settle by 0.05 mm; with mu_k they would slide 0.27 m.
        CHECK((scene.bodies.x - start).lpNorm<Eigen::Infinity>() <= 1e-3);
    }
}

TEST_CASE("a drawn block loses twice mu_k m g by k in each half swing and stops where mu_s holds it",
          "[idea]")
{
    // k = 40 N/m, m g = 9.81 N: mu_s = 0.4 holds up to 98 mm, mu_k = 0.1 takes 49 mm in each half swing.
    const Real h = 1.0 / 4000, loss = 2 * 0.1 * 9.81 / 40, held = 0.4 * 9.81 / 40;
    for (const Real x : {0.08, 0.13, 0.17, 0.23}) {
        Real wanted = x;
        for (int swing = 0; swing < 9 && std::abs(wanted) > held; ++swing)
            wanted = -(wanted - (wanted > 0 ? loss : -loss));
        // Implicit springs take πωh/2 = 0.25 % in each half swing of up to 0.23 m; three of them.
        const auto run = [&](auto method) { return end_of(drawn_block(x, 0.4, 0.1), method, h, 10000); };
        CHECK(std::abs(run(ExactFriction<AllBodies>{}) - wanted) <= 2e-3);
        CHECK(std::abs(run(FrictionSweeps<AllBodies>{}) - wanted) <= 2e-3);
    }
}

TEST_CASE("one coefficient and two equal ones give the same bits", "[house]")
{
    const auto end = [](std::optional<Real> kinetic) {
        RoughScene scene = pushed_towers();
        cover(scene, {.friction = 0.5, .kinetic = kinetic});
        ExactFriction<Manifolds> method;
        StepData<3> now;
        for (int i = 0; i < 60; ++i) step(scene, {.h = 1.0 / 60}, method, now);
        CHECK(method.solver.sliders.empty());
        return VecX(scene.bodies.x);
    };
    CHECK(end(std::nullopt) == end(0.5));
}

TEST_CASE("two coefficients that make no sense or that a method does not know are refused", "[house]")
{
    RoughScene scene = on_a_slope(box(1, 1), 0.5, 10, 0.5);
    ExactFriction<AllBodies> method;
    StepData<3> now;
    const auto sentence = [&](const Surface& surface) {
        cover(scene, surface);
        return sentence_of([&] { step(scene, {}, method, now); });
    };
    CHECK(sentence({.friction = 0.3, .kinetic = 0.4}) ==
          "the kinetic friction coefficient of body 0 is 0.4; it must be from zero to the static one, 0.3");
    CHECK(sentence({.friction = 0.3, .kinetic = -0.1}) ==
          "the kinetic friction coefficient of body 0 is -0.1; it must be from zero to the static one, 0.3");
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    CHECK(sentence({.friction = 0.3, .kinetic = nan}) ==
          "the kinetic friction coefficient of body 0 is nan; it must be from zero to the static one, 0.3");
    method.solver.creep = -1;
    CHECK(
        sentence({.friction = 0.3, .kinetic = 0.2}) ==
        "the speed of creeping is -1 lengths of the scene a second; it must be zero or positive, and finite");

    struct Plain {
        WithFriction<AllBodies> contacts;
        Correction correction;
        WarmStart start;
        ImpulseSolver<3> solver;
    } plain;
    const VecX before = scene.bodies.x;
    CHECK(sentence_of([&] { step(scene, {}, plain, now); }) ==
          "a surface has another friction coefficient while it slides; of the solvers only HoldOrSlide takes "
          "it, the "
          "methods of chapter 13");
    CHECK(scene.bodies.x == before);
}

namespace {

/// A solver stage that fails in the first half of a step, and whose slider turns around in the second.
struct FailsFirst : PlainSolver {
    static constexpr bool is_exact = true;
    int solved = 0;
    template <int Dof>
    void solve(Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        if (now.substep == 0 && !now.second_half) unsolved = 0;
        unsolved += !now.second_half;
        bodies.u[0] = std::array{1, -1, 0}[static_cast<std::size_t>(solved++)];
    }
};

}  // namespace

TEST_CASE("a second half that is solved again leaves the failure of the first half", "[house]")
{
    HoldOrSlide<FailsFirst> solver;
    Bodies<3> bodies(1);
    bodies.u[0] = 1;
    StepData<3> now;
    now.contacts.resize(1);
    now.sources = {{Source::Of::contact, 0, 0}, {Source::Of::contact, 0, 1}};
    now.constraints.resize(2);
    now.constraints[1].friction = 0.6, now.constraints[1].weakening = 0.2;
    now.rows.resize(2);
    now.rows[1].Jb = {1, 0, 0};
    now.rows[1].bounded_by = 0;
    now.solution.lambda = VecX::Zero(2);
    solver.solve(bodies, now);
    CHECK(solver.unsolved == 1);
    now.second_half = true;
    solver.solve(bodies, now);
    CHECK(solver.solved == 3);  // it turned around: once more
    CHECK(solver.unsolved == 1);
}

TEST_CASE("islands with friction that are solved one by one give the answer of the whole", "[idea]")
{
    RoughScene together = pushed_towers(), apart = together;
    ExactFriction<Manifolds> whole;
    SkippingFriction islands;
    islands.contacts.sleep = false;
    islands.correction = whole.correction;
    islands.solver.coupled.most_rows = 16;
    islands.solver.sweeps.tolerance = 1e-11;
    StepData<3> now, other;
    for (int i = 0; i < 30; ++i) {
        step(together, {.h = 1.0 / 60}, whole, now);
        step(apart, {.h = 1.0 / 60}, islands, other);
        CHECK(now.solution.status == Status::solved);
        CHECK(other.solution.status == Status::solved);
        CHECK(islands.solver.exact_count == 4);  // one to four boxes: 4, 8, 12 and 16 rows
        CHECK(islands.solver.most_sweeps == 0);
        // Each answers to 1e-11 of speeds of 1 m/s. Stacks whose corners all stick have one u.
        CHECK((together.bodies.u - apart.bodies.u).lpNorm<Eigen::Infinity>() <= 1e-9);
    }
    // with room for two boxes the other two towers are swept, and are as good as their tolerance
    RoughScene mixed = pushed_towers();
    SkippingFriction small;
    small.contacts.sleep = false;
    small.correction = whole.correction;
    small.solver.coupled.most_rows = 8;
    small.solver.sweeps = {.max_sweeps = 20000, .tolerance = 1e-11};
    for (int i = 0; i < 5; ++i) step(mixed, {.h = 1.0 / 60}, small, other);
    CHECK(small.solver.exact_count == 2);
    CHECK(small.solver.most_sweeps > 0);
}

TEST_CASE("a box of a million times the mass rests on three others and every step is solved", "[idea]")
{
    RoughScene scene;
    scene.walls.push_back({{0, 1}, 0});
    for (int i = 0; i < 4; ++i) add_body(scene, box(1, 1), i == 3 ? 1e6 : 1, {0.02 * i, 0.5 + i});
    cover(scene, {.friction = 0.6});
    ExactFriction<Manifolds> method;
    StepData<3> now;
    const VecX start = scene.bodies.x;
    int guesses = 0;
    for (int i = 0; i < 60; ++i) {
        step(scene, {.h = 1.0 / 240}, method, now);
        CHECK(now.solution.status == Status::solved);
        guesses += method.solver.find.memory.work.guesses;
    }
    // impulses of 2e4 N s are doubles of 4e-12 N s, which are as many m/s of a box of 1 kg: 1e-10 m/s in a second
    CHECK((scene.bodies.x - start).lpNorm<Eigen::Infinity>() <= 1e-10);
    CHECK(guesses <= 600);  // 36,308 when no answer was good enough
}
