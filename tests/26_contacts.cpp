/// Chapter 26: contacts as springs, one impulse at a time, and at the level of accelerations.

#include "tests/catch.hpp"
#include "tests/limit.hpp"
#include "tests/no_allocation.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

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

TEST_CASE("a ball meets the floor when it does by accelerations and by single impulses", "[house]")
{
    for (const Way way : {Way::acceleration, Way::single})
        for (const int steps : {7, 120, 1001})                                     // whatever the step is
            CHECK(run_way(way, bouncing_ball(), 2.0 / steps, {}).error <= 1e-12);  // D1
    // and rests: at 4.0637 s its bounces are over but for those below the speed that rests
    WayRun run(Way::acceleration, bouncing_ball(), {});
    for (int i = 0; i < 420; ++i) REQUIRE(run.advance(0.01) == Status::solved);
    CHECK(std::abs(run.scene().bodies.x[1] - 0.1) <= 1e-6);  // of the gap that is closed
    CHECK(std::abs(run.scene().bodies.u[1]) <= 1e-12);
    // impulses meet it at the end of a step: order one, not from step to step, so over six of them
    std::vector<Real> h, errors;
    for (const int steps : {240, 380, 600, 960, 1500, 2400}) {
        h.push_back(1.0 / steps);
        errors.push_back(run_way(Way::coordinates, bouncing_ball(), 2.0 / steps, {}).error);
    }
    CHECK(std::abs(slope(h, errors) - 1) <= 0.3);
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
