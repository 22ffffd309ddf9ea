/// Chapter 26: contacts as springs, one impulse at a time, and at the level of accelerations.

#include "tests/catch.hpp"
#include "tests/limit.hpp"
#include "tests/no_allocation.hpp"
#include "tests/sentence.hpp"

#include "chapters/12_contact_manifolds/chains.hpp"
#include "chapters/13_friction/friction_problems.hpp"
#include "chapters/13_friction/slopes.hpp"
#include "chapters/26_four_ways/acceleration_level.hpp"
#include "chapters/26_four_ways/reduced_motion.hpp"
#include "chapters/26_four_ways/single_impulses.hpp"
#include "chapters/26_four_ways/spring_forces.hpp"
#include "chapters/26_four_ways/ways.hpp"
#include "common/random.hpp"

using namespace rigid;

namespace {

JointedScene ball(Real height, Real e, Real mu = 0)
{
    JointedScene scene;
    scene.walls.push_back({{0, 1}, 0});
    add_body(scene, disc(0.1), Mass{1, {0, 0}, 0.005}, {0, 0.1 + height});
    cover(scene, {mu, e, 0, 0});
    return scene;
}

JointedScene jointed(const RoughScene& rough)
{
    JointedScene scene;
    static_cast<RoughScene&>(scene) = rough;
    return scene;
}

Eigen::Matrix<Real, 2, 2> matrix_of(const RodEnd& A)
{
    Eigen::Matrix<Real, 2, 2> m;
    m << A.nn, A.nt, A.nt, A.tt;
    return m;
}

}  // namespace

TEST_CASE("a stack on springs sinks by its weight over their stiffness", "[house]")
{
    for (const Way way : {Way::spring, Way::end_spring}) {
        WayScene stack = stack_of_five();
        WayRun run(way, stack, {1e5, 1});
        for (int i = 0; i < 4000; ++i) run.advance(1e-3);
        // two springs carry what is above: the top sinks by (5 + 4 + 3 + 2 + 1) m g / 2k. The dampers have left 1e-7 of it
        CHECK(std::abs(stack.error(run.scene()) - 15 * 9.81 / 2e5) <= 1e-9);
    }
}

TEST_CASE("a block on springs along a slope sticks with a stretch and does not creep", "[house]")
{
    const auto stands = [](auto method) {
        JointedScene scene = jointed(on_a_slope(box(1, 0.5), 0.25, 10, 0.3));
        StepData<3> now;
        const auto run = [&] {
            for (int i = 0; i < 10000; ++i) step(scene, {.h = 2e-4}, method, now);
        };
        method.correction.springs.stiffness = 1e5;
        run();
        const Real before = down_the_slope(scene);
        run();
        Real stretch = 0;
        for (const Stretch& one : method.correction.stretched) stretch += one.s;
        // the springs hold m g sin α, t points up the slope; in two seconds the dampers have left nothing
        CHECK(std::abs(1e5 * std::abs(stretch) - 0.5 * 9.81 * std::sin(pi / 18)) <= 1e-9);
        CHECK(std::abs(down_the_slope(scene) - before) <= 1e-12);  // no creep in two seconds
    };
    stands(ExplicitPenalty<Manifolds>{});
    stands(ImplicitPenalty<Manifolds>{});
}

TEST_CASE("a wheel on springs stays where its arm holds it and else rolls as it must", "[house]")
{
    const Real r = 0.1, arm = 0.01;
    const auto rolls = [&](Real degrees, auto method) {
        JointedScene scene;
        scene.walls.push_back({{0, 1}, 0});
        add_body(scene, disc(r), Mass{1, {0, 0}, r * r / 2}, {0, r});
        cover(scene, {0.5, 0, 0, arm});
        const Real a = degrees * pi / 180;
        scene.gravity = 9.81 * Vec2(std::sin(a), -std::cos(a));
        method.correction.springs.stiffness = 1e5;
        StepData<3> now;
        for (int i = 0; i < 5000; ++i) step(scene, {.h = 1e-4}, method, now);
        const Real half = scene.bodies.u[0];
        for (int i = 0; i < 5000; ++i) step(scene, {.h = 1e-4}, method, now);
        return std::array{scene.bodies.x[0], half, scene.bodies.u[0]};
    };
    const auto check = [&](auto method) {
        // tan 3° = 0.052 is below 0.1: it yields by w/k and comes to rest
        const auto held = rolls(3, method);
        CHECK(std::abs(held[0]) < 1e-3);
        CHECK(std::abs(held[2]) < 1e-5);
        // ⅔ (g sin α − c/r g cos α), once the springs have taken up the weight
        const Real a = 8 * pi / 180, faster = 2.0 / 3 * 9.81 * (std::sin(a) - arm / r * std::cos(a));
        const auto rolled = rolls(8, method);
        // the wheel sinks in by w/k, a thousandth of r, and this is a difference of terms four times as large
        CHECK(rolled[2] - rolled[1] == Approx(faster / 2).epsilon(5e-3));
    };
    check(ExplicitPenalty<Manifolds>{});
    check(ImplicitPenalty<Manifolds>{});
}

TEST_CASE("a spring that slides along a slope holds no more than its bound", "[house]")
{
    JointedScene scene = sliding_block().scene;
    ExplicitPenalty<Manifolds> method;
    method.correction.springs.stiffness = 1e5;
    StepData<3> now;
    for (int i = 0; i < 5000; ++i) step(scene, {.h = 2e-4}, method, now);
    CHECK(down_the_slope(scene) > 1);  // it has slid
    Real stretch = 0;
    for (const Stretch& one : method.correction.stretched) stretch += std::abs(one.s);
    // μ m g cos α, all of it; the dampers of the springs across have come to rest, to 1e-6 N
    CHECK(std::abs(1e5 * stretch - 0.3 * 0.5 * 9.81 * std::cos(pi / 6)) <= 1e-4);
}

