/// Chapter 19: what moves and what is carried: weak gravity, sub-steps, platforms, thin bodies, scaled worlds, far rays.

#include "chapters/19_engine/world.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"

#include <array>
#include <cmath>

using namespace rigid;

namespace {

constexpr Real moving_frame = 1.0 / 60;  // [s]

/// A rod of 2 m that stands on its end and leans by `lean` from upright.
BodyDefinition leaning_rod(Real lean, Real radius)
{
    BodyDefinition rod;
    rod.shape = capsule(2, radius);
    rod.position = {std::sin(lean), std::cos(lean) + radius};
    rod.angle = pi / 2 - lean;
    rod.mass = thin_rod(2, 1);
    rod.surface = {5, 0, 0, 0};
    return rod;
}

/// The time until it lies, if its end does not slide: ∫ dφ / √(3g/L (cos φ₀ − cos φ)), with φ = φ₀ + s².
Real falling_time(Real lean)
{
    constexpr int parts = 20000;
    const Real end = std::sqrt(pi / 2 - lean), ds = end / parts;
    Real time = 0;
    for (int i = 0; i < parts; ++i) {
        const Real s = (i + 0.5) * ds, phi = lean + s * s;
        time += 2 * s * ds / std::sqrt(1.5 * 9.81 * (std::cos(lean) - std::cos(phi)));
    }
    return time;
}

/// Energy of a body of this mass and inertia [J].
Real energy_of_rod(const World& engine, BodyId body)
{
    return engine.mass(body) * (engine.velocity(body).squaredNorm() / 2 + 9.81 * engine.position(body).y()) +
           engine.inertia(body) * engine.spin(body) * engine.spin(body) / 2;
}

enum class MovingGround { wall, slab, chain };

BodyId add_moving_ground(World& engine, MovingGround ground)
{
    const Surface rough{5, 0, 0, 0};
    if (ground == MovingGround::wall) return engine.add_wall({{0, 1}, 0}, rough), BodyId{};
    if (ground == MovingGround::chain) {
        std::vector<Vec2> points;
        for (int i = 0; i <= 20; ++i) points.push_back({10.0 - i, 0});
        return engine.add_chain(points, false, rough);
    }
    return engine.add_body({.shape = box(20, 1), .position = {0, -0.5}, .density = 0, .surface = rough});
}

}  // namespace

TEST_CASE("a ball at the top of its flight does not sleep however weak gravity is", "[idea]")
{
    // thrown up so that it is at its apex, half a length of the scene up or 20 s away, and back at 2T
    for (const Real length : {1.0, 10.0})
        for (const int substeps : {1, 4})
            for (const Real g : {0.02, 2e-3, 2e-4, 2e-5}) {
                const Real T = std::min(20.0, std::sqrt(1 / g));
                World engine({.gravity = {0, -g * length}, .length = length, .substeps = substeps});
                const BodyId ball =
                    engine.add_body({.shape = disc(0.5 * length), .velocity = {0, g * length * T}});
                const auto steps = static_cast<int>(2 * T / moving_frame);
                for (int i = 0; i < steps; ++i) {
                    engine.step(moving_frame);
                    REQUIRE(engine.is_awake(ball));
                }
                // symplectic Euler, (1.13): −g t h/2 beside the parabola
                const Real t = engine.time(), part = moving_frame / substeps;
                CHECK(engine.position(ball).y() ==
                      Approx(length * (g * T * t - g * t * (t + part) / 2)).margin(1e-9 * length));
            }
}

TEST_CASE("what stands in weak gravity sleeps", "[idea]")
{
    for (const Real g : {0.02, 2e-3, 2e-4}) {
        World engine({.gravity = {0, -g}, .substeps = 4});
        engine.add_wall({{0, 1}, 0});
        std::vector<BodyId> boxes;
        for (int i = 0; i < 6; ++i) boxes.push_back(engine.add_body({.position = {0, 0.5 + i}}));
        for (int i = 0; i < 60; ++i) engine.step(moving_frame);
        for (const BodyId box : boxes) CHECK_FALSE(engine.is_awake(box));
    }
}

