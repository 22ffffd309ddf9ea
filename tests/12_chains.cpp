/// Chapter 12: floors of many edges, and bodies that are stopped on their way.

#include "chapters/12_contact_manifolds/chains.hpp"
#include "chapters/12_contact_manifolds/stacks.hpp"

#include "tests/catch.hpp"
#include "tests/limit.hpp"
#include "tests/sentence.hpp"

using namespace rigid;

namespace {

enum class Floor { boxes, chain };

/// A floor of 110 pieces of half a metre from the origin on, each turned by `bend` against the one before it, and a
/// body 0.2 m over it that slides along it.
RigidScene sliding(Floor kind, const Polygon& shape, Real speed, Real bend, const Vec2& gravity)
{
    RigidScene scene;
    scene.gravity = gravity;
    scene.length = 1;
    std::vector<Vec2> points = {{0, 0}};
    for (int i = 0; i < 110; ++i)
        points.push_back(points.back() + 0.5 * Vec2(std::cos(i * bend), std::sin(i * bend)));
    for (int i = 0; i < 110 && kind == Floor::boxes; ++i) {
        const Vec2 middle =
            (points[static_cast<std::size_t>(i)] + points[static_cast<std::size_t>(i + 1)]) / 2;
        add_body(scene, box(0.5, 0.5), Mass{}, middle + 0.25 * Vec2(std::sin(i * bend), -std::cos(i * bend)),
                 i * bend);
    }
    std::reverse(points.begin(), points.end());
    if (kind == Floor::chain) add_chain(scene, points);
    const Index b = add_body(scene, shape, 1, {0.8, 0.2});
    scene.bodies.velocity(b) << speed, 0, 0;
    return scene;
}

/// Steps until the body has gone 50 m, or half as long again as it should take.
template <class Method>
Vec<3> slide(RigidScene& scene, Method& method, Real speed)
{
    StepData<3> now;
    const Index b = scene.bodies.count() - 1;
    const long most = std::lround(1.5 * 60 * 50 / speed);
    for (long i = 0; i < most && scene.bodies.x[3 * b] < 50.8; ++i) step(scene, {.h = 1.0 / 60}, method, now);
    return scene.bodies.velocity(b);
}

ManifoldExact exact()
{
    ManifoldExact method;
    method.correction = exact_correction();
    return method;
}

}  // namespace

TEST_CASE("a box and a disc slide over a hundred joints of a chain and keep their velocity", "[idea]")
{
    for (const Polygon& shape : {box(0.5, 0.4), disc(0.2)})
        for (const Real speed : {1.0, 5.0, 20.0}) {
            RigidScene scene = sliding(Floor::chain, shape, speed, 0, {0, -9.81});
            ManifoldExact method = exact();
            const Vec<3> u = slide(scene, method, speed);
            CHECK(scene.bodies.x[scene.bodies.x.size() - 3] >= 50);
            // No push has a part along the floor but by rounding, 1e-16 of 20 m/s at each of a hundred joints.
            CHECK(std::abs(u[0] - speed) <= 1e-12);
            CHECK(std::abs(u[1]) <= 1e-12);
            // the row of two corners is repaired to 1e-12 m in a step of 1/60 s
            CHECK(std::abs(u[2]) <= 1e-9);

            RigidScene swept = sliding(Floor::chain, shape, speed, 0, {0, -9.81});
            ManifoldSweeps sweeps;
            CHECK(std::abs(slide(swept, sweeps, speed)[0] - speed) <= 1e-12);
        }
}

TEST_CASE("the same floor of boxes takes most of a velocity at its joints", "[idea]")
{
    // What the chain is for. A box of 1 m/s stops at the first joint it comes to; a disc loses some at each.
    ManifoldExact method = exact(), other = exact();
    RigidScene slow = sliding(Floor::boxes, box(0.5, 0.4), 1, 0, {0, -9.81});
    CHECK(std::abs(slide(slow, method, 1)[0]) <= 1e-9);
    RigidScene round = sliding(Floor::boxes, disc(0.2), 5, 0, {0, -9.81});
    CHECK(slide(round, other, 5)[0] <= 0.3 * 5);
}

TEST_CASE(
    "over a chain that bends down a body flies on and over one that bends up each joint takes its cosine",
    "[idea]")
{
    for (const Polygon& shape : {box(0.5, 0.4), disc(0.2)}) {
        ManifoldExact method = exact();
        RigidScene scene = sliding(Floor::chain, shape, 5, -0.005, {0, 0});
        const Vec<3> u = slide(scene, method, 5);
        CHECK((u - Vec<3>(5, 0, 0)).norm() <= 1e-12);  // nothing touches it: rounding
    }
    // A disc that comes to a joint keeps what of its velocity lies along the next edge: (cos δ) of it.
    const Real bend = 0.005;
    ManifoldExact method = exact();
    RigidScene scene = sliding(Floor::chain, disc(0.2), 5, bend, {0, 0});
    const Vec<3> u = slide(scene, method, 5);
    const Vec2 at = scene.bodies.position(scene.bodies.count() - 1).head<2>();
    // The edge i begins at half a metre times i along the floor: count the edges behind it by their angles.
    const Real joints = std::round(std::log(u.head<2>().norm() / 5) / std::log(std::cos(bend)));
    CHECK(std::abs(u.head<2>().norm() - 5 * std::pow(std::cos(bend), joints)) <= 1e-10);
    const Real angle = std::atan2(u[1], u[0]);  // of the edge that it is on, or just left
    CHECK(std::abs(joints - std::round(angle / bend) + 1) <= 1);
    CHECK(at.x() > 45);
}