TEST_CASE("a rod that slips on a smooth floor keeps its energy by accelerations", "[house]")
{
    JointedScene scene = jointed(rod_on_end(pi / 3, {0, 0}, 0, 0));
    scene.gravity = {0, -9.81};
    const Real before = energy(scene);
    AccelerationLevel level;
    for (int i = 0; i < 25; ++i) REQUIRE(level.advance(scene, 0.01) == Status::solved);
    CHECK(std::abs(scene.bodies.u[2]) > 1);  // it turns, so its corner has an acceleration of its own
    CHECK(std::abs(energy(scene) - before) <= 1e-6);  // of order four; 4.2 J at the start
    CHECK(std::abs(scene.bodies.x[0]) <= 1e-12);      // nothing pushes sideways
}

TEST_CASE("the damping ratio of a bounce leaves that part of the speed to a spring that may pull", "[idea]")
{
    for (const Real e : {1.0, 0.9, 0.5, 0.1}) {
        const Real zeta = damping_ratio_of(e), w = std::sqrt(1 - zeta * zeta);
        // half a period of the damped oscillator
        CHECK(std::abs(std::exp(-zeta * pi / w) - e) <= 1e-13);
    }
    // the contact that only pushes lets go where kC + c dC/dt = 0, and keeps a little more
    const auto bounce = [](Real e) {
        JointedScene scene = ball(0.5, e);
        ExplicitPenalty<Manifolds> method;
        method.correction.springs.stiffness = 1e6;
        StepData<3> now;
        Real down = 0;
        for (Limit steps(200000); steps.left();) {
            step(scene, {.h = 1e-5}, method, now);
            down = std::min(down, scene.bodies.u[1]);
            if (scene.bodies.u[1] > 0 && scene.bodies.x[1] > 0.1001) break;
        }
        return scene.bodies.u[1] / -down;
    };
    CHECK(std::abs(bounce(1) - 1) <= 2e-3);  // weight over the way, and steps of 1e-5 s
    const Real half = bounce(0.5);
    CHECK(half > 0.5);
    CHECK(half < 0.56);
}

TEST_CASE("two bodies under Hertz's law press and part as their closed forms say", "[house]")
{
    // a ball of 1 kg on a floor, without weight and damper
    const Real K = 1e6;
    const auto bounce = [&](Real speed, auto method) {
        JointedScene scene = ball(1e-6, 1);
        scene.gravity = {0, 0};
        scene.bodies.u[1] = -speed;
        method.correction.springs.hertz = K;
        StepData<3> now;
        const Real h = hertz_time(1, K, speed) / 2000;
        Real deepest = 0, time = 0;
        for (Limit steps(4000); steps.left();) {
            step(scene, {.h = h}, method, now);
            deepest = std::max(deepest, 0.1 - scene.bodies.x[1]);
            if (scene.bodies.x[1] < 0.1) time += h;
            else if (scene.bodies.u[1] > 0) break;
        }
        return std::array{deepest / hertz_overlap(1, K, speed), time / hertz_time(1, K, speed),
                          scene.bodies.u[1] / speed};
    };
    for (const Real speed : {0.1, 1.0, 3.2}) {
        const auto [depth, time, back] = bounce(speed, ExplicitPenalty<Manifolds>{});
        CHECK(std::abs(depth - 1) <= 1e-3);  // two thousand steps of order one
        CHECK(std::abs(time - 1) <= 2e-3);
        CHECK(std::abs(back - 1) <= 2e-3);
        const auto [soft_depth, soft_time, soft_back] = bounce(speed, ImplicitPenalty<Manifolds>{});
        CHECK(std::abs(soft_depth - 1) <= 5e-3);  // which a force at the end damps by h ω/2 of its speed
        CHECK(std::abs(soft_time - 1) <= 5e-3);
        CHECK(std::abs(soft_back - 1) <= 5e-3);
    }
    // 32 times as fast, half as long
    CHECK(std::abs(hertz_time(2, K, 1) / hertz_time(2, K, 32) - 2) <= 1e-12);
    // and at rest it carries its weight: K d^{3/2} = m g
    JointedScene rests = ball(0, 0);
    ImplicitPenalty<Manifolds> soft;
    soft.correction.springs.hertz = K;
    StepData<3> now;
    for (int i = 0; i < 3000; ++i) step(rests, {.h = 1e-3}, soft, now);
    CHECK(std::abs(K * std::pow(0.1 - rests.bodies.x[1], 1.5) - 9.81) <= 1e-6);
}

TEST_CASE("a block slides down a slope in coordinates that float", "[house]")
{
    for (const auto& [degrees, mu] : {std::pair{30.0, 0.3}, {16.5, 0.3}, {20.0, 0.5}}) {
        JointedScene scene = jointed(on_a_slope(box(1, 0.5), 0.25, degrees, mu));
        ReducedMotion motion(scene);
        for (int i = 0; i < 240; ++i) REQUIRE(motion.advance(scene, 1.0 / 240) == Status::solved);
        // an impulse for each step, so symplectic Euler: its way is longer by the share h/t
        const Real a = block_by_hand(degrees, mu);
        CHECK(std::abs(down_the_slope(scene) - a / 2 * (1 + 1.0 / 240)) <= 1e-9);
    }
}

TEST_CASE("a ball meets the floor when it does by accelerations and single impulses and coordinates",
          "[house]")
{
    for (const Way way : {Way::acceleration, Way::single, Way::coordinates})
        for (const int steps : {7, 120, 1001})                                     // whatever the step is
            CHECK(run_way(way, bouncing_ball(), 2.0 / steps, {}).error <= 1e-12);  // D1
    // and rests: at 4.0637 s its bounces are over but for those below the speed that rests
    for (const Way way : {Way::acceleration, Way::coordinates}) {
        WayRun run(way, bouncing_ball(), {});
        for (int i = 0; i < 420; ++i) REQUIRE(run.advance(0.01) == Status::solved);
        CHECK(std::abs(run.scene().bodies.x[1] - 0.1) <= 1e-6);  // of the gap that is closed
        CHECK(std::abs(run.scene().bodies.u[1]) <= 1e-12);
    }
}

