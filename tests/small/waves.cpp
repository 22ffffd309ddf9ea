/// The small program of chapter 29, masses and water of neighbours, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/29_waves/floating.hpp"
#include "chapters/29_waves/wave_line.hpp"
#include "tests/catch.hpp"
#include "tests/small/sentences.hpp"

#define main small_main
namespace small29 {
#include "chapters/29_waves/small.cpp"
}
#undef main

using namespace rigid;

TEST_CASE("the small program of chapter 29 moves a string as the library does to the bit")
{
    for (const Real h : {1.0, 0.7}) {
        WaveLine line(4, 4, 1);
        line.y[2] = 1;
        small29::String string = small29::at_rest(line.y, h);
        start_leapfrog(line, h);
        for (int n = 0; n < 50; ++n) {
            REQUIRE(string.y == line.y);
            REQUIRE(string.v == line.v);
            small29::leapfrog(string, h);
            leapfrog(line, h);
        }
    }
    small29::String string = small29::at_rest(small29::Vec{{0, 0, 1, 0, 0}}, 1.2);
    const Real printed[] = {0.720, -1.267, 2.499, -7.405};  // section 29.1
    for (const Real place : printed) {
        small29::leapfrog(string, 1.2);
        CHECK(string.y[1] == Approx(place).margin(5e-4));
    }
}

TEST_CASE("the small program of chapter 29 moves water and boxes as the library does to 1e-8")
{
    std::vector<small29::Body> boxes{small29::box(3.01, 0.9, 0.5), small29::box(5.51, 0.5, 0.5)};
    small29::Water small = small29::pond(80, boxes);
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
        small29::step(small, boxes, 0.005);
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

namespace {

// What the sentences of these chapters say.

Numbers three_masses(Numbers in)
{
    small29::String masses = small29::at_rest(Eigen::VectorXd{{0, 0, 1, 0, 0}}, in["h"]);
    double farthest = 1;
    for (int n = 0; n < 40; ++n) {
        small29::leapfrog(masses, in["h"]);
        farthest = std::max(farthest, masses.y.cwiseAbs().maxCoeff());
    }
    return {{"farthest", farthest}};
}

const Sentence says_three_masses("three_masses", three_masses, 1e-12);

}  // namespace
