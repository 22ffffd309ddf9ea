/// Chapter 25: solids that go farther than their size in a step.

#include "tests/no_allocation.hpp"

#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"
#include "chapters/25_world_in_space/space_sleep.hpp"

#include "tests/catch.hpp"
#include "tests/sentence.hpp"
#include "tests/solids.hpp"

using namespace rigid;

namespace {

Hull any_hull(Random& random, int kind)
{
    if (kind == 0) return solid_ball(random.uniform(0.02, 0.1));
    if (kind == 1) {
        const Real length = random.uniform(0.2, 1);
        return solid_capsule(length, random.uniform(0.01, 0.05));
    }
    if (kind == 2) return solid_box(Vec3(0.3, 0.3, 0.3) + any_vector(random, 0.27));
    std::vector<Vec3> cloud;
    for (int i = 0; i < 10; ++i) cloud.push_back(any_vector(random, 0.2));
    return solid_hull(cloud);
}

/// A plate of 1 cm across x, 4 m wide, that cannot move; without weight.
SpaceScene plate()
{
    SpaceScene scene;
    scene.gravity.setZero();
    scene.length = 1;
    add_body(scene, {solid_box({0.01, 4, 4})}, SolidMass{}, {0, 0, 0});
    return scene;
}

TouchingCones stopping(Real restitution = 0)
{
    TouchingCones method;
    method.contacts.fast.stop = true;
    method.correction.restitution = restitution;
    return method;
}

MovingSolid any_motion(Random& random, const std::vector<SolidForm>& forms, Real far, Real turn)
{
    MovingSolid m;
    m.forms = &forms;
    m.from = any_vector(random, 1);
    m.way = any_vector(random, far);
    m.R = rotation_matrix(any_vector(random, 1.7));
    m.turn = any_vector(random, turn);
    return m;
}

}  // namespace

TEST_CASE("the gap of two solids never closes faster than (25.7)", "[house]")
{
    Random random(3);
    SolidImpactMemory memory;
    for (int i = 0; i < 500; ++i) {
        const std::vector<SolidForm> a = {form_of(any_hull(random, i % 4))},
                                     b = {form_of(any_hull(random, i / 4 % 4))};
        const MovingSolid p = any_motion(random, a, 2, 4), q = any_motion(random, b, 2, 4);
        const auto at = [&](Real part) {
            return gap_of(p.place(a[0], part, memory.a), q.place(b[0], part, memory.b));
        };
        for (Real part = 0; part < 0.95; part += 0.1) {
            const SolidGap now = at(part), later = at(part + 0.03);
            const Real r = now.normal.dot(p.way - q.way) + turning(p, a[0]) + turning(q, b[0]);
            CHECK(later.gap >= now.gap - 0.03 * r - 1e-12);
        }
    }
}

TEST_CASE("of ten thousand random shots no impact is missed and none is where small steps have none",
          "[house]")
{
    Random random(17);
    SolidImpactMemory memory;
    const Real target = 0.005, tolerance = 0.005;
    int hits = 0, passes = 0, cut_off = 0;
    for (int i = 0; i < 10000; ++i) {
        const std::vector<SolidForm> a = {form_of(any_hull(random, i % 4))},
                                     b = {form_of(any_hull(random, i / 4 % 4))};
        MovingSolid p = any_motion(random, a, 4, 6);
        const MovingSolid q = any_motion(random, b, 1, 2);
        // every other one is aimed
        if (i % 2 == 0) {
            const Real times = random.uniform(0.5, 4);
            p.way = times * (q.from - p.from) + any_vector(random, 0.3);
        }
        const Impact impact = time_of_impact(p, a[0], q, b[0], target, tolerance, memory);
        if (impact.close) continue;
        const auto gap = [&](Real part) {
            return gap_of(p.place(a[0], part, memory.a), q.place(b[0], part, memory.b)).gap;
        };
        // no small step before the impact, or before the end, is nearer than the target
        const int steps = 100;
        bool touched = false;
        for (int k = 0; k <= steps && !touched; ++k) {
            const Real part = static_cast<Real>(k) / steps;
            touched = part < impact.part && gap(part) < target - 1e-9;
        }
        CHECK_FALSE(touched);
        hits += impact.hit;
        passes += !impact.hit;
        cut_off += impact.rounds > 100;
        // and where it says that they meet, they do
        if (impact.hit && impact.rounds <= 100) CHECK(gap(impact.part) <= target + tolerance + 1e-12);
    }
    CHECK(hits > 2000);
    CHECK(passes > 4000);
    CHECK(cut_off == 0);
}

