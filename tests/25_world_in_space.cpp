/// Chapter 25: what hangs, what is built, what falls down stairs and what drives.

#include "chapters/14_joints/joint_method.hpp"
#include "chapters/14_joints/placed_joints.hpp"
#include "chapters/21_joints_in_space/gyroscope.hpp"
#include "chapters/25_world_in_space/built_scenes.hpp"
#include "chapters/25_world_in_space/car.hpp"
#include "chapters/25_world_in_space/doll_scenes.hpp"
#include "chapters/25_world_in_space/space_method.hpp"

#include "tests/catch.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

using namespace rigid;

namespace {

/// Exact contacts that bounce and leave no overlap.
TouchingCones bouncing(Real restitution)
{
    TouchingCones method = exact_cones();
    method.correction.restitution = restitution;
    method.correction.slop = 0;
    return method;
}

/// A cradle whose first `lifted` balls come with the speed v, without weight.
SpaceScene struck(int lifted, Real v, Real gap)
{
    Cradle cradle;
    cradle.lift = 0, cradle.gap = gap;
    SpaceScene scene = newtons_cradle(cradle);
    scene.gravity.setZero();
    for (Index k = 0; k < lifted; ++k) {
        scene.bodies.u[6 * k] = v;
        scene.bodies.u[6 * k + 5] = v / cradle.length;
    }
    return scene;
}

Real leaning(const SpaceScene& scene, Index k)
{
    const Vec3 way = centre_of(scene.bodies.x, k) - scene.joints[static_cast<std::size_t>(k)].at_a;
    return std::atan2(way.x(), -way.y());
}

}  // namespace

// ---- what hangs -----------------------------------------------------------------------------------

TEST_CASE("balls of a cradle that are apart hand their speed on to the last", "[idea]")
{
    for (const int lifted : {1, 2}) {
        SpaceScene scene = struck(lifted, 1, 0.002);
        TouchingCones method = bouncing(1);
        StepData<6> now;
        const Real before = energy(scene);
        for (int i = 0; i < 24; ++i) step(scene, {.h = 1.0 / 960}, method, now);
        for (Index k = 0; k < 5; ++k) {
            INFO(lifted << " " << k << " " << scene.bodies.u[6 * k]);
            // ways of 2 mm on a circle of 1 m turn the line of impact by 2e-3, a cosine of 1 - 2e-6
            CHECK(scene.bodies.velocity(k).head<3>().norm() ==
                  Approx(k >= 5 - lifted ? 1 : 0).margin(lifted == 1 ? 1e-4 : 1e-2));
        }
        // impacts keep it; on a circle of 1 m a step loses (h v)² of it, and there are 24
        CHECK(energy(scene) == Approx(before).epsilon(3e-5));
    }
}

TEST_CASE("balls that touch share the impact as the law of one instant has it", "[idea]")
{
    // (25.9): the first returns at 3/5 of its speed, and the four go together at 2/5
    SpaceScene scene = struck(1, 1, 0);
    TouchingCones method = bouncing(1);
    StepData<6> now;
    step(scene, {.h = 1.0 / 960}, method, now);
    CHECK(now.solution.status == Status::solved);
    CHECK(scene.bodies.u[0] == Approx(-0.6).margin(1e-6));
    for (Index k = 1; k < 5; ++k) CHECK(scene.bodies.u[6 * k] == Approx(0.4).margin(1e-6));
}

TEST_CASE("the last ball of a cradle rises as high as the first was lifted", "[idea]")
{
    const Cradle cradle;
    SpaceScene scene = newtons_cradle(cradle);
    TouchingCones method = bouncing(1);
    StepData<6> now;
    Real highest = 0, others = 0, fastest = 0;
    for (int i = 0; i < 960; ++i) {
        step(scene, {.h = 1.0 / 960}, method, now);
        fastest = std::max(fastest, scene.bodies.u[0]);
        highest = std::max(highest, leaning(scene, 4));
        for (Index k = 1; k < 4; ++k) others = std::max(others, std::abs(leaning(scene, k)));
    }
    INFO(fastest << " " << highest << " " << others);
    CHECK(fastest == Approx(meeting_speed(cradle)).epsilon(2e-3));  // first order in h
    CHECK(highest == Approx(cradle.lift).epsilon(5e-3));
    CHECK(others < 0.01);  // a gap of 2 mm to each side, on 1 m
}

// ---- what is built --------------------------------------------------------------------------------