TEST_CASE("what bounces in coordinates does so at its moment and keeps its energy", "[house]")
{
    // a box that turns in the air, and a rod on a pin that hits a wall: smooth, e = 1
    JointedScene tumbles;
    tumbles.walls.push_back({{0, 1}, 0});
    add_body(tumbles, box(1, 0.5), 2.0, {0, 2}, 0.4);
    tumbles.bodies.u[2] = 1;
    JointedScene swings = pendulum().scene;
    swings.walls.push_back({{1, 0}, -0.5});
    for (JointedScene* start : {&tumbles, &swings}) {
        cover(*start, {0, 1, 0, 0});
        std::vector<Real> gained;
        for (const int rate : {60, 120}) {
            JointedScene scene = *start;
            ReducedMotion motion(scene);
            for (int i = 0; i < 3 * rate; ++i) REQUIRE(motion.advance(scene, 1.0 / rate) == Status::solved);
            CHECK(motion.bounces >= 3);
            CHECK(largest_joint_error(scene) <= 1e-12);
            gained.push_back(std::abs(energy(scene) - energy(*start)));
        }
        CHECK(gained[0] <= 1e-6);                   // of some 10 J: that of steps of order four
        CHECK(gained[1] <= gained[0] / 8 + 1e-10);  // the box flies exactly: rounding
    }
    // beside what rests a bounce falls into a step of rows
    std::vector<Real> lost;
    for (const int rate : {240, 480}) {
        JointedScene scene = ball(1, 1);
        add_body(scene, box(1, 1), 1, {3, 0.5});
        scene.surfaces = {{0, 1}, {0, 0}};
        scene.wall_surfaces = {{0, 0}};
        ReducedMotion motion(scene);
        const Real before = energy(scene);
        for (int i = 0; i < 3 * rate; ++i) REQUIRE(motion.advance(scene, 1.0 / rate) == Status::solved);
        lost.push_back((before - energy(scene)) / 9.81);
    }
    CHECK(std::abs(lost[0] - 0.006) <= 0.0005);
    CHECK(std::abs(lost[1] - 0.003) <= 0.0005);
}

TEST_CASE(
    "what bounces in coordinates at three hundred metres a second goes through no plate of a centimetre",
    "[house]")
{
    for (const Real speed : {1.0, 10.0, 100.0, 300.0}) {
        JointedScene scene;
        scene.gravity = {0, 0};
        for (const Real side : {-1.0, 1.0}) {  // a room of plates of a centimetre
            add_body(scene, box(0.01, 4.1), Mass{}, {2 * side, 0});
            add_body(scene, box(4.1, 0.01), Mass{}, {0, 2 * side});
        }
        add_body(scene, disc(0.1), 1, {0, 0});
        add_body(scene, box(0.2, 0.02), 1, {0.6, 0.7}, 1);
        scene.bodies.velocity(4).head<2>() << speed * std::cos(0.3), speed * std::sin(0.3);
        scene.bodies.velocity(5) << -speed, speed / 3, speed;
        cover(scene, {0, 1, 0, 0});
        ReducedMotion motion(scene);
        const Real before = energy(scene);
        for (int i = 0; i < 60; ++i) REQUIRE(motion.advance(scene, 1.0 / 60) == Status::solved);
        for (const Index k : {4, 5}) CHECK(scene.bodies.position(k).head<2>().cwiseAbs().maxCoeff() <= 2);
        // each at its moment, but for those beyond two hundred flights a step
        if (speed <= 100) CHECK(std::abs(energy(scene) - before) <= 1e-9 * before);
    }
}

TEST_CASE("a block on a belt goes with it by accelerations and in coordinates and one at a time", "[house]")
{
    const auto on_a_belt = [] {
        JointedScene scene;
        scene.walls.push_back({{0, 1}, 0});
        add_body(scene, box(1, 0.5), 1.0, {0, 0.25});
        cover(scene, {0.3, 0, 0, 0});
        scene.wall_surfaces[0].belt = 1;
        return scene;
    };
    const Real a = 0.3 * 9.81;
    const auto speed_after = [&](auto by, JointedScene scene, Real time) {
        for (int i = 0; i < 60; ++i) REQUIRE(by.advance(scene, time / 60) == Status::solved);
        return scene.bodies.u[0];
    };
    // it slides until it is as fast as the belt; the way round is the wall's: to the left
    for (const Real time : {0.2, 1.0}) {
        const Real wanted = std::min(a * time, 1.0);
        CHECK(std::abs(std::abs(speed_after(AccelerationLevel{}, on_a_belt(), time)) - wanted) <= 1e-6);
        CHECK(std::abs(std::abs(speed_after(ReducedMotion(on_a_belt()), on_a_belt(), time)) - wanted) <=
              1e-9);
        // by hops, each of which sees the belt
        CHECK(std::abs(std::abs(speed_after(SingleImpulses{}, on_a_belt(), time)) - wanted) <= 0.02);
    }
}

TEST_CASE("what a caller changes between steps in coordinates is taken over", "[house]")
{
    JointedScene scene = pendulum().scene;
    scene.gravity = {0, 0};
    ReducedMotion motion(scene);
    REQUIRE(motion.advance(scene, 0.01) == Status::solved);
    CHECK(scene.bodies.u.norm() == 0);
    scene.bodies.u << 0, 0.5, 1;  // it turns about its pin
    REQUIRE(motion.advance(scene, 0.01) == Status::solved);
    CHECK(std::abs(scene.bodies.u[2] - 1) <= 1e-12);
    CHECK(std::abs(scene.bodies.x[2] - 0.01) <= 1e-12);
    scene.bodies.x << 0, 0.5, pi / 2;
    scene.bodies.u << -0.5, 0, 1;
    REQUIRE(motion.advance(scene, 0.01) == Status::solved);
    CHECK(std::abs(scene.bodies.x[2] - pi / 2 - 0.01) <= 1e-12);
    scene.bodies.u.setZero();
    scene.bodies.x << 0.5, 0, 0;
    scene.gravity = {0, -9.81};
    REQUIRE(motion.advance(scene, 1e-3) == Status::solved);
    CHECK(std::abs(scene.bodies.u[2] + 1.5 * 9.81e-3) <= 1e-6);  // 3 g / 2 L
    // rows that belong to no joint hold as well
    JointedScene rows = pendulum().scene;
    rows.placed.clear(), rows.owner.clear();
    ReducedMotion floats(rows);
    CHECK(floats.coordinates() == 3);
    for (int i = 0; i < 100; ++i) REQUIRE(floats.advance(rows, 0.01) == Status::solved);
    CHECK(pendulum().error(rows) <= 1e-6);  // as by accelerations, to order four
}

