//! [lift]
// A lift that is open from below, a crate on it, a stool of three shapes, and a
// feather that falls through thick air: what bodies are told while the world runs.
#include "chapters/19_engine/world.hpp"

#include <cstdio>
#include <exception>

int main()
try {
    using namespace rigid;
    World world;
    world.add_wall({{0, 1}, 0});
    const BodyId lift =
        world.add_body({.shape = box(3, 0.2), .position = {0, 0.5}, .density = 0});
    const BodyId crate =
        world.add_body({.position = {0, 1.1}, .fixed_rotation = true});
    const BodyId feather = world.add_body({.shape = disc(0.1),
                                           .position = {1, 9},
                                           .gravity_scale = 0.5,
                                           .linear_damping = 4});
    const BodyId ball = world.add_body(
        {.shape = disc(0.1), .position = {-1, 0.2}, .velocity = {0, 12}});
    const ShapeDefinition left = {.shape = shifted(box(0.2, 0.8), {-0.4, -0.5})},
                          right = {.shape = shifted(box(0.2, 0.8), {0.4, -0.5})};
    const BodyId stool = world.add_body({.shape = box(1, 0.2), .position = {5, 1}},
                                        std::vector{left, right});

    // asked in each step: does this touch count in it?
    world.set_pre_solve(
        [&](const Touch& touch, std::span<const ContactView> points) {
            const bool up = touch.a == lift ? points[0].normal.y() > 0.9 : true;
            return touch.a != lift || (up && points[0].gap > -0.02);
        });
    for (int n = 1; n <= 120; ++n) {
        // where it is to be after the step
        world.set_target(lift, {0, 0.5 + n / 120.0}, 0, 1.0 / 60);
        if (n == 60) world.set_force(crate, {0.5, 0});  // lasts
        world.step(1.0 / 60);
    }
    world.prepare_questions();  // from here on several threads may ask
    const std::size_t met = world.ray_all({0, 9}, {0, -9}).size();
    std::vector<ContactView> points;
    world.contacts(crate, points);
    std::printf("lift at %.3f m, crate %.3f m above it, on %zu points\n",
                world.position(lift).y(),
                world.position(crate).y() - world.position(lift).y(),
                points.size());
    std::printf("the feather falls at %.3f m/s, the ball is at %.1f m\n",
                -world.velocity(feather).y(), world.position(ball).y());
    std::printf("the stool stands on its %zu legs, its centroid at %.3f m\n",
                world.shapes(stool).size() - 1, world.position(stool).y());
    std::printf("a ray from above meets %zu things\n", met);
    world.set_enabled(lift, false);  // and the crate falls
    for (int n = 0; n < 60; ++n) world.step(1.0 / 60);
    std::printf("without it the crate is at %.3f m\n", world.position(crate).y());
    return met == 3 && world.position(crate).y() < 0.51 ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
//! [lift]
