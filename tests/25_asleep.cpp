/// Chapter 25: solids that rest, sleep.

#include "tests/no_allocation.hpp"

#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"
#include "chapters/25_world_in_space/space_sleep.hpp"

#include "tests/catch.hpp"
#include "tests/sentence.hpp"
#include "tests/solids.hpp"

using namespace rigid;

namespace {

/// Steps until nothing is awake.
/// \return  how many; `most` if something still was
template <class Method>
int until_all_sleep(SpaceScene& scene, Method& method, StepData<6>& now, int most)
{
    for (int i = 1; i <= most; ++i) {
        step(scene, {.h = sixtieth}, method, now);
        if (method.contacts.set.awake.empty()) return i;
    }
    return most;
}

/// Ten boxes on hinges, one below the other, held out to the side. Dry friction in each hinge: a motor that
/// wants no speed and is too weak to hold them.
SpaceScene hung_boxes()
{
    SpaceScene scene;
    const Real c = std::sqrt(0.5);
    for (int i = 0; i < 10; ++i) {
        const Vec3 at(0.5 * c * (i + 0.5), -0.5 * c * (i + 0.5), 0);
        add_body(scene, {solid_box({0.4, 0.1, 0.1})}, 1000.0, at, {0, 0, -pi / 4});
        SpaceJoint joint = hinge(scene, i - 1, i, {0.5 * c * i, -0.5 * c * i, 0}, {0, 0, 1});
        joint.motor = twist;
        joint.force = 40;
        scene.joints.push_back(joint);
    }
    return scene;
}

/// Joints in a row rest only by an answer that is one: 50 sweeps leave 1e-3 m/s or more.
SleepingCones exact_sleep()
{
    SleepingCones method;
    method.solver.exact_rows = 1000;
    method.solver.sweeps = {50, 1e-9};
    return method;
}

SpaceScene two_stacks(int boxes)
{
    SpaceScene scene;
    for (int i = 0; i < 2 * boxes; ++i)
        add_body(scene, {solid_box({1, 1, 1})}, 1000.0, {i < boxes ? 0.0 : 10.0, i % boxes + 0.5, 0});
    add_floor(scene, 0.5);
    return scene;
}

}  // namespace

TEST_CASE("a stack and a heap and solids hung on joints come to rest and then cost nothing", "[house]")
{
    for (SpaceScene scene :
         {SpaceScene(box_stack(6, 0.1, 0.5)), SpaceScene(mixed_heap(30, 0.5, 3)), hung_boxes()}) {
        SleepingCones method;
        if (!scene.joints.empty()) method = exact_sleep();
        StepData<6> now;
        const int steps = until_all_sleep(scene, method, now, 3000);
        INFO("steps " << steps);
        REQUIRE(steps < 3000);
        const VecX x = scene.bodies.x;
        CHECK(scene.bodies.u.isZero(0));
        for (int i = 0; i < 100; ++i) {
            step(scene, {.h = sixtieth}, method, now);
            CHECK(now.visits == 0);
            CHECK(now.active.empty());
        }
        CHECK(same_bits(scene.bodies.x, x));
    }
}

TEST_CASE("a step of solids has the bits of one that lets none sleep until the first falls asleep", "[house]")
{
    for (SpaceScene scene :
         {SpaceScene(box_stack(4, 0.1, 0.5)), SpaceScene(mixed_heap(12, 0.5, 5)), hung_boxes()}) {
        SpaceScene other = scene;
        SleepingCones method;
        TouchingCones awake;
        if (!scene.joints.empty()) method = exact_sleep(), awake.solver = method.solver;
        StepData<6> now, then;
        for (int i = 0; i < 2000; ++i) {
            step(scene, {.h = sixtieth}, method, now);
            step(other, {.h = sixtieth}, awake, then);
            if (method.contacts.fell_asleep > 0) break;
            REQUIRE(same_bits(scene.bodies.x, other.bodies.x));
            REQUIRE(same_bits(scene.bodies.u, other.bodies.u));
        }
        REQUIRE(method.contacts.fell_asleep > 0);
        // (10.8): what fell asleep had no more than the velocity of rest, and went no farther than that in a step
        const Real rest = method.contacts.rest.speed * now.length;
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            if (!method.contacts.set.is_asleep(k)) continue;
            const Vec<6> lost = measured_velocity(other, k, other.bodies.velocity(k));
            CHECK(lost.norm() <= rest);
            CHECK((centre_of(scene.bodies.x, k) - centre_of(other.bodies.x, k)).norm() <=
                  2 * rest * sixtieth);
        }
    }
}