TEST_CASE("a brick wall stands until a wrecking ball hits it", "[idea]")
{
    SpaceScene scene = brick_wall(5, 5, 0.6);
    const Index bricks = scene.bodies.count();
    WreckingBall ball;
    ball.links = 5;
    add_wrecking_ball(scene, ball, 0.6);
    const VecX start = scene.bodies.x;
    const auto moved = [&] {
        Real most = 0;
        for (Index k = 0; k < bricks; ++k)
            most = std::max(most, (scene.bodies.x.segment<3>(6 * k) - start.segment<3>(6 * k)).norm());
        return most;
    };
    TouchingCones method;
    method.solver.sweeps = {50, 1e-6};
    StepData<6> now;
    Real stood = 0, gap = 0, top = energy(scene);
    bool hit = false;
    for (int i = 0; i < 180; ++i) {
        step(scene, {.h = 1.0 / 60, .substeps = 4}, method, now);
        for (const SpaceContact& contact : now.contacts)
            hit = hit || (contact.b == scene.bodies.count() - 1 && contact.a != world);
        if (!hit) stood = moved();
        gap = std::max(gap, largest_joint_error(scene));
        top = std::max(top, energy(scene));
    }
    INFO(stood << " " << moved() << " " << gap << " " << top - energy(scene));
    CHECK(hit);
    CHECK(stood < 5e-4);  // half of the slop; measured 0.013 mm
    CHECK(moved() > 0.5);
    CHECK(gap < 0.03);  // the blow of a ton; measured 13.5 mm
}

TEST_CASE("a tower of cards stands by friction and falls without enough of it", "[idea]")
{
    const Real lean = 17 * pi / 180;
    for (const Real mu : {0.6, 0.1}) {
        SpaceScene scene = card_tower(3, lean, mu);
        const VecX start = scene.bodies.x;
        TouchingCones method = exact_cones(2000);
        StepData<6> now;
        for (int i = 0; i < 120; ++i) step(scene, {.h = 1.0 / 60}, method, now);
        Real most = 0;
        for (Index k = 0; k < scene.bodies.count(); ++k)
            most = std::max(most, (scene.bodies.x.segment<3>(6 * k) - start.segment<3>(6 * k)).norm());
        INFO(mu << " " << most);
        // the slop is a thousandth of 1 m; each storey adds its own
        if (mu > 0.5) CHECK(most < 0.01);
        else CHECK(most > 0.3);
    }
}

// ---- what falls and drives --------------------------------------------------------------------------

TEST_CASE("dolls on stairs keep their joints and limits and gain no energy", "[idea]")
{
    SpaceScene scene = dolls_on_stairs(2, 2);
    TouchingCones method;
    method.solver.sweeps = {50, 1e-6};
    StepData<6> now;
    Real gap = 0, over = 0, gained = 0, least = energy(scene);
    for (int i = 0; i < 240; ++i) {
        step(scene, {.h = 1.0 / 60, .substeps = 4}, method, now);
        gap = std::max(gap, largest_joint_error(scene));
        over = std::max(over, largest_limit_error(scene));
        const Real E = energy(scene);
        gained = std::max(gained, E - least);
        least = std::min(least, E);
    }
    const Vec3 head = centre_of(scene.bodies.x, 12);
    INFO(gap << " " << over << " " << gained << " " << least << " " << head.transpose());
    // a fall onto a step at 4 m/s, of which 50 sweeps leave something; measured 7.4 mm and 0.012 rad
    CHECK(gap < 0.02);
    CHECK(over < 0.05);
    // what lifts a part out of an overlap, of 2,800 J; measured 0.07 J
    CHECK(gained < 1);
    CHECK(head.x() > 0.5);  // it is on its way down
}

TEST_CASE("a joint that is exactly straight has a cone all the same", "[house]")
{
    // straight, the cone's row leans to no side and moves nothing: it has no island, and no place among those that do
    SpaceScene scene;
    for (int i = 0; i < 3; ++i) {
        add_body(scene, {solid_capsule(0.5, 0.1)}, 1000.0, Vec3(i, 2, 0), {0, pi / 2, 0});
        if (i == 0) continue;
        SpaceJoint joint = ball_joint(scene, i - 1, i, {i - 0.5, 2, 0}, {1, 0, 0});
        joint.hi[cone] = 0.3;
        scene.joints.push_back(joint);
    }
    add_floor(scene, 0.5);
    for (const int exact_rows : {0, 1000}) {
        SpaceScene falls = scene;
        TouchingCones method;
        method.solver.exact_rows = exact_rows;
        SpaceIslands by_islands;
        StepData<6> now, then;
        step(falls, {.h = 1.0 / 60}, method, now);
        int still = 0;
        for (const Row<6>& row : now.rows) still += !moves_a(row) && !moves_b(row);
        CHECK(still == 2);
        CHECK(now.solution.lambda.allFinite());
        for (Index k = 0; k < 3; ++k) CHECK(falls.bodies.u[6 * k + 1] == Approx(-9.81 / 60));
        for (int i = 0; i < 120; ++i) step(falls, {.h = 1.0 / 60}, method, now);
        CHECK(largest_joint_error(falls) < 1e-3);
        SpaceScene other = scene;
        step(other, {.h = 1.0 / 60}, by_islands, then);
        for (Index k = 0; k < 3; ++k) CHECK(other.bodies.u[6 * k + 1] == Approx(-9.81 / 60));
    }
}