TEST_CASE("a thin plate is not passed by a ball or a rod that spins or a hull that turns", "[house]")
{
    Random random(8);
    int passed_without = 0;
    for (int i = 0; i < 60; ++i) {
        SpaceScene scene = plate();
        const Hull hull = i % 3 == 0   ? solid_ball(0.05)
                          : i % 3 == 1 ? solid_capsule(0.8, 0.02)
                                       : any_hull(random, 3);
        const Real phase = random.uniform(0, 3.4);
        const Vec3 theta = any_vector(random, 1.5), spin = any_vector(random, 150);
        const Index k = add_body(scene, {hull}, 1000.0, {-2 - phase, 0, 0}, theta);
        scene.bodies.velocity(k) << 200, 0, 0, spin;
        SpaceScene free = scene;
        TouchingCones method = stopping(), none;
        StepData<6> now, then;
        int impacts = 0;
        for (int n = 0; n < 6; ++n) {
            step(scene, {.h = sixtieth}, method, now);
            step(free, {.h = sixtieth}, none, then);
            impacts += method.contacts.fast.impacts;
            CHECK(centre_of(scene.bodies.x, k).x() < 0);
        }
        CHECK(impacts > 0);
        passed_without += centre_of(free.bodies.x, k).x() > 0;
    }
    CHECK(passed_without > 40);  // without the search most of them are behind it
}

TEST_CASE("what passes beside a plate is not stopped and keeps its bits", "[house]")
{
    Random random(9);
    for (int i = 0; i < 30; ++i) {
        SpaceScene scene = plate();
        const bool far = i >= 20;  // so far that no distance is computed
        const Vec3 at(-2 - random.uniform(0, 3), far ? 6 : 2.7, 0);
        const Hull hull = any_hull(random, i % 4);
        const Index k = add_body(scene, {hull}, 1000.0, at, any_vector(random, 1.5));
        scene.bodies.velocity(k) << 200, 0, 0, any_vector(random, 100);
        SpaceScene free = scene;
        TouchingCones method = stopping(), none;
        StepData<6> now;
        for (int n = 0; n < 4; ++n) {
            step(scene, {.h = sixtieth}, method, now);
            step(free, {.h = sixtieth}, none, now);
            CHECK(method.contacts.fast.bodies.size() == 1);
            CHECK(method.contacts.fast.impacts == 0);
            if (far) CHECK(method.contacts.fast.rounds == 0);
        }
        CHECK(same_bits(scene.bodies.x, free.bodies.x));
        CHECK(same_bits(scene.bodies.u, free.bodies.u));
    }
}

TEST_CASE("two bullets that are shot at each other meet and a third that follows stops behind", "[house]")
{
    SpaceScene scene;
    scene.gravity.setZero();
    scene.length = 1;
    for (const Real x : {-2.3, 1.9, -3.1}) {
        const Index k = add_body(scene, {solid_ball(0.05)}, 1000.0, {x, 0, 0});
        scene.bodies.velocity(k)[0] = x < 0 ? 200 : -150;
    }
    TouchingCones method = stopping();
    StepData<6> now;
    for (int n = 0; n < 5; ++n) {
        step(scene, {.h = sixtieth}, method, now);
        CHECK(scene.bodies.x[12] < scene.bodies.x[0]);
        CHECK(scene.bodies.x[0] < scene.bodies.x[6]);
    }
}