TEST_CASE("a ball at the top of its flight does not sleep however weak gravity is", "[idea]")
{
    for (const Real g : {0.02, 2e-3, 2e-4}) {
        SpaceScene scene;
        scene.gravity = {0, -g, 0};
        add_body(scene, {solid_ball(0.5)}, 1000.0, {0, 0, 0});
        scene.bodies.velocity(0)[1] = 10 * g;  // at its apex after 10 s
        SleepingCones method;
        StepData<6> now;
        for (int i = 0; i < 15 * 60; ++i) {
            step(scene, {.h = sixtieth}, method, now);
            REQUIRE(method.contacts.set.is_awake(0));
        }
    }
}

TEST_CASE("a ball that rolls stops alike in a scene a thousand times as large", "[idea]")
{
    const auto rolled = [](Real L) {
        SpaceScene scene;
        scene.length = L;
        scene.gravity = {0, -9.81 * L, 0};
        for (int i = 0; i < 4; ++i) {
            add_body(scene, {solid_ball(0.5 * L)}, 1000 / (L * L * L), {1.01 * i * L, 0.5 * L, 0});
            scene.bodies.velocity(i)[0] = (2 - 0.3 * i) * L;
        }
        add_floor(scene, 0.5);
        scene.rolling.assign(4, 0.02 * L), scene.spinning.assign(4, 0.01 * L);
        SleepingCones method;
        StepData<6> now;
        for (int i = 0; i < 120; ++i) step(scene, {.h = sixtieth}, method, now);
        VecX x(12);
        for (Index k = 0; k < 4; ++k) x.segment<3>(3 * k) = centre_of(scene.bodies.x, k) / L;
        return x;
    };
    const VecX one = rolled(1);
    CHECK(same_bits(rolled(1024), one));
    CHECK(same_bits(rolled(1.0 / 1024), one));
}

TEST_CASE("what is hit wakes with all that it hangs together with and nothing else wakes", "[house]")
{
    SpaceScene scene = two_stacks(3);
    SleepingCones method;
    StepData<6> now;
    REQUIRE(until_all_sleep(scene, method, now, 300) < 300);
    const VecX x = scene.bodies.x;
    const Index ball = add_body(scene, {solid_ball(0.2)}, 20000.0, {-3, 2.6, 0});
    scene.friction.assign(scene.shapes.size(), 0.5);
    scene.bodies.velocity(ball)[0] = 15;
    step(scene, {.h = sixtieth}, method, now);
    for (int i = 0; i < 60 && !method.contacts.set.is_awake(2); ++i) {
        for (Index k = 0; k < 6; ++k) CHECK(method.contacts.set.is_asleep(k));
        CHECK(same_bits(scene.bodies.x.head(36), x.head(36)));
        step(scene, {.h = sixtieth}, method, now);
    }
    // all of the stack in the step in which the topmost was met, and none of the other
    for (Index k = 0; k < 3; ++k) CHECK(method.contacts.set.is_awake(k));
    for (Index k = 3; k < 6; ++k) CHECK(method.contacts.set.is_asleep(k));
    for (int i = 0; i < 60; ++i) {
        step(scene, {.h = sixtieth}, method, now);
        if (method.contacts.fell_asleep > 0) continue;  // its rows are of when it was awake
        for (const Row<6>& row : now.rows)
            for (const Index k : {row.a, row.b})
                if (k != world) CHECK_FALSE(method.contacts.set.is_asleep(k));
    }
    CHECK(same_bits(scene.bodies.x.segment(18, 18), x.segment(18, 18)));
    CHECK((centre_of(scene.bodies.x, 2) - centre_of(x, 2)).norm() > 0.1);
}