TEST_CASE("what rests by single impulses hops no higher than it may", "[house]")
{
    JointedScene scene = ball(0, 0.5);
    SingleImpulses by;
    by.settings.hop = 1e-3;
    const Real length = typical_length(scene), hop = 1e-3 * length, v = std::sqrt(2 * 9.81 * hop);
    Real highest = 0;
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(by.advance(scene, 1e-3) == Status::solved);
        highest = std::max(highest, scene.bodies.x[1] - 0.1);
        CHECK(scene.bodies.x[1] >= 0.1 - 1e-12);
    }
    CHECK(highest <= hop * (1 + 1e-6));
    CHECK(highest > 0.9 * hop);
    // a hop lasts 2 v / g: so many in a second, the first at once
    CHECK(std::abs(static_cast<Real>(by.micro) - 9.81 / (2 * v)) <= 1);
    CHECK(by.micro == by.collisions);
}

TEST_CASE("the impulse of one contact is that of the closed forms", "[idea]")
{
    // D3: the rod at 30°, v = −1, e = ½, without friction; t to the right
    const RodEnd rod = rod_end(pi / 6);
    const auto A = matrix_of(rod);
    CHECK(std::abs(1.5 * one_contact(A, {-1, 0}, 0, 0).n - 6.0 / 13) <= 1e-12);
    // R2: with friction it slips at 0.3 and sticks at 0.9
    const OneImpulse slips = one_contact(A, {-1, 0}, 0.3, 0), sticks = one_contact(A, {-1, 0}, 0.9, 0);
    CHECK(std::abs(1.5 * slips.n - 0.5244226112797739) <= 1e-12);
    CHECK(std::abs(std::abs(1.5 * slips.t) - 0.1573267833839322) <= 1e-12);
    CHECK(std::abs(1.5 * sticks.n - 0.65625) <= 1e-12);
    CHECK(std::abs(std::abs(1.5 * sticks.t) - 0.4871392896287467) <= 1e-12);
    // D4: a disc sticks if and only if μ (1 + e) v_n ≥ v_t / 3
    const auto disc_end = matrix_of({1, 0, 3});
    for (const Real mu : {0.1, 0.33, 0.34, 1.0}) {
        const OneImpulse hit = one_contact(disc_end, {-1, 1}, mu, 0);
        CHECK((std::abs(hit.t) < mu * hit.n - 1e-12) == (mu > 1.0 / 3));
    }
}

TEST_CASE("an impulse of one contact never makes energy and obeys friction", "[idea]")
{
    Random random(19);
    for (int round = 0; round < 5000; ++round) {
        const Real angle = random.uniform(0.01, 1.56), mu = random.uniform(0, 3), e = random.uniform(0, 1),
                   vn = -random.uniform(0, 2), vt = random.uniform(-2, 2);
        const auto A = matrix_of(rod_end(angle));
        OneImpulse hit = one_contact(A, {vn, vt}, mu, 0);
        // normal velocity zero after the first half, friction within its cone, against what slides
        CHECK(std::abs(vn + A(0, 0) * hit.n + A(0, 1) * hit.t) <= 1e-12);
        CHECK(hit.n >= 0);
        CHECK(std::abs(hit.t) <= mu * hit.n + 1e-12);
        const Real slip = vt + A(1, 0) * hit.n + A(1, 1) * hit.t;
        CHECK(slip * hit.t <= 1e-12);
        hit.n *= 1 + e, hit.t *= 1 + e;
        const Real vn1 = vn + A(0, 0) * hit.n + A(0, 1) * hit.t, vt1 = vt + A(1, 0) * hit.n + A(1, 1) * hit.t;
        CHECK(hit.n * (vn + vn1) / 2 + hit.t * (vt + vt1) / 2 <= 1e-12);  // (13.26)
    }
}

TEST_CASE("collisions one at a time keep momentum and what flies keeps its parabola", "[house]")
{
    Random random(5);
    JointedScene scene;
    scene.gravity = {0, 0};
    for (int k = 0; k < 8; ++k) {
        const Real x = 0.7 * (k % 4), y = 0.7 * (k / 4), vx = random.uniform(-1, 1),
                   vy = random.uniform(-1, 1);
        add_body(scene, box(0.4, 0.3), 1.0 + k, {x, y}, 0.3 * k);
        scene.bodies.u.segment<2>(3 * k) << vx, vy;
    }
    cover(scene, {0.4, 1, 0, 0});
    const auto totals = [&] {
        Vec<3> sum = Vec<3>::Zero();
        for (Index k = 0; k < 8; ++k) {
            const Real m = 1 / scene.bodies.inverse_mass[3 * k];
            const Vec2 p = m * scene.bodies.velocity(k).head<2>();
            sum.head<2>() += p;
            sum[2] += cross2(scene.bodies.position(k).head<2>(), p) +
                      scene.bodies.u[3 * k + 2] / scene.bodies.inverse_mass[3 * k + 2];
        }
        return sum;
    };
    const Vec<3> before = totals();
    SingleImpulses by;
    for (int i = 0; i < 60; ++i) REQUIRE(by.advance(scene, 1.0 / 60) == Status::solved);
    CHECK(by.collisions > 3);
    CHECK((totals() - before).norm() <= 1e-11);  // rounding of some tens of products of size 10
}