TEST_CASE("a stop keeps momentum and angular momentum and no energy comes from it", "[house]")
{
    Random random(10);
    int impacts = 0;
    for (int i = 0; i < 40; ++i) {
        SpaceScene scene;
        scene.gravity.setZero();
        scene.length = 1;
        const bool balls = i % 4 == 0;
        const Hull hit = any_hull(random, balls ? 0 : 2);
        add_body(scene, {hit}, 1000.0, {0, 0, 0}, any_vector(random, 1));
        const Hull comes = any_hull(random, i % 4);
        const Real x = -3 - random.uniform(0, 3), y = random.uniform(-0.05, 0.05);
        add_body(scene, {comes}, 1000.0, {x, y, 0}, any_vector(random, 1));
        scene.bodies.velocity(1) << 200, 0, 0, any_vector(random, 40);
        scene.bodies.velocity(0) << any_vector(random, 20), any_vector(random, 40);
        TouchingCones method = stopping(0.5);
        StepData<6> now;
        const Vec<6> before = momenta(scene.bodies);
        const Real energy = kinetic_energy(scene.bodies);
        for (int n = 0; n < 6; ++n) {
            step(scene, {.h = sixtieth}, method, now);
            impacts += method.contacts.fast.impacts;
            const Vec<6> after = momenta(scene.bodies);
            // roundings of what the bodies have, some of which cancels
            const Real whole = 200 / scene.bodies.inverse_mass[6] + 20 / scene.bodies.inverse_mass[0];
            CHECK((after - before).norm() < 1e-10 * whole * 10);
            // not of hulls: they may turn by many radians a step after such a blow, and their energy was seen to grow
            if (balls) CHECK(kinetic_energy(scene.bodies) < energy * (1 + 1e-12));
        }
    }
    CHECK(impacts > 20);
}

TEST_CASE("a ball at two hundred metres a second bounces off a plate with its restitution", "[house]")
{
    for (const Real restitution : {0.0, 0.3, 0.8, 1.0}) {
        SpaceScene scene = plate();
        const Index k = add_body(scene, {solid_ball(0.05)}, 1000.0, {-5, 0, 0});
        scene.bodies.velocity(k)[0] = 200;
        TouchingCones method = stopping(restitution);
        StepData<6> now;
        for (int n = 0; n < 6; ++n) step(scene, {.h = sixtieth}, method, now);
        // what it may still come nearer in the step of the bounce is less than the margin
        CHECK(scene.bodies.velocity(k)[0] == Approx(-200 * restitution).margin(0.02 * 60));
        CHECK(centre_of(scene.bodies.x, k).x() < -0.05);
    }
}

TEST_CASE("a ball that falls and is stopped has the energy of its height", "[house]")
{
    SpaceScene scene;
    const Index k = add_body(scene, {solid_ball(0.05)}, 1000.0, {0, 20, 0});
    add_floor(scene, 0);
    scene.length = 1;
    TouchingCones method = stopping();
    StepData<6> now;
    const Real h = sixtieth;
    int steps = 0;
    for (; steps < 1000 && method.contacts.fast.impacts == 0; ++steps) step(scene, {.h = h}, method, now);
    REQUIRE(method.contacts.fast.impacts == 1);
    // n steps make the speed n h g and fall h^2 g n (n + 1)/2; of the last one the part tau, and (12.10): the energy is
    // h^2 g^2/2 ((1 - tau)^2 - n) above that of the start
    const Real v = scene.bodies.velocity(k)[1], fallen = 20 - scene.bodies.x[6 * k + 1];
    const Real unit = h * h * 9.81 * 9.81 / 2, above = (v * v / 2 - 9.81 * fallen) / unit;
    CHECK(above > -steps - 1e-8);
    CHECK(above < 1 - steps + 1e-8);
}

TEST_CASE("where nothing is fast nothing is looked for and the bits are the same", "[house]")
{
    for (const auto& start : {box_stack(4, 0.1, 0.5), block_on_slope(10, 0.3, 0.1)}) {
        SpaceScene scene = start, other = start;
        TouchingCones method = stopping(), none;
        StepData<6> now;
        for (int n = 0; n < 60; ++n) {
            step(scene, {.h = sixtieth}, method, now);
            step(other, {.h = sixtieth}, none, now);
            CHECK(method.contacts.fast.bodies.empty());
            CHECK(method.contacts.fast.rounds == 0);
        }
        CHECK(same_bits(scene.bodies.x, other.bodies.x));
    }
}