TEST_CASE("a stack sleeps by sweeps alone whatever the number of sub-steps", "[idea]")
{
    for (const Real aside : {0.0, 0.02})
        for (const int substeps : {1, 2, 4, 8}) {
            World engine({.substeps = substeps, .solving = Solving::sweeps});
            engine.add_wall({{0, 1}, 0});
            std::vector<BodyId> boxes;
            for (int i = 0; i < 6; ++i)
                boxes.push_back(engine.add_body(
                    {.position = {aside * ((i * 7) % 5 - 2), 0.5 + i + 2.5 * aside * (i + 1)}}));
            const auto awake = [&] {
                return std::any_of(boxes.begin(), boxes.end(),
                                   [&](BodyId box) { return engine.is_awake(box); });
            };
            int steps = 0;
            for (; steps < 600 && awake(); ++steps) engine.step(moving_frame);
            INFO(substeps << " sub-steps, " << aside << " m aside");
            CHECK(steps < 600);
        }
}

TEST_CASE("a block does not slip on a platform that accelerates whatever the number of sub-steps", "[idea]")
{
    // a < μ g = 5.9 m/s²; up to 5 m/s, at that speed, down to rest, at rest, and again
    const Surface rough{0.6, 0, 0, 0};
    for (const Real a : {5.0, -5.0})
        for (const int substeps : {1, 2, 4, 8, 16}) {
            World engine({.substeps = substeps});
            const BodyId platform = engine.add_body(
                {.shape = box(100, 1), .position = {0, -0.5}, .density = 0, .surface = rough});
            const BodyId block = engine.add_body({.position = {0, 0.5}, .surface = rough});
            engine.step(moving_frame);  // what is new has its velocity at once
            Real most = 0, way = 0;
            for (int i = 0; i < 600; ++i) {
                const int n = i % 240;
                const Real v = a * moving_frame * (n < 60 ? n + 1 : n < 120 ? 60 : n < 180 ? 179 - n : 0);
                const Real before = engine.velocity(platform).x();
                engine.set_velocity(platform, {v, 0}, 0);
                engine.step(moving_frame);
                CHECK(engine.velocity(platform).x() == v);
                way += moving_frame * (before + (v - before) * (substeps + 1) / (2 * substeps));
                most = std::max(most, std::abs(engine.position(block).x() - engine.position(platform).x()));
            }
            INFO(substeps << " sub-steps");
            CHECK(engine.position(platform).x() == Approx(way).margin(1e-9));
            CHECK(most < 1e-8);
        }
}

TEST_CASE("a platform that is driven goes on as it would after it is loaded and whichever place it has",
          "[idea]")
{
    const auto made = [](bool used_before) {
        World engine({.substeps = 4});
        if (used_before) {
            const BodyId old = engine.add_body({.position = {0, -0.5}, .velocity = {3, 0}, .density = 0});
            engine.step(moving_frame);
            engine.remove(old);
        } else engine.step(moving_frame);
        engine.add_body({.shape = box(100, 1), .position = {0, -0.5}, .density = 0});
        engine.add_body({.position = {0, 0.5}});
        return engine;
    };
    World engine = made(false), again = made(true);
    for (int i = 0; i < 60; ++i) {
        for (World* it : {&engine, &again}) it->set_velocity(it->bodies().front(), {2 - 0.03 * i, 0}, 0);
        World loaded = World::load(engine.save());
        for (World* it : {&engine, &again, &loaded}) it->step(moving_frame);
        REQUIRE(loaded.hash() == engine.hash());
        REQUIRE(again.hash() == engine.hash());
    }
}

TEST_CASE("a thin rod that topples over its foot lies when the pendulum's integral says", "[idea]")
{
    const Real lean = pi / 2 - 1.4, right = falling_time(lean);
    CHECK(right == Approx(1.10).margin(0.01));
    for (const MovingGround ground : {MovingGround::wall, MovingGround::slab, MovingGround::chain})
        for (const int substeps : {1, 4})
            for (const Real radius : {1e-4, 1e-3, 1e-2}) {
                World engine({.substeps = substeps});
                add_moving_ground(engine, ground);
                const BodyId rod = engine.add_body(leaning_rod(lean, radius));
                const Real full = energy_of_rod(engine, rod);
                Real lies = 0, deep = 0, most = 0;
                for (int i = 1; i <= 120; ++i) {
                    engine.step(moving_frame);
                    const Real tip = engine.point_of(rod, {1, 0}).y() - radius;
                    if (lies == 0 && tip < 0.01) lies = i * moving_frame;
                    deep = std::max(deep, -tip);
                    most = std::max(most, energy_of_rod(engine, rod) - full);
                }
                INFO("ground " << static_cast<int>(ground) << ", radius " << radius << ", " << substeps);
                // a step at each end
                CHECK(lies == Approx(right).margin(2 * moving_frame));
                // the slop, and what a step on a line takes the end too deep: L (ωh)²/4 of the sub-step
                CHECK(deep < 0.006);
                CHECK(most < 0.01);
            }
}