TEST_CASE("a block at rest on a slope stays by accelerations and slides by its closed form", "[house]")
{
    for (const auto& [degrees, mu] : {std::pair{30.0, 0.3}, {16.5, 0.3}, {45.0, 0.9}, {20.0, 0.5}}) {
        JointedScene scene = jointed(on_a_slope(box(1, 0.5), 0.25, degrees, mu));
        AccelerationLevel level;
        for (int i = 0; i < 60; ++i) REQUIRE(level.advance(scene, 1.0 / 60) == Status::solved);
        CHECK(std::abs(down_the_slope(scene) - block_by_hand(degrees, mu) / 2) <= 1e-11);
    }
    // a disc that is thrown slides, then rolls: the change is an event, found where it is (G3)
    JointedScene scene = jointed(thrown_disc(10, 0.2));
    AccelerationLevel level;
    for (int i = 0; i < 200; ++i) REQUIRE(level.advance(scene, 0.01) == Status::solved);
    const RollingStart rolls = rolling_start(10, 0.2, 0.5);
    CHECK(std::abs(scene.bodies.u[0] - rolls.v) <= 1e-6);  // of the slip that counts as none
    CHECK(std::abs(scene.bodies.x[0] - (rolls.d + (2 - rolls.t) * rolls.v)) <= 1e-5);
    CHECK(level.work.events >= 1);
}

TEST_CASE("loops keep closed in coordinates and by accelerations", "[house]")
{
    for (const Way way : {Way::acceleration, Way::coordinates}) {
        WayRun run(way, slider_crank_loop(), {});
        for (int i = 0; i < 1000; ++i) REQUIRE(run.advance(1e-3) == Status::solved);
        // nothing repairs the loop; in a second of steps of order four it opens by 2e-9 m
        CHECK(largest_joint_error(run.scene()) <= 1e-8);
        const Real theta = run.scene().bodies.x[2];
        CHECK(std::abs(point_of(run.scene().bodies.x, 1, {0.25, 0}).x() -
                       (0.2 * std::cos(theta) +
                        std::sqrt(0.25 - 0.04 * std::sin(theta) * std::sin(theta)))) <= 1e-8);
    }
}

TEST_CASE("bad input to a way is refused by its sentence", "[house]")
{
    JointedScene scene = ball(1, 0.5);
    CHECK(sentence_of([] { require_valid(PenaltySprings{.stiffness = -1}); }) ==
          "the stiffness of the springs is -1 N/m; it must be positive and finite");
    CHECK(sentence_of([] { require_valid(PenaltySprings{.contact_ratio = -0.5}); }) ==
          "the damping ratio of contacts is -0.5; it must be zero or positive, and finite");
    CHECK(sentence_of([&] {
              AccelerationLevel level;
              level.settings.rate = -1;
              level.advance(scene, 0.01);
          }) == "the rate of stabilisation is -1; it must be zero or positive, and finite");
    CHECK(sentence_of([&] {
              AccelerationLevel level;
              level.settings.most_events = 0;
              level.advance(scene, 0.01);
          }) == "the number of events in a step is 0; it must be at least 1");
    CHECK(sentence_of([&] {
              ReducedMotion motion(scene);
              motion.settings.gap = -1;
              motion.advance(scene, 0.01);
          }) == "the gap that is closed is -1; it must be zero or positive, and finite");
    CHECK(sentence_of([&] {
              SingleImpulses single;
              single.settings.hop = 0;
              single.advance(scene, 0.01);
          }) == "the hop of a microcollision is 0 lengths of the scene; it must be positive and finite");
    CHECK(sentence_of([&] {
              SingleImpulses single;
              single.settings.most_collisions = 0;
              single.advance(scene, 0.01);
          }) == "the number of collisions in a step is 0; it must be at least 1");
    JointedScene spoilt = scene;
    spoilt.gravity.x() = infinity;
    CHECK(sentence_of([&] { AccelerationLevel().advance(spoilt, 0.01); }) == "gravity is not finite");
    CHECK(sentence_of([&] { SingleImpulses().advance(spoilt, 0.01); }) == "gravity is not finite");
    CHECK(sentence_of([&] { ReducedMotion(scene).advance(spoilt, 0.01); }) == "gravity is not finite");
    CHECK(sentence_of([&] { AccelerationLevel().advance(scene, 0); }) ==
          "the time step h is 0 s; it must be positive and finite");
    CHECK(
        sentence_of([] { WayRun(Way::single, pendulum(), {}); }) ==
        "the scene has 2 rows of joints; impulses one at a time are those of collisions, and what is joined "
        "never collides");
    CHECK(sentence_of([] { require_valid(PenaltySprings{.hertz = -1}); }) ==
          "the stiffness of Hertz's law is -1; it must be zero or positive, and finite");
    JointedScene driven = pendulum().scene;
    RigidJoint joint = driven.placed[0].joint;
    joint.motor.force = 1;
    driven.joints.clear(), driven.placed.clear(), driven.owner.clear();
    add_joint(driven, joint);
    CHECK(
        sentence_of([&] { AccelerationLevel().advance(driven, 0.01); }) ==
        "a joint has a motor or a spring; at the level of accelerations joints push and pull, or only push");
    CHECK(sentence_of([&] { ReducedMotion motion(driven); }) ==
          "a joint has a motor or a spring; coordinates of joints take their forces from outside");
}