TEST_CASE("a bullet wakes what sleeps and does not pass it", "[house]")
{
    SpaceScene scene = box_stack(2, 0, 0.5);
    SleepingCones method;
    method.contacts.touching.fast.stop = true;
    StepData<6> now;
    for (int n = 0; n < 120; ++n) step(scene, {.h = sixtieth}, method, now);
    REQUIRE(method.contacts.set.awake.empty());
    const Index k = add_body(scene, {solid_ball(0.05)}, 1000.0, {-6, 1.5, 0});
    scene.friction.push_back(0.5);
    scene.bodies.velocity(k)[0] = 200;
    Real fastest = 0;  // friction brings it to rest in two steps
    for (int n = 0; n < 4; ++n) {
        step(scene, {.h = sixtieth}, method, now);
        fastest = std::max(fastest, scene.bodies.velocity(1)[0]);
        CHECK(centre_of(scene.bodies.x, k).x() < centre_of(scene.bodies.x, 1).x());
    }
    CHECK(method.contacts.set.is_awake(1));
    CHECK(fastest > 0.005);
}

TEST_CASE("a turn of more than half a turn in a step is not taken for the shorter way round", "[house]")
{
    SpaceScene scene = plate();
    const Index k = add_body(scene, {solid_capsule(0.8, 0.02)}, 1000.0, {-5, 0, 0});
    for (const Real turns : {0.3, 0.6, 1.2, -0.7, -2.4}) {
        SpaceScene other = scene;
        other.bodies.velocity(k) << 0, 0, 0, 0, 2 * pi * turns / sixtieth, 0;
        const VecX before = other.bodies.x;
        other.bodies.integrate(k, Vec<6>(other.bodies.velocity(k)), sixtieth);
        const MovingSolid m =
            motion_of({}, before, other.bodies.x, k, sixtieth * other.bodies.u.segment<3>(6 * k + 3));
        CHECK(m.turn.norm() == Approx(2 * pi * std::abs(turns)));
        CHECK((m.axes_at(1) - rotation_of(other.bodies.x, k)).norm() < 1e-12);
    }
}

TEST_CASE("a step that looks at fast solids asks for no memory", "[house]")
{
    SpaceScene scene = plate();
    add_body(scene, {solid_ball(0.05)}, 1000.0, {-50, 0, 0});
    scene.bodies.u[6] = 200;
    TouchingCones method = stopping();
    StepData<6> now;
    for (int n = 0; n < 4; ++n) step(scene, {.h = sixtieth}, method, now);
    const NoAllocation guard;
    for (int n = 0; n < 4; ++n) step(scene, {.h = sixtieth}, method, now);
    CHECK(NoAllocation::violations() == 0);
}

TEST_CASE("solids that look ahead do not overlap by what they move in a step", "[house]")
{
    const auto deepest_of = [](Real ahead) {
        SpaceScene scene;
        scene.length = 1;
        const Index k = add_body(scene, {solid_box({0.5, 0.5, 0.5})}, 1000.0, {0, 1.03, 0});
        add_body(scene, {solid_box({4, 0.5, 4})}, SolidMass{}, {0, 0, 0});
        scene.bodies.velocity(k)[1] = -5;
        TouchingCones method;
        method.contacts.ahead = ahead;
        StepData<6> now;
        Real deepest = 0;
        for (int n = 0; n < 20; ++n) {
            step(scene, {.h = sixtieth}, method, now);
            deepest = std::max(deepest, 0.5 - scene.bodies.x[6 * k + 1]);
        }
        return deepest;
    };
    CHECK(deepest_of(0) > 0.02);
    CHECK(deepest_of(1) < 1e-9);  // rows end where the surfaces are
}