TEST_CASE("a rod without a radius stays on a wall a slab and a chain", "[idea]")
{
    for (const MovingGround ground : {MovingGround::wall, MovingGround::slab, MovingGround::chain})
        for (const int substeps : {1, 4})
            for (const Real angle : {0.0, 0.3, 1.4}) {
                World engine({.substeps = substeps});
                add_moving_ground(engine, ground);
                BodyDefinition line = leaning_rod(pi / 2 - angle, 0);
                line.position.y() += 1;
                const BodyId rod = engine.add_body(line);
                for (int i = 0; i < 300; ++i) engine.step(moving_frame);
                INFO("ground " << static_cast<int>(ground) << ", angle " << angle << ", " << substeps);
                CHECK(std::abs(engine.position(rod).y()) < 0.01);
            }
}

TEST_CASE("a world a thousand times as large with rolling resistance has the same bits", "[idea]")
{
    const auto made = [](Real L, Solving solving) {
        World engine({.gravity = {0, -9.81 * L}, .length = L, .solving = solving});
        const Surface rolls{0.5, 0, 0, 0.01 * L};
        for (const HalfSpace& wall : {HalfSpace{{0, 1}, 0}, HalfSpace{{1, 0}, -L}, HalfSpace{{-1, 0}, -L}})
            engine.add_wall(wall, rolls);
        for (int i = 0; i < 16; ++i)
            engine.add_body({.shape = disc(0.17 * L),
                             .position = {(-0.6 + 0.4 * (i % 4)) * L, (0.3 + 0.4 * (i / 4)) * L},
                             .velocity = {0.5 * L, 0},
                             .spin = 2,
                             .density = 1 / L / L,
                             .surface = rolls});
        return engine;
    };
    for (const Solving solving : {Solving::by_island, Solving::sweeps, Solving::exact})
        for (const Real size : {1024.0, 1.0 / 1024}) {
            World small = made(1, solving), large = made(size, solving);
            for (int i = 0; i < 300; ++i) {
                small.step(moving_frame), large.step(moving_frame);
                for (const BodyId id : small.bodies()) {
                    REQUIRE(large.position(id) == size * small.position(id));
                    REQUIRE(large.angle(id) == small.angle(id));
                    REQUIRE(large.is_awake(id) == small.is_awake(id));
                }
            }
        }
}

TEST_CASE("a ray meets a disc and a corner from any distance", "[idea]")
{
    World engine({.gravity = {0, 0}});
    const BodyId ball = engine.add_body({.shape = disc(0.5)});
    const BodyId box = engine.add_body({.position = {0, 10}, .angle = 0.25 * pi});
    for (const Real far : {1e1, 1e3, 1e6, 1e8, 1e10, 1e12})
        for (const Real aside : {0.0, 0.3, 0.4999}) {
            const std::optional<Met> met = engine.ray({-far, aside}, {2 * far, 0});
            REQUIRE(met);
            CHECK(met->body == ball);
            const Real x = -std::sqrt(0.25 - aside * aside);
            // the point is one of the ray: its part is rounded
            CHECK(met->point.x() == Approx(x).margin(1e-12 + 1e-15 * far));
            CHECK((met->normal - 2 * Vec2(x, aside)).norm() < 1e-12);
            const std::optional<Met> corner = engine.ray({-far, 10}, {2 * far, 0});
            REQUIRE(corner);
            CHECK(corner->body == box);
        }
}