TEST_CASE("what a way has no row for and what does not fit is refused by its sentence", "[house]")
{
    const auto by_all = [](const JointedScene& scene, const std::string& sentence) {
        JointedScene copy = scene;
        CHECK(sentence_of([&] { AccelerationLevel().advance(copy, 0.01); }) == sentence);
        CHECK(sentence_of([&] { SingleImpulses().advance(copy, 0.01); }) == sentence);
        CHECK(sentence_of([&] { ReducedMotion motion(copy); }) == sentence);
        if (scene.bodies.x.allFinite()) CHECK(copy.bodies.x == scene.bodies.x);
    };
    const JointedScene good = ball(1, 0.5);
    JointedScene scene = good;
    scene.walls[0].normal = {0, 2};
    by_all(scene, "the length of the normal of wall 0 is 2; it must be 1");
    scene = good;
    scene.bodies.x[1] = std::nan("");
    by_all(scene, "x[1] is nan; it must be a finite number");
    scene = good;
    scene.bodies.inverse_mass[0] = infinity;
    by_all(scene, "inverse_mass[0] is inf; it must be a finite number");
    scene = good;
    scene.shapes.clear();
    scene.surfaces.clear();
    by_all(scene, "the scene has 0 shapes and 1 bodies; each needs its own");
    scene = good;
    scene.wall_surfaces[0].rolling = 0.01;
    by_all(
        scene,
        "a surface resists rolling with an arm of 0.01 m; springs, impulses all at once and positions have "
        "rows for it, this way has none");
    scene = good;
    scene.cloth.friction = 0.1;
    by_all(
        scene,
        "the scene lies on a cloth; springs, impulses all at once and positions have rows for it, this way "
        "has none");

    scene = good;
    scene.surfaces[0].friction = scene.wall_surfaces[0].friction = 0.5;
    scene.surfaces[0].kinetic = 0.3;
    const std::string one =
        "a surface has a smaller coefficient of friction while it slides; this way has one "
        "coefficient for both";
    CHECK(sentence_of([&] { SingleImpulses().advance(scene, 0.01); }) == one);
    CHECK(sentence_of([&] { ReducedMotion motion(scene); }) == one);

    JointedScene hung = pendulum().scene;
    hung.placed[0].joint.breaking_force = 5;
    CHECK(sentence_of([&] { AccelerationLevel().advance(hung, 0.01); }) ==
          "joint 0 may break; this way holds each joint of a scene, and for good");
    hung.placed[0].broken = true;
    CHECK(sentence_of([&] { ReducedMotion motion(hung); }) ==
          "joint 0 is broken; this way holds each joint of a scene, and for good");
    hung = pendulum().scene;
    hung.joints[0].at_b.x() = std::nan("");
    CHECK(sentence_of([&] { ReducedMotion motion(hung); }) != "accepted");
    CHECK(sentence_of([&] { AccelerationLevel().advance(hung, 0.01); }) != "accepted");

    scene = good;
    AccelerationLevel level;
    level.filter.group = {0, 0, 0};
    CHECK(sentence_of([&] { level.advance(scene, 0.01); }) ==
          "the filter of collisions has 3 groups for 1 bodies; it must be empty or have 1");
    VecX a, three = VecX::Zero(3), six = VecX::Zero(6);
    CHECK(sentence_of([&] { AccelerationLevel().accelerations(scene, six, three, a); }) ==
          "x and u have 6 and 3 entries; the bodies have 3");

    ReducedMotion motion(scene);
    CHECK(sentence_of([&] { motion.forward_dynamics(six, three, {}); }) ==
          "q has 6 entries; the tree has 3 coordinates");
    CHECK(sentence_of([&] { motion.forward_dynamics(three, three, six); }) ==
          "tau has 6 entries; the tree has 3 coordinates");
    CHECK(sentence_of([&] { motion.inverse_dynamics(three, three, six); }) ==
          "ddq has 6 entries; the tree has 3 coordinates");
    const std::string other =
        "the scene has other bodies, masses or joints than that of which these coordinates "
        "were made; make them of it again";
    JointedScene two = scene;
    add_body(two, disc(0.1), Mass{1, {0, 0}, 0.005}, {5, 5});
    two.surfaces.push_back({});
    CHECK(sentence_of([&] { motion.advance(two, 0.01); }) == other);
    two = scene;
    two.bodies.inverse_mass[0] = 2;
    CHECK(sentence_of([&] { motion.advance(two, 0.01); }) == other);
    motion.restitution = 2;
    CHECK(sentence_of([&] { motion.advance(scene, 0.01); }) ==
          "the restitution of contacts and limits is 2; it must be from 0 to 1");
}

TEST_CASE("chains and bodies of several shapes and broken filters are refused by a sentence", "[house]")
{
    JointedScene scene;
    add_chain(scene, {{5, 0}, {-5, 0}}, false);
    add_body(scene, disc(0.2), Mass{1, {0, 0}, 1}, {0, 1});
    const std::string sided =
        "the scene has 1 chains of edges that are solid on one side; springs, impulses all at once and "
        "positions take them, this way has both sides alone";
    CHECK(sentence_of([&] { AccelerationLevel().advance(scene, 0.01); }) == sided);
    CHECK(sentence_of([&] { SingleImpulses().advance(scene, 0.01); }) == sided);
    CHECK(sentence_of([&] { ReducedMotion motion(scene); }) == sided);
    scene = ball(1, 0.5);
    scene.carried.resize(1);
    CHECK(sentence_of([&] { SingleImpulses().advance(scene, 0.01); }) ==
          "the scene has bodies of several shapes; this way has one shape to a body");

    scene = ball(1, 0.5);
    CollisionFilter filter;
    filter.group = {200};
    CHECK(sentence_of([&] { require_fits(filter, 1); }) ==
          "the filter of collisions has the group 200; there are groups 0 to 63");
    filter = {};
    filter.filters.resize(3);
    CHECK(sentence_of([&] { require_fits(filter, 1); }) ==
          "the filter of collisions has 3 filters for 1 bodies; it must be empty or have 1");
    filter = {};
    filter.first = {0, 9};
    CHECK(sentence_of([&] { require_fits(filter, 1); }) ==
          "the list of pairs of the filter of collisions does not begin at 0, ascend and end at its 0 "
          "partners");
    CHECK(sentence_of([] { require_fits(forbid_pairs(3, {{0, 2}, {1, 2}}), 3); }) == "accepted");
}

TEST_CASE("the filter of each body's own keeps apart what it says", "[house]")
{
    JointedScene scene;
    scene.gravity = {0, 0};
    for (const Real x : {0.0, 0.5}) add_body(scene, disc(0.1), Mass{1, {0, 0}, 0.005}, {x, 0});
    scene.bodies.u[0] = 1;
    cover(scene, {0, 1, 0, 0});
    for (const bool meet : {true, false}) {
        JointedScene copy = scene;
        SingleImpulses single;
        single.filter.filters.resize(2);
        for (Filter& own : single.filter.filters) own.group = meet ? 1 : -1;
        REQUIRE(single.advance(copy, 1) == Status::solved);
        CHECK(copy.bodies.u[3] == Approx(meet ? 1 : 0).margin(1e-12));
    }
}