TEST_CASE("a chain holds what comes from outside however fast and lets through what comes from inside",
          "[idea]")
{
    for (const Real speed : {2.0, 30.0, 300.0})
        for (const Real side : {1.0, -1.0}) {
            RigidScene scene;
            scene.gravity = {0, 0};
            scene.length = 1;
            add_chain(scene, {{3, 0}, {1, 0.3}, {0, 0}, {-1, 0.3}, {-3, 0}});
            for (const Polygon& shape : {disc(0.1), box(0.3, 0.2), capsule(0.3, 0.02)}) {
                const Real x = 2 * (static_cast<Real>(scene.bodies.count()) - 5);
                const Index b = add_body(scene, shape, 1, {x / 2 - 1.1, 2 * side}, x);
                scene.bodies.velocity(b) << 0, -side * speed, 0;
            }
            ManifoldExact method = exact();
            StepData<3> now;
            const long steps = 60 + std::lround(60 * 4 / speed);
            for (long i = 0; i < steps; ++i) {
                step(scene, {.h = 1.0 / 60}, method, now);
                // it slides along the slopes, and may leave over an end
                for (Index b = 4; side > 0 && b < scene.bodies.count(); ++b)
                    CHECK((scene.bodies.x[3 * b + 1] > 0 || std::abs(scene.bodies.x[3 * b]) > 3));
            }
            for (Index b = 4; side < 0 && b < scene.bodies.count(); ++b)
                CHECK(scene.bodies.x[3 * b + 1] > 1.5);
        }
}

TEST_CASE("a box lies on the corner of a chain and over its valleys", "[idea]")
{
    // Bumps of 10 cm: a box of 1 m rests on two or three tops, and no edge pushes it to the side.
    RigidScene scene;
    std::vector<Vec2> points;
    for (int i = 20; i >= -20; --i) points.push_back({0.2 * i, i % 2 == 0 ? 0.0 : 0.1});
    add_chain(scene, points);
    const Index b = add_body(scene, box(1, 0.4), 1, {0.03, 0.31});
    ManifoldExact method = exact();
    StepData<3> now;
    for (int i = 0; i < 300; ++i) step(scene, {.h = 1.0 / 60}, method, now);
    // It fell by 1 cm; the tops are in one line to the last digit.
    CHECK(std::abs(scene.bodies.x[3 * b] - 0.03) <= 1e-9);
    CHECK(std::abs(scene.bodies.x[3 * b + 1] - 0.3) <= 1e-9);
    CHECK(std::abs(scene.bodies.x[3 * b + 2]) <= 1e-9);
}

TEST_CASE("a chain that makes no sense is refused with a sentence", "[house]")
{
    RigidScene scene;
    CHECK(sentence_of([&] { add_chain(scene, {{0, 0}}); }) == "the chain has 1 points; it needs two or more");
    CHECK(sentence_of([&] {
              add_chain(scene, {{0, 0}, {1, 0}, {1, 0}});
          }) == "edge 1 of the chain goes from (1, 0) to (1, 0); both must be finite, and they must differ");
    CHECK(sentence_of([&] {
              add_chain(scene, {{0, 0}, {1, 0}, {1e80, 0}});
          }).find("1e75") != std::string::npos);
    CHECK(scene.bodies.count() == 0);  // what is refused leaves nothing behind
    CHECK(scene.chains.empty());
    const auto stepped = [](const Chain& chain, bool moves) {
        RigidScene other;
        add_chain(other, {{1, 0}, {0, 0}});
        add_body(other, box(1, 1), 1, {0, 3});
        other.chains[0] = chain;
        if (moves) other.bodies.inverse_mass.head<3>().setOnes();
        return sentence_of([&] {
            ManifoldExact method;
            StepData<3> now;
            step(other, {}, method, now);
        });
    };
    CHECK(stepped({0, 7, false}, false) ==
          "chain 0 goes from body 0 to body 7 among 2; they must be there, in this order");
    CHECK(stepped({0, 1, false}, false) ==
          "chain 0 has body 1 in it; its bodies must have two vertices, and no mass");
    CHECK(stepped({0, 0, false}, true) ==
          "chain 0 has body 0 in it; its bodies must have two vertices, and no mass");
    CHECK(stepped({0, 0, false}, false) == "accepted");
}

// ---- bodies that are stopped