TEST_CASE("a car sinks on its struts by m g over 4 k and drives as fast as its motors say", "[idea]")
{
    const Car car;
    SpaceScene scene = car_on_floor(car, 0.8);
    TouchingCones method;
    method.solver.sweeps = {100, 1e-9};
    method.correction.slop = 0;
    StepData<6> now;
    const Real h = 1.0 / 240;
    const Real wheel = 1 / scene.bodies.inverse_mass[6 + 3];  // about its axle, which is its x axis
    const Real a =
        4 * car.torque / car.radius / (car.mass + 4 * car.wheel_mass + 4 * wheel / (car.radius * car.radius));
    Real at_one = 0;
    for (int i = 0; i < 2400; ++i) {
        push_struts(scene, car, h);
        step(scene, {.h = h}, method, now);
        if (i == 239) at_one = scene.bodies.u[0];
    }
    const Real height = car.radius + 0.25 - scene.bodies.x[1];
    INFO(at_one << " " << a << " " << scene.bodies.u[0] << " " << height);
    CHECK(at_one == Approx(a).epsilon(0.03));  // while it rocks on its struts
    CHECK(scene.bodies.u[0] == Approx(car.speed).epsilon(1e-4));
    CHECK(height == Approx(car.sink).epsilon(1e-3));
    CHECK(largest_joint_error(scene) < 1e-3);
}

TEST_CASE("struts push wheels alone and no car is refused", "[house]")
{
    const Car car;
    SpaceScene alone = car_on_floor(car, 0.8);
    alone.bodies.x[1] -= 0.05;  // it sinks on its struts
    SpaceScene scene = alone;
    const Index trailer = add_body(scene, {solid_box({1, 0.5, 1})}, 100.0, {-3, 0.5, 0});
    give_friction(scene, trailer, 0.8);
    scene.joints.push_back(ball_joint(scene, 0, trailer, {-2, 0.5, 0}));
    WreckingBall ball;
    ball.links = 2;
    add_wrecking_ball(scene, ball, 0.5);  // on a hook of the world
    CHECK(scene.friction[0] == 0.8);
    scene.bodies.x[6 * trailer + 1] += 0.1;
    push_struts(alone, car, 1.0 / 240);
    push_struts(scene, car, 1.0 / 240);
    CHECK(alone.bodies.u.norm() > 0.1);
    CHECK(scene.bodies.u.head(30) == alone.bodies.u);
    CHECK(scene.bodies.u.tail(scene.bodies.u.size() - 30).isZero(0));
    SpaceScene none = brick_wall(2, 2, 0.5);
    CHECK(sentence_of([&] { push_struts(none, car, 1.0 / 240); }) ==
          "joint 0 of the scene holds no wheel 1 of a car on body 0");
    // a doll is rough, and what is smooth stays so
    SpaceScene smooth;
    add_body(smooth, {solid_box({1, 1, 1})}, 100.0, {0, 0.5, 0});
    add_doll(smooth, {3, 0, 0});
    CHECK(smooth.friction[0] == 0);
    CHECK(smooth.friction[1] == 0.5);
}