TEST_CASE("what tumbles looks for a wall as far as it goes in a step", "[idea]")
{
    // the ends of a rod come down by 0.2 m in a step, twice its radius
    Real deepest = 0, deepest_without = 0;
    for (const Real ahead : {0.0, 1.0})
        for (int i = 0; i < 10; ++i) {
            SpaceScene scene;
            scene.length = 1;
            const Index k =
                add_body(scene, {solid_capsule(1, 0.1)}, 1000.0, {0, 0.75 + 0.04 * i, 0}, {0, 0, 0.2 * i});
            scene.bodies.velocity(k).tail<3>() = Vec3(0, 6, 20);
            add_floor(scene, 0.5);
            TouchingCones method = exact_cones();
            method.contacts.ahead = ahead;
            StepData<6> now;
            for (int n = 0; n < 90; ++n) {
                step(scene, {.h = sixtieth}, method, now);
                for (const Vec3& end : scene.shapes[0][0].vertices) {
                    Real& most = ahead > 0 ? deepest : deepest_without;
                    most = std::max(most, 0.1 - point_of_solid(scene.bodies.x, k, end).y());
                }
            }
        }
    CAPTURE(deepest, deepest_without);
    CHECK(deepest_without > 0.1);
    // half of the slop; an arc is not its tangent, and a row that ends in the wall lets it through by less
    CHECK(deepest < 5e-4);
}

TEST_CASE("a box that slides fast looks far and lies on its lower corners", "[house]")
{
    SpaceScene scene = block_on_slope(0, 0, 0), slow = scene;
    scene.bodies.u[0] = 60;  // 1 m in a step, the length of the block
    TouchingCones method = exact_cones();
    method.contacts.ahead = 1;
    StepData<6> now;
    for (int n = 0; n < 60; ++n) {
        step(scene, {.h = sixtieth}, method, now);
        CHECK(now.contacts.size() == 4);
        CHECK(method.contacts.way_of[0] > 1);
    }
    CHECK(scene.bodies.u[0] == Approx(60).epsilon(1e-12));
    CHECK(std::abs(scene.bodies.x[1] - slow.bodies.x[1]) < 1e-9);
}

TEST_CASE("two solids that their row holds are not stopped and what comes from afar is", "[house]")
{
    for (const bool on_wall : {false, true})
        for (const Real ahead : {0.0, 1.0}) {
            SpaceScene scene;
            scene.gravity.setZero();
            scene.length = 1;
            const Index k = add_body(scene, {solid_ball(0.5)}, 1000.0, {0, 0.8, 0});
            // it goes by a third of a metre in a step, two thirds of its inner radius
            scene.bodies.velocity(k)[1] = -20;
            if (on_wall) scene.walls.push_back({{0, 1, 0}, 0});
            else add_body(scene, {solid_ball(0.5)}, SolidMass{}, {0, -0.5, 0});
            if (on_wall) scene.wall_friction.assign(1, 0);
            scene.friction.assign(static_cast<std::size_t>(scene.bodies.count()), 0);
            TouchingCones method = stopping();
            method.contacts.ahead = ahead;
            StepData<6> now;
            step(scene, {.h = sixtieth}, method, now);
            INFO((on_wall ? "a wall, " : "a ball, ") << ahead);
            REQUIRE(method.contacts.fast.bodies.size() == 1);
            CHECK(method.contacts.fast.impacts == (ahead > 0 ? 0 : 1));
            // its row lets it touch; what is stopped stops a quarter to a half of the margin before
            const Real gap = scene.bodies.x[1] - 0.5, margin = StepSettings{}.margin;
            if (ahead > 0) CHECK(std::abs(gap) < 1e-9);
            else CHECK((gap > 0.2 * margin && gap < 0.55 * margin));
        }
}

TEST_CASE("what is slow looks no farther than the margin and less than nothing is refused", "[house]")
{
    SpaceScene scene = box_stack(3, 0.1, 0.5), other = scene;
    TouchingCones method, none;
    method.contacts.ahead = 1;
    StepData<6> now;
    for (int n = 0; n < 30; ++n) {
        step(scene, {.h = sixtieth}, method, now);
        step(other, {.h = sixtieth}, none, now);
    }
    CHECK(same_bits(scene.bodies.x, other.bodies.x));
    CHECK(method.contacts.ahead_of == std::vector<Real>(3, 0));
    method.contacts.ahead = -1;
    CHECK(sentence_of([&] { step(scene, {}, method, now); }) ==
          "solids look -1 inner radii ahead; it must be zero or positive and finite");
}