TEST_CASE("no force moves a body of infinite mass and coordinates refuse it", "[house]")
{
    // a wheel that turns where it is, and a bead on a level rail
    for (const Vec<3>& inverse : {Vec<3>(0, 0, 1), Vec<3>(1, 0, 0)}) {
        JointedScene scene;
        add_body(scene, disc(0.5), Mass{1, {0, 0}, 1}, {0, 0});
        scene.bodies.inverse_mass = inverse;
        scene.bodies.u << inverse.x(), 0, inverse.z();
        for (const Way way : {Way::spring, Way::acceleration, Way::single, Way::impulses, Way::positions}) {
            INFO(to_string(way));
            WayScene one;
            one.scene = scene;
            WayRun run(way, one, {1e4, 20});
            for (int i = 0; i < 10; ++i) REQUIRE(run.advance(0.01) == Status::solved);
            CHECK((run.scene().bodies.x - 0.1 * scene.bodies.u).norm() <= 1e-15);
            CHECK((run.scene().bodies.u - scene.bodies.u).norm() <= 1e-15);
        }
        if (inverse.x() > 0) continue;
        CHECK(sentence_of([&] { ReducedMotion motion(scene); }) ==
              "body 0 has the inverse masses 0, 0 and 1; coordinates take bodies that move in all directions "
              "or in none");
    }
}

TEST_CASE("a long body that spins among small ones passes nothing", "[house]")
{
    // ℓ is that of the many: 0.1 m. The end of the rod comes to the post after 5 ms, 1.5 m away from where it was
    JointedScene scene;
    scene.gravity = {0, 0};
    add_body(scene, box(10, 0.1), Mass{1, {0, 0}, 100.0 / 12}, {0, 0});
    scene.bodies.u[2] = 60;
    for (int i = 0; i < 200; ++i) add_body(scene, disc(0.005), Mass{1, {0, 0}, 1}, {100.0 + i, 100});
    add_body(scene, disc(0.05), Mass{0, {0, 0}, 0}, {4.5 * std::cos(0.3), 4.5 * std::sin(0.3)});
    cover(scene, {0, 1, 0, 0});
    REQUIRE(typical_length(scene) == Approx(0.1));
    for (const Way way : {Way::acceleration, Way::single, Way::coordinates}) {
        INFO(to_string(way));
        WayScene one;
        one.scene = scene;
        WayRun run(way, one, {1e4, 20});
        REQUIRE(run.advance(1.0 / 120) == Status::solved);
        CHECK(run.scene().bodies.u[2] < 0);  // it was hit, and turns back
        CHECK(run.scene().bodies.x[2] < 0.3);
    }
}

TEST_CASE("what starts deep in another comes out of it in coordinates at a speed that no step makes larger",
          "[idea]")
{
    for (const Real deep : {0.01, 0.1, 0.4})
        for (const Real steps : {60.0, 240.0, 960.0}) {
            CAPTURE(deep, steps);
            JointedScene scene;
            scene.walls.push_back({{0, 1}, 0});
            add_body(scene, box(1, 1), Real{1}, {0, 0.5 - deep});
            ReducedMotion motion(scene);
            const Real length = typical_length(scene);
            Real fastest = 0;
            for (int n = 0; n < steps; ++n) {
                REQUIRE(motion.advance(scene, 1 / steps) == Status::solved);
                fastest = std::max(fastest, scene.bodies.u.cwiseAbs().maxCoeff());
            }
            CHECK(fastest > 0.9 * std::min(deep * steps, length));  // it did come out
            CHECK(fastest < length + 9.81 / steps);  // and fell back, from v²/2g above the floor
            CHECK(scene.bodies.x[1] == Approx(0.5).margin(1e-6));
        }
}

TEST_CASE("a limit is met alike in coordinates whatever the unit of length", "[idea]")
{
    const auto thrown = [](Real unit) {
        JointedScene scene;
        scene.gravity *= unit;
        add_body(scene, disc(0.1 * unit), Mass{1, {0, 0}, 0.005 * unit * unit}, {0.3 * unit, 0});
        PointJoint rope;
        rope.kind = ConstraintKind::unilateral, rope.sense = -1;
        rope.a = world, rope.b = 0, rope.length = unit;
        scene.joints.push_back(rope);
        ReducedMotion motion(scene);
        for (int n = 0; n < 90; ++n) CHECK(motion.advance(scene, 1.0 / 60) == Status::solved);
        CHECK(scene.bodies.x.head<2>().norm() < 1.001 * unit);  // it hangs
        CHECK(scene.bodies.x[0] < 0.29 * unit);                 // and swings
        return Vec<3>(scene.bodies.x / unit);
    };
    const Vec<3> here = thrown(1);
    for (const Real unit : {1e-3, 1e3}) CHECK((thrown(unit) - here).norm() < 1e-9);  // rounding of 90 steps
}

TEST_CASE("a joint that is another than it was is refused by coordinates and its limits may change",
          "[house]")
{
    const std::string other =
        "the scene has other bodies, masses or joints than that of which these coordinates "
        "were made; make them of it again";
    JointedScene scene = bead_on_a_wire();
    ReducedMotion loop(scene);
    REQUIRE(loop.advance(scene, 0.01) == Status::solved);
    scene.joints[0].length = 1.2;
    CHECK(sentence_of([&] { loop.advance(scene, 0.01); }) == other);
    scene = pendulum().scene;
    RigidJoint joint = scene.placed[0].joint;
    joint.lower = -1, joint.upper = 1;
    scene.joints.clear(), scene.placed.clear(), scene.owner.clear();
    add_joint(scene, joint);
    ReducedMotion tree(scene);
    REQUIRE(tree.advance(scene, 0.01) == Status::solved);
    for (PointJoint& row : scene.joints)
        if (row.kind == ConstraintKind::unilateral) row.length *= 0.5;
    CHECK(tree.advance(scene, 0.01) == Status::solved);
    scene.joints[0].at_a.x() += 0.3;
    CHECK(sentence_of([&] { tree.advance(scene, 0.01); }) == other);
}