TEST_CASE("a sleeper wakes when it is pushed and when what it stands on or hangs on is changed", "[house]")
{
    SpaceScene start = two_stacks(2);
    const Index table = add_body(start, {solid_box({2, 0.5, 2})}, SolidMass{}, {20, 0.25, 0});
    const Index on_table = add_body(start, {solid_box({1, 1, 1})}, 1000.0, {20, 1, 0});
    const Index bob = add_body(start, {solid_ball(0.2)}, 1000.0, {30, 3, 0});
    start.joints.push_back(ball_joint(start, world, bob, {30, 4, 0}));
    start.friction.assign(start.shapes.size(), 0.5);
    const auto woken_by = [&](const auto& change) {
        SpaceScene scene = start;
        SleepingCones method;
        StepData<6> now;
        REQUIRE(until_all_sleep(scene, method, now, 300) < 300);
        change(scene);
        step(scene, {.h = sixtieth}, method, now);
        std::vector<int> awake;
        for (Index k = 0; k < scene.bodies.count(); ++k)
            if (method.contacts.set.is_awake(k)) awake.push_back(static_cast<int>(k));
        return awake;
    };
    using List = std::vector<int>;
    CHECK(woken_by([](SpaceScene&) {}).empty());
    CHECK(woken_by([](SpaceScene& s) { s.bodies.u[6] = 0.1; }) == List{0, 1});
    CHECK(woken_by([](SpaceScene& s) { s.bodies.u[6 * 2 + 4] = 0.1; }) == List{2, 3});
    CHECK(woken_by([](SpaceScene& s) { s.bodies.x[6 * 3 + 1] += 0.1; }) == List{2, 3});
    // the table is elsewhere: what stood on it falls
    CHECK(woken_by([=](SpaceScene& s) { s.bodies.x[6 * table] += 5; }) == List{static_cast<int>(on_table)});
    CHECK(woken_by([](SpaceScene& s) { s.joints.clear(); }) == List{static_cast<int>(bob)});
    CHECK(woken_by([](SpaceScene& s) { s.friction[3] = 0.4; }) == List{2, 3});
    const List all = {0, 1, 2, 3, static_cast<int>(on_table), static_cast<int>(bob)};
    CHECK(woken_by([](SpaceScene& s) { s.gravity *= 1.1; }) == all);
    CHECK(woken_by([](SpaceScene& s) { s.walls.clear(), s.wall_friction.clear(); }) == all);
    CHECK(woken_by([](SpaceScene& s) { s.wall_friction[0] = 0; }) == all);
}

TEST_CASE("what a sleeper stands on is known while others move", "[house]")
{
    SpaceScene scene;
    const Index table = add_body(scene, {solid_box({2, 0.5, 2})}, SolidMass{}, {20, 0.25, 0});
    const Index on_table = add_body(scene, {solid_box({1, 1, 1})}, 1000.0, {20, 1, 0});
    const Index glides = add_body(scene, {solid_box({1, 1, 1})}, 1000.0, {-20, 0.5, 0});
    add_floor(scene, 0.5);
    scene.friction[static_cast<std::size_t>(glides)] = 0;
    scene.bodies.velocity(glides)[0] = 1;
    SleepingCones method;
    StepData<6> now;
    for (int i = 0; i < 120; ++i) step(scene, {.h = sixtieth}, method, now);
    REQUIRE(method.contacts.set.is_asleep(on_table));
    REQUIRE(method.contacts.set.is_awake(glides));
    CHECK(now.contacts.size() == 4);  // those of what glides
    scene.bodies.x[6 * table] += 5;
    step(scene, {.h = sixtieth}, method, now);
    CHECK(method.contacts.set.is_awake(on_table));
    // and a table that comes wakes what it touches
    for (int i = 0; i < 240; ++i) step(scene, {.h = sixtieth}, method, now);
    REQUIRE(method.contacts.set.is_asleep(on_table));
    scene.bodies.x.segment<3>(6 * table) = centre_of(scene.bodies.x, on_table) + Vec3(1.495, 0, 0);
    step(scene, {.h = sixtieth}, method, now);
    CHECK(method.contacts.set.is_awake(on_table));
}