TEST_CASE("scenes of what cannot be are refused with a sentence", "[house]")
{
    const auto with = [](const auto& change, auto thing, const auto& make) {
        change(thing);
        return sentence_of([&] { make(thing); });
    };
    const auto cradle = [&with](const auto& change) { return with(change, Cradle{}, newtons_cradle); };
    CHECK(cradle([](Cradle&) {}) == "accepted");
    CHECK(cradle([](Cradle& c) { c.balls = 0; }) ==
          "the number of balls of a cradle is 0; it must be 1 or more");
    CHECK(cradle([](Cradle& c) { c.lifted = 6; }) == "a cradle of 5 balls has 6 of them lifted");
    CHECK(cradle([](Cradle& c) { c.gap = -0.1; }) ==
          "the gap of a cradle's balls is -0.1 m; it must be zero or positive and finite");
    CHECK(cradle([](Cradle& c) { c.radius = 0; }) ==
          "the radius of a cradle's balls is 0; it must be positive and finite");
    CHECK(cradle([](Cradle& c) { c.length = infinity; }) ==
          "the length of a cradle's rods is inf; it must be positive and finite");
    CHECK(cradle([](Cradle& c) { c.lift = std::nan(""); }) != "accepted");

    const auto ball = [&with](const auto& change) {
        return with(change, WreckingBall{}, [](const WreckingBall& b) {
            SpaceScene scene;
            try {
                add_wrecking_ball(scene, b, 0.5);
            } catch (...) {
                CHECK(scene.bodies.count() == 0);  // nothing is left of it
                throw;
            }
        });
    };
    CHECK(ball([](WreckingBall& b) { b.links = 0; }) == "accepted");
    CHECK(ball([](WreckingBall& b) { b.links = -1; }) ==
          "a wrecking ball hangs on -1 links; it must be zero or more");
    CHECK(ball([](WreckingBall& b) { b.mass = 0; }) ==
          "the mass of a wrecking ball is 0; it must be positive and finite");
    CHECK(ball([](WreckingBall& b) { b.radius = -1; }) ==
          "the radius of a wrecking ball is -1; it must be positive and finite");
    CHECK(ball([](WreckingBall& b) { b.link_length = 0.1; }) ==
          "a link of a wrecking ball's chain is 0.1 m long; it must be finite and more than the 0.1 m that "
          "its ends "
          "take");

    const auto car = [&with](const auto& change) {
        return with(change, Car{}, [](const Car& c) { car_on_floor(c, 0.5); });
    };
    CHECK(car([](Car& c) { c.sink = 0; }) == "the way that a car sinks is 0; it must be positive and finite");
    CHECK(car([](Car& c) { c.damping = -1; }) == "a car has the damping -1, the torque 120 N m and the speed "
                                                 "5 m/s; none may be infinite, and the first two "
                                                 "not negative");
    CHECK(car([](Car& c) { c.speed = std::nan(""); }) != "accepted");
    SpaceScene driven = car_on_floor({}, 0.5);
    Car stiff;
    stiff.sink = 0;
    CHECK(sentence_of([&] { push_struts(driven, stiff, 1.0 / 60); }) ==
          "the way that a car sinks is 0; it must be positive and finite");
    CHECK(sentence_of([&] { push_struts(driven, {}, std::nan("")); }) != "accepted");
    CHECK(driven.bodies.u.isZero(0));

    CHECK(sentence_of([] { dolls_on_stairs(1, 1, 0); }) ==
          "the number of steps of stairs is 0; it must be 1 or more");
    CHECK(sentence_of([] { dolls_on_stairs(0, 1); }) == "the number of dolls is 0; it must be 1 or more");
    CHECK(sentence_of([] {
              SpaceScene scene;
              add_stairs(scene, 3, -1, 0.5);
          }) == "the width of stairs is -1; it must be positive and finite");
    CHECK(sentence_of([] { brick_wall(0, 3, 0.5); }) ==
          "the number of rows of a wall is 0; it must be 1 or more");
    CHECK(sentence_of([] { card_tower(2, 1.6, 0.5); }) ==
          "the lean of a card is 1.6 rad; it must be below a quarter turn");
    CHECK(sentence_of([] { heavy_chain(3, 0); }) ==
          "the mass at the end of a chain is 0; it must be positive and finite");
    CHECK(sentence_of([] { heavy_chain(-1, 10); }) == "a chain has -1 links; it needs at least one");

    // a residual that is anything would be an answer
    SpaceScene stack = box_stack(2, 0, 0.5);
    TouchingCones method;
    method.solver.sweeps.tolerance = infinity;
    StepData<6> now;
    CHECK(sentence_of([&] { step(stack, {}, method, now); }) ==
          "the tolerance of the sweeps is inf; it must be zero or positive, and finite");
}

TEST_CASE("poured hulls stay in their pit and lose energy", "[house]")
{
    SpaceScene scene = mixed_heap(200, 0.5, 3, 6);
    TouchingCones method;
    StepData<6> now;
    Real before = energy(scene), gained = 0;
    for (int i = 0; i < 120; ++i) {
        step(scene, {.h = 1.0 / 60, .substeps = 2}, method, now);
        const Real E = energy(scene);
        gained = std::max(gained, E - before);
        before = E;
    }
    // floor of 2 × 2.2 m, sides of 45°
    Real deepest = -infinity;
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Vec3 p = centre_of(scene.bodies.x, k);
        deepest = std::max({deepest, std::abs(p.x()) - 2.2 - p.y(), std::abs(p.z()) - 2.2 - p.y(), -p.y()});
    }
    INFO(gained << " " << deepest);
    CHECK(deepest <= 0);
    CHECK(gained < 1);  // of a hundred thousand; measured none
}