TEST_CASE("a scene of nothing is solved and contacts that have no normal have no force", "[house]")
{
    for (const Way way : all_ways) {
        INFO(to_string(way));
        WayRun run(way, {}, {});
        CHECK(run.advance(0.01) == Status::solved);
    }
    JointedScene scene;  // one disc where another is
    for (int i = 0; i < 2; ++i) add_body(scene, disc(0.1), Mass{1, {0, 0}, 0.005}, {0, 0});
    CHECK(AccelerationLevel().advance(scene, 0.01) == Status::infeasible);
    CHECK(scene.bodies.x.isZero(0));
    // accelerations are asked of the scene that close() has seen
    JointedScene three;
    three.walls.push_back({{0, 1}, 0});
    for (int i = 0; i < 3; ++i) add_body(three, disc(0.1), Mass{1, {0, 0}, 0.005}, {1.0 * i, 0.1});
    AccelerationLevel level;
    level.close(three, 0.1);
    REQUIRE(level.closed() == 3);
    VecX a;
    CHECK(level.accelerations(three, three.bodies.x, three.bodies.u, a) == Status::solved);
    CHECK(sentence_of([&] { level.accelerations(scene, scene.bodies.x, scene.bodies.u, a); }) ==
          "the scene has 2 bodies; its closed contacts were found among 3: call close()");
}

TEST_CASE("numbers that make no sense are refused by the formulas and runs of the ways", "[house]")
{
    // a soft spring beside a strong damper: 2 m/c, and no difference of two equal roots
    CHECK(largest_step(1, 1e-12, 1e3) == Approx(2e-3).epsilon(1e-12));
    CHECK(largest_step(1, 1e300, 1e200) == Approx(2e-200).epsilon(1e-12).scale(0));
    CHECK(sentence_of([] {
              one_contact(Eigen::Matrix<Real, 2, 2>::Identity(), {-1, std::nan("")}, 0.5, 0);
          }) == "a contact's A or its v_t is not finite");
    CHECK(sentence_of([] { largest_stiffness(1, 0, 0); }) == "the step is 0; it must be positive and finite");
    CHECK(sentence_of([] { largest_stiffness(-1, 0, 1); }) ==
          "the mass is -1; it must be positive and finite");
    CHECK(sentence_of([] { largest_step(1, 0, 0); }) == "the stiffness is 0; it must be positive and finite");
    CHECK(sentence_of([] { largest_step(1, 1, std::nan("")); }) ==
          "the damper is nan; it must be zero or positive, and finite");
    CHECK(sentence_of([] { damping_ratio_of(0); }) ==
          "the part of its speed that a bounce keeps is 0; it must be above 0 and at most 1");
    CHECK(sentence_of([] { hertz_time(1, 1, 0); }) == "the speed is 0; it must be positive and finite");
    CHECK(sentence_of([] {
              one_contact(Eigen::Matrix<Real, 2, 2>::Zero(), {-1, 0}, 0.5, 0);
          }) == "A_nn is 0; it must be positive and finite");
    CHECK(sentence_of([] {
              one_contact(Eigen::Matrix<Real, 2, 2>::Identity(), {1, 0}, 0.5, 0);
          }) == "what the contact has to gain is -1; it must be zero or positive, and finite");

    const WayScene scene = bouncing_ball();
    CHECK(run_way(Way::impulses, scene, 0, {}).why_not ==
          "the time step h is 0 s; it must be positive and finite");
    CHECK(run_way(Way::impulses, scene, 1e-12, {}).why_not ==
          "the scene takes 2e+12 steps of 1e-12 s; it must be at most 1e9");
    CHECK(run_way(Way::impulses, scene, 0.01, {.stiffness = std::nan("")}).why_not ==
          "the stiffness of the springs is nan N/m; it must be positive and finite");
    CHECK(run_way(Way::impulses, scene, 0.01, {.sweeps = -1}).why_not ==
          "the number of sweeps is -1; it must be zero or positive");
    WayScene other = scene;
    other.time = -1;
    CHECK(run_way(Way::single, other, 0.01, {}).why_not ==
          "the time of the scene is -1 s; it must be positive and finite");
    other = scene;
    other.error = nullptr;
    CHECK(run_way(Way::single, other, 0.01, {}).why_not ==
          "the scene does not say how its error is measured");
    WayRun run(Way::single, scene, {});
    CHECK(sentence_of([&] { advance_to_end(run, scene, 0); }) ==
          "the number of steps is 0; it must be at least 1");
    // what leaves all numbers says so, and the scene stands where it was
    for (const Way way : {Way::acceleration, Way::single, Way::coordinates}) {
        other = scene;
        other.scene.walls.clear(), other.scene.wall_surfaces.clear();
        WayRun far(way, other, {});
        CHECK(far.advance(1e300) == Status::iteration_limit);
        CHECK(far.scene().bodies.x == other.scene.bodies.x);
    }
    // a driven joint is refused before the first step
    WayScene driven = pendulum();
    RigidJoint joint = driven.scene.placed[0].joint;
    joint.motor.force = 1;
    driven.scene.joints.clear(), driven.scene.placed.clear(), driven.scene.owner.clear();
    add_joint(driven.scene, joint);
    CHECK_FALSE(can_take(Way::acceleration, driven));
    CHECK_FALSE(can_take(Way::coordinates, driven));
    CHECK(can_take(Way::impulses, driven));
}

TEST_CASE("a step that is refused or has no answer leaves the scene as it was", "[house]")
{
    JointedScene scene = jammed_rod().scene;
    const VecX x = scene.bodies.x, u = scene.bodies.u;
    AccelerationLevel level;
    CHECK(level.advance(scene, 0.01) != Status::solved);
    CHECK((scene.bodies.x - x).norm() == 0);
    CHECK((scene.bodies.u - u).norm() == 0);
    SingleImpulses single;
    single.settings.most_collisions = 3;
    JointedScene rests = ball(0, 0);
    CHECK(single.advance(rests, 1) == Status::iteration_limit);
    CHECK(single.collisions == 3);
}

TEST_CASE("a steady step on springs allocates nothing", "[house]")
{
    const auto stands = [](auto method) {
        JointedScene scene = stack_of_five().scene;
        StepData<3> now;
        for (int i = 0; i < 50; ++i) step(scene, {.h = 1e-3}, method, now);
        const NoAllocation none;
        for (int i = 0; i < 20; ++i) step(scene, {.h = 1e-3}, method, now);
    };
    stands(ExplicitPenalty<Manifolds>{});
    stands(ImplicitPenalty<Manifolds>{});
    CHECK(NoAllocation::violations() == 0);
}