TEST_CASE("what slides over flush bodies that stand catches on no seam", "[idea]")
{
    // no friction: the velocity stays, to the speed at which a normal is one of the floor's (10⁻³) at each seam
    const auto slides = [](const Polygon& shape, Real height, Real v, int substeps, Real off) {
        World engine({.substeps = substeps});
        for (int i = 0; i < 40; ++i)
            engine.add_body(
                {.position = {i - 2.0, -0.5 - (i % 2) * off}, .density = 0, .surface = {0, 0, 0, 0}});
        const BodyId body = engine.add_body(
            {.shape = shape, .position = {0.3, height}, .velocity = {v, 0}, .surface = {0, 0, 0, 0}});
        const auto steps = static_cast<int>(20 / v / moving_frame);
        Real highest = 0;
        for (int i = 0; i < steps; ++i) {
            engine.step(moving_frame);
            highest = std::max(highest, engine.position(body).y());
        }
        CHECK(highest < height + 0.006);
        return engine.velocity(body).x();
    };
    for (const Real v : {1.0, 4.0, 15.0})
        for (const int substeps : {1, 4}) {
            INFO(v << " m/s, " << substeps << " sub-steps");
            CHECK(slides(box(1, 1), 0.5, v, substeps, 0) == Approx(v).epsilon(1e-3));
            CHECK(slides(disc(0.5), 0.5, v, substeps, 0) == Approx(v).epsilon(1e-3));
            CHECK(slides(capsule(1, 0.2), 0.2, v, substeps, 0) == Approx(v).epsilon(1e-3));
        }
}

TEST_CASE("what is beside a face that is free is stopped by it", "[idea]")
{
    // a box that slides into a wall of a floor, into a step, and a corner that falls into a groove
    for (const Real step_height : {0.01, 0.1, 1.0})
        for (const bool thin : {false, true}) {
            World engine;
            const Real size = thin ? 0.02 : 1;
            for (int i = 0; i < 4; ++i)
                engine.add_body({.position = {i - 2.0, -0.5}, .density = 0, .surface = {0, 0, 0, 0}});
            engine.add_body({.position = {2, step_height - 0.5}, .density = 0, .surface = {0, 0, 0, 0}});
            const BodyId body = engine.add_body({.shape = box(1, size),
                                                 .position = {0, size / 2},
                                                 .velocity = {1, 0},
                                                 .surface = {0, 0, 0, 0}});
            for (int i = 0; i < 180; ++i) engine.step(moving_frame);
            INFO("a step of " << step_height << " m, " << size << " m thick");
            CHECK(engine.position(body).x() < 1.01);
            CHECK(engine.velocity(body).x() < 1e-6);  // a low step tips a box, and it may glide back
        }
    for (const Real turn : {0.2, 0.5, 0.25 * pi, 1.2}) {
        World engine;
        const Real c = std::sqrt(0.5);
        for (const int side : {-1, 1})
            engine.add_body({.shape = box(4, 1),
                             .position = {side * (2 + 0.5) * c, (2 - 0.5) * c},
                             .angle = side * 0.25 * pi,
                             .density = 0});
        const BodyId body =
            engine.add_body({.position = {0, c * std::cos(turn - 0.25 * pi) + 0.3}, .angle = turn});
        for (int i = 0; i < 240; ++i) engine.step(moving_frame);
        CHECK(engine.position(body).y() > 0.49);
    }
    // a triangle whose corner is in the corner between a wall, which nothing hides, and a floor that is free beside it
    World engine;
    engine.add_wall({{1, 0}, 0});
    engine.add_body({.shape = box(4, 1), .position = {2, -0.5}, .density = 0, .surface = {0, 0, 0, 0}});
    const Vec2 foot(-0.4, -0.4);
    const BodyId body = engine.add_body({.shape = {.vertices = {foot, {0.6, -0.1}, {-0.1, 0.6}}},
                                         .position = -foot,
                                         .surface = {0, 0, 0, 0}});
    for (int i = 0; i < 60; ++i) {
        engine.step(moving_frame);
        CHECK(engine.point_of(body, foot).y() > -0.006);  // what may stay is 0.005
    }
}

