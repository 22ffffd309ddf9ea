/// The small program of chapter 28, masses and water of neighbours, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/28_waves/floating.hpp"
#include "chapters/28_waves/wave_line.hpp"
#include "tests/catch.hpp"

#define main small_main
namespace small28 {
#include "chapters/28_waves/small.cpp"
}
#undef main

using namespace rigid;

TEST_CASE("the small program of chapter 28 moves a string as the library does to the bit")
{
    for (const Real h : {1.0, 0.7}) {
        WaveLine line(4, 4, 1);
        line.y[2] = 1;
        small28::String string = small28::at_rest(line.y, h);
        start_leapfrog(line, h);
        for (int n = 0; n < 50; ++n) {
            REQUIRE(string.y == line.y);
            REQUIRE(string.v == line.v);
            small28::leapfrog(string, h);
            leapfrog(line, h);
        }
    }
    small28::String string = small28::at_rest(small28::Vec{{0, 0, 1, 0, 0}}, 1.2);
    const Real printed[] = {0.720, -1.267, 2.499, -7.405};  // section 28.1
    for (const Real place : printed) {
        small28::leapfrog(string, 1.2);
        CHECK(string.y[1] == Approx(place).margin(5e-4));
    }
}

TEST_CASE("the small program of chapter 28 moves water and boxes as the library does to 1e-8")
{
    std::vector<small28::Body> boxes{small28::box(3.01, 0.9, 0.5), small28::box(5.51, 0.5, 0.5)};
    small28::Water small = small28::pond(80, boxes);
    RigidScene scene;
    ShallowWater water(80, 8, 1);
    Floating floating;
    floating.settings = {0.5, 0, 0};
    add_body(scene, box(0.9, 0.5), 500.0, {3.01, 1}, 0.02);
    add_body(scene, box(0.5, 0.5), 500.0, {5.51, 1}, 0.02);
    floating.displace(scene, water);
    water.depth.head(13).array() += 0.3;
    CHECK((small.depth - water.depth).cwiseAbs().maxCoeff() < 1e-14);
    for (int n = 0; n < 200; ++n) {
        small28::step(small, boxes, 0.005);
        floating.find(scene, water);
        floating.push(scene, water, 0.005);
        for (Index k = 0; k < 2; ++k) {
            scene.bodies.velocity(k).head<2>() += 0.005 * scene.gravity;
            scene.bodies.integrate(k, scene.bodies.velocity(k), 0.005);
        }
        carry_water(water, 0.005);
        // levels are solved to 1e-9 m
        REQUIRE((small.depth - water.depth).cwiseAbs().maxCoeff() < 1e-8);
        for (Index k = 0; k < 2; ++k)
            REQUIRE((boxes[std::size_t(k)].x - scene.bodies.position(k)).norm() < 1e-8);
    }
    CHECK(std::abs(boxes[1].x[2]) > 0.03);  // and something happened
}