TEST_CASE("the residual of rest is a velocity also of rows that turn alone", "[house]")
{
    SpaceScene scene = hung_boxes();
    SleepingCones method;
    StepData<6> now;
    step(scene, {.h = sixtieth}, method, now);
    Random random(5);
    VecX u = scene.bodies.u;
    for (Real& v : u) v = random.uniform(-1e-3, 1e-3);
    int turning = 0;
    for (int i = 0; i < static_cast<int>(now.rows.size()); ++i) {
        const Row<6>& row = now.rows[static_cast<std::size_t>(i)];
        const bool turns = row.Ja.head<3>().isZero(0) && row.Jb.head<3>().isZero(0);
        const int rows[] = {i};
        now.length = 1;
        const Real one = natural_residual<6>(now, rows, u);
        now.length = 8;
        CHECK(natural_residual<6>(now, rows, u) == (turns ? 8 : 1) * one);
        turning += turns;
    }
    CHECK(turning == 30);  // two swings and a motor of each hinge
}

TEST_CASE("what creeps or glides or spins on does not sleep however slowly", "[house]")
{
    const auto sleeps = [](SpaceScene scene, int steps) {
        SleepingCones method;
        StepData<6> now;
        return until_all_sleep(scene, method, now, steps) < steps;
    };
    // a hundredth of a degree, without friction: 0.0017 m/s2, slower than the speed of rest for more than half a second
    CHECK_FALSE(sleeps(block_on_slope(0.01, 0.3, 0), 600));
    CHECK(sleeps(block_on_slope(10, 0.3, 0.5), 600));  // and this one holds
    SpaceScene glides = sliding_block(5e-4, 0.2, 0);
    CHECK_FALSE(sleeps(glides, 600));
    // a block that turns on the spot: its rim moves at 7e-4 m/s
    SpaceScene spins = sliding_block(0, 0, 0);
    spins.bodies.u[4] = 1e-3;
    CHECK_FALSE(sleeps(spins, 600));
    // an ellipsoid alone has no hull, and is as large as it is; what has neither is as large as its inertia says
    SpaceScene round = sliding_block(0, 0, 0);
    round.shapes[0].clear();
    Vec<6> turns = Vec<6>::Zero();
    turns[4] = 1;
    CHECK(measured_velocity(round, 0, turns)[4] == Approx(std::sqrt((1 + 1) / 12.0)));
    round.ellipsoids.push_back({0, {0, 0, 0}, Vec3(50, 0.1, 50).asDiagonal()});
    CHECK(measured_velocity(round, 0, turns)[4] >= 50);
    // a wheel that is held at its middle, or by an axle: no force moves it on, or turns it about another axis
    for (const int from : {0, 3}) {
        SpaceScene wheel = sliding_block(0, 0, 0);
        wheel.gravity.setZero(), wheel.shapes[0].clear(), wheel.walls.clear(), wheel.wall_friction.clear();
        wheel.bodies.inverse_mass.segment<3>(from).setZero();
        wheel.bodies.inverse_mass[4] = 6;
        wheel.bodies.u[4] = 5;
        CHECK(measured_velocity(wheel, 0, turns)[4] == Approx(from == 0 ? 1 : std::sqrt(1.0 / 6)));
        SleepingCones held;
        StepData<6> step_of_it;
        CHECK(until_all_sleep(wheel, held, step_of_it, 100) == 100);
        CHECK(wheel.bodies.u[4] == Approx(5));
    }
    // at the highest point of its flight a ball has no velocity
    SpaceScene thrown = thrown_ball(0, 0.5);
    thrown.bodies.x[1] = 3, thrown.bodies.u[1] = 0.02;
    SleepingCones method;
    StepData<6> now;
    for (int i = 0; i < 30; ++i) step(thrown, {.h = sixtieth}, method, now);
    CHECK(method.contacts.set.is_awake(0));
}