TEST_CASE("what its row has held loses no time", "[idea]")
{
    // a fast box comes up with another one in the step; they go on as one, each as far as its velocity says
    for (const int substeps : {1, 4}) {
        World engine({.gravity = {0, 0}, .substeps = substeps});
        const BodyId fast =
                         engine.add_body({.position = {0, 0}, .velocity = {40, 0}, .surface = {0, 0, 0, 0}}),
                     slow = engine.add_body(
                         {.position = {1.2, 0}, .velocity = {20, 0}, .surface = {0, 0, 0, 0}});
        engine.step(moving_frame);
        // 40 m/s until the gap of 0.2 m is closed, then 30 m/s
        CHECK(std::abs(engine.velocity(slow).x() + engine.velocity(fast).x() - 60) <= 1e-12);
        CHECK(std::abs(engine.position(slow).x() + engine.position(fast).x() - 1.2 - 60 * moving_frame) <=
              1e-12);
        engine.step(moving_frame);
        CHECK(std::abs(engine.position(slow).x() + engine.position(fast).x() - 1.2 - 120 * moving_frame) <=
              1e-12);
    }
}

TEST_CASE("a jaw of bounded force stalls on boxes that have no room and throws none of them", "[idea]")
{
    // four boxes of 0.9 m in a row, three rows, between a wall and a plate that goes on at 1 m/s while it may
    for (const int substeps : {1, 4}) {
        World engine({.substeps = substeps});
        engine.add_wall({{0, 1}, 0});
        engine.add_wall({{1, 0}, 0});
        const BodyId jaw = engine.add_body({.shape = box(1, 10), .position = {4.5, 5}});
        RigidJoint slide = engine.joint_at(JointKind::prismatic, {}, jaw, {4.5, 5});
        slide.axis = {1, 0};
        slide.motor.speed = -1;
        slide.motor.force = 5000;
        engine.add_joint({}, jaw, slide);
        std::vector<BodyId> boxes;
        for (int i = 0; i < 12; ++i)
            boxes.push_back(
                engine.add_body({.shape = box(0.9, 0.9), .position = {0.5 + (i % 4), 0.5 + (i / 4)}}));
        Real fastest = 0;
        for (int i = 0; i < 300; ++i) {
            engine.step(moving_frame);
            for (const BodyId box : boxes) fastest = std::max(fastest, engine.velocity(box).norm());
        }
        CHECK(fastest < 3);  // they fall by 5 to 25 cm and are pushed together at 1 m/s
        CHECK(engine.position(jaw).x() == Approx(4.1).margin(0.02));
        CHECK(engine.work().unsolved == 0);
    }
}

TEST_CASE("thin rods and boards that fall anyhow gain no energy and go into nothing", "[idea]")
{
    for (const MovingGround ground : {MovingGround::wall, MovingGround::slab, MovingGround::chain})
        for (const bool board : {false, true})
            for (const int substeps : {1, 4}) {
                Random random(7);
                Real gain = 0, deep = 0;
                for (int i = 0; i < 20; ++i) {
                    const Real r = std::pow(10, random.uniform(-4, -2)), angle = random.uniform(-pi, pi);
                    const Real drop = random.uniform(0, 1);
                    World engine({.substeps = substeps});
                    add_moving_ground(engine, ground);
                    BodyDefinition rod = leaning_rod(pi / 2 - angle, r);
                    if (board) rod.shape = box(2, 2 * r);
                    rod.position = {0, std::abs(std::sin(angle)) + r + drop};
                    rod.velocity = {random.uniform(-2, 2), 0};
                    rod.spin = random.uniform(-3, 3);
                    rod.surface.friction = random.uniform(0, 1);
                    const BodyId body = engine.add_body(rod);
                    Real least = energy_of_rod(engine, body);
                    for (int n = 0; n < 150; ++n) {
                        engine.step(moving_frame);
                        const Real now = energy_of_rod(engine, body);
                        gain = std::max(gain, now - least);
                        least = std::min(least, now);
                        for (const Real end : {-1.0, 1.0})
                            deep = std::max(deep, -engine.point_of(body, {end, 0}).y() + (board ? 0 : r));
                    }
                }
                INFO("ground " << static_cast<int>(ground) << ", board " << board << ", " << substeps);
                // of up to 20 J: what an overlap of the slop gives back, m g s/2
                CHECK(gain < 0.025);
                // the slop, and what a blow at one end adds to the way of the other within the step
                CHECK(deep < 0.015);
            }
}