TEST_CASE("a body that is stopped gives back what its weight did in the time that it lost", "[idea]")
{
    RigidScene scene;
    scene.length = 1;
    add_body(scene, box(20, 0.01), Mass{}, {0, 0});
    const Index b = add_body(scene, disc(0.05), 1, {0, 3});
    scene.bodies.velocity(b) << 40, -300, 7;
    ManifoldExact method = exact();
    StepData<3> now;
    const Real h = 1.0 / 60, before = energy(scene);
    step(scene, {.h = h}, method, now);
    REQUIRE(method.contacts.fast.impacts == 1);
    const Real part = scene.bodies.x[3 * b] / (40 * h);
    CHECK(part < 0.7);
    // (12.10): the state of symplectic Euler after the time τ h, but for its way, which is straight. Rounding of 300 m/s.
    CHECK(std::abs(scene.bodies.u[3 * b] - 40) <= 1e-12);
    CHECK(std::abs(scene.bodies.u[3 * b + 1] + 300 + part * h * 9.81) <= 1e-12);
    CHECK(scene.bodies.u[3 * b + 2] == 7);
    // m g² h² τ (1 − τ/2) is lost, of 4.6e4 J known to 1e-16.
    const Real mass = 1 / scene.bodies.inverse_mass[3 * b];
    CHECK(std::abs(energy(scene) - before + mass * std::pow(9.81 * h, 2) * part * (1 - part / 2)) <= 1e-10);
}

TEST_CASE("what is fast meets what comes towards it slowly", "[idea]")
{
    // The face of a box comes from 2 m to 1.6 m in a step: less than half its inner radius. The front of a disc goes from 0.1 m
    // to 1.8 m: where they meet, the box was not when pairs were looked for.
    RigidScene scene;
    scene.length = 1;
    scene.gravity = {0, 0};
    const Index wide = add_body(scene, box(2, 2), 1, {3, 0}), b = add_body(scene, disc(0.1), 1, {0, 0});
    scene.bodies.velocity(wide) << -24, 0, 0;
    scene.bodies.velocity(b) << 102, 0, 0;
    ManifoldExact method = exact();
    StepData<3> now;
    step(scene, {.h = 1.0 / 60}, method, now);
    CHECK(method.contacts.fast.bodies == std::vector<int>{static_cast<int>(b)});
    CHECK(method.contacts.fast.impacts == 1);
    // 1.7 τ + 0.1 = 2 − 0.4 τ, and it stops at a gap of at most half a margin
    CHECK(scene.bodies.x[3 * b] == Approx(1.7 * 1.9 / 2.1).margin(0.01));
}

TEST_CASE("what nothing can move goes all of its way however fast and stops what is fast behind it", "[idea]")
{
    // A box that is driven at 60 m/s, 1 m a step, with a light disc at rest in its way, or a faster one behind it.
    for (const Real from : {0.6, -0.5}) {
        RigidScene scene;
        scene.length = 1;
        scene.gravity = {0, 0};
        add_body(scene, box(0.2, 0.2), Mass{}, {0, 0});
        add_body(scene, disc(0.05), 1, {from, 0});
        scene.bodies.u[0] = 60;
        scene.bodies.u[3] = from < 0 ? 120 : 0;
        ManifoldExact method = exact();
        StepData<3> now;
        for (int n = 1; n <= 5; ++n) {
            step(scene, {.h = 1.0 / 60}, method, now);
            CHECK(scene.bodies.x[0] == Approx(n).epsilon(1e-14));
            CHECK(scene.bodies.u[0] == 60);
            CHECK(scene.bodies.x[3] <= scene.bodies.x[0] - 0.15);  // behind it
            if (n > 1) continue;
            // the slow disc is passed; the fast one meets it where −0.45 + 2 τ = −0.1 + τ, up to half a margin
            CHECK(method.contacts.fast.impacts == (from < 0));
            CHECK(scene.bodies.x[3] == Approx(from < 0 ? 0.2 : 0.6).margin(0.02));
        }
    }
}

TEST_CASE("slender rods that stop each other in every step gain no energy in any step", "[idea]")
{
    // Ten rods 300 times as long as thick fall into a trough. Errors are left, so that each step obeys (13.14).
    RigidScene scene;
    scene.walls = {{{0, 1}, 0}, {Vec2(1, 1).normalized(), -1}, {Vec2(-1, 1).normalized(), -1}};
    for (int k = 0; k < 10; ++k)
        add_body(scene, box(1, 1.0 / 300), 300, {0.1 * (k % 3 - 1), 1.2 + 1.1 * k}, 0.7 * k);
    ManifoldExact method;
    method.correction.method = Stabilizer::none;
    StepData<3> now;
    int impacts = 0;
    Real gain = 0;
    for (int i = 0; i < 150; ++i) {
        const Real before = energy(scene);
        step(scene, {.h = 1.0 / 60}, method, now);
        gain = std::max(gain, energy(scene) - before);
        impacts += method.contacts.fast.impacts;
    }
    CHECK(impacts > 100);
    // of 540 J that the fall from 5.5 m on the mean is worth; it was 18 J before weights were taken back
    CHECK(gain <= 1e-10);
}
