//! [space]
// A box of 100 kg falls on ten of half a kilogram, in space.
#include "chapters/25_world_in_space/space_method.hpp"

#include <cmath>
#include <cstdio>
#include <exception>

int main()
try {
    using namespace rigid;
    SpaceScene scene;  // metres, kilograms, seconds; y is up
    scene.walls = {{{0, 1, 0}, 0}};
    for (int i = 0; i < 10; ++i)  // 1 kg/m³; last, where its middle is
        add_body(scene, {solid_box({1, 0.5, 1})}, 1, {0, 0.25 + 0.5 * i, 0});
    add_body(scene, {solid_box({1, 1, 1})}, 100, {0, 7, 0});
    scene.friction.assign(11, 0.5);  // of each body
    scene.wall_friction = {0.5};

    // discs of friction; islands of up to so many rows are solved exactly
    TouchingCones method = exact_cones(1000);
    StepData<6> now;  // what the step finds on its way
    for (int n = 1; n <= 120; ++n) {
        step(scene, {.h = 1.0 / 60}, method, now);
        if (n % 30 == 0)
            std::printf("%.1f s: top at %.3f m, %zu contacts\n", n / 60.0,
                        scene.bodies.x[6 * 9 + 1], now.contacts.size());
    }
    return std::abs(scene.bodies.x[6 * 9 + 1] - 4.75) < 0.01 ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
//! [space]