TEST_CASE("solids fall asleep in the same step in any unit of length", "[house]")
{
    const auto slept = [](Real scale) {
        SpaceScene scene = box_stack(3, 0.2, 0.5);
        for (Index k = 0; k < 3; ++k) scene.bodies.x[6 * k + 1] += 0.05 * static_cast<Real>(k + 1);
        scene.length = scale, scene.gravity *= scale;
        for (auto& shape : scene.shapes)
            for (Hull& hull : shape)
                for (Vec3& p : hull.vertices) p *= scale;
        for (Index k = 0; k < 3; ++k) {
            scene.bodies.x.segment<3>(6 * k) *= scale;
            scene.bodies.inverse_mass.segment<3>(6 * k + 3) /= scale * scale;
        }
        SleepingCones method;
        StepData<6> now;
        return until_all_sleep(scene, method, now, 2000);
    };
    // powers of two change no rounding
    const int steps = slept(1);
    CHECK(steps < 2000);
    CHECK(slept(1.0 / 1024) == steps);
    CHECK(slept(1024) == steps);
}

TEST_CASE("what is woken starts from the impulses that it fell asleep with", "[house]")
{
    SpaceScene scene = box_stack(6, 0.1, 0.5);
    // something goes on meanwhile: what is remembered from step to step is of that alone
    const Index glides = add_body(scene, {solid_box({1, 1, 1})}, 1000.0, {-20, 0.5, 0});
    scene.friction.push_back(0);
    scene.bodies.velocity(glides)[0] = 0.1;
    SleepingCones method = exact_sleep();
    StepData<6> now;
    for (int i = 0; i < 120; ++i) step(scene, {.h = sixtieth}, method, now);
    REQUIRE(method.contacts.set.awake == std::vector<int>{static_cast<int>(glides)});
    scene.bodies.u[6 * 5] += 1e-12;  // a touch: less than the residual of an answer
    SpaceScene cold = scene;
    step(scene, {.h = sixtieth}, method, now);
    CHECK(method.contacts.woken == 6);
    CHECK(method.solver.guesses == 0);
    TouchingCones fresh = exact_cones();
    step(cold, {.h = sixtieth}, fresh, now);
    CHECK(fresh.solver.guesses > 0);
}

TEST_CASE("settings of rest that make no sense are refused in space too", "[house]")
{
    SpaceScene scene = box_stack(2, 0, 0.5);
    SleepingCones method;
    StepData<6> now;
    method.contacts.rest.speed = -1;
    CHECK(sentence_of([&] { step(scene, {}, method, now); }) ==
          "the speed of rest is -1; it must be positive and finite");
    method.contacts.rest = {};
    method.contacts.touching.slack = 2;
    CHECK(sentence_of([&] { step(scene, {}, method, now); }) ==
          "the slack of contacts is 2 margins; it must be from 0 to 1");
    method.contacts.touching.slack = 0.01;
    scene.friction[0] = -1;
    CHECK(sentence_of([&] {
              step(scene, {}, method, now);
          }).find("number 0 of the bodies has the friction coefficient -1") == 0);
    scene.friction[0] = 1;
    method.correction.method = Stabilizer::projection;
    CHECK(sentence_of([&] { step(scene, {}, method, now); }).find("have no projection") != std::string::npos);
}

TEST_CASE("a step of solids that sleep asks for no memory", "[house]")
{
    SpaceScene scene = two_stacks(2);
    SleepingCones method;
    StepData<6> now;
    REQUIRE(until_all_sleep(scene, method, now, 300) < 300);
    const NoAllocation guard;
    for (int i = 0; i < 20; ++i) step(scene, {.h = sixtieth}, method, now);
    CHECK(NoAllocation::violations() == 0);
}
