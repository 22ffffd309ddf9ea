//! [world]
// A pendulum of three links over a pile of boxes: the engine of this book in a
// program of its own.
#include "chapters/19_engine/world.hpp"

#include <cstdio>
#include <exception>

int main()
try {
    using namespace rigid;
    World world;  // metres, kilograms, seconds; y is up
    world.add_wall({{0, 1}, 0});
    std::vector<BodyId> boxes;
    for (int i = 0; i < 6; ++i)
        boxes.push_back(world.add_body(
            {.shape = box(0.5, 0.5), .position = {0, 0.25 + 0.5 * i}}));

    BodyId above;  // the world
    for (int i = 0; i < 3; ++i) {
        const Vec2 pin(-2.5 + 1.0 * i, 4);
        const BodyId link = world.add_body({.shape = capsule(0.9, 0.05),
                                            .position = pin + Vec2(0.5, 0),
                                            .density = i < 2 ? 1.0 : 20.0});
        world.add_joint(above, link,
                        world.joint_at(JointKind::revolute, above, link, pin));
        above = link;
    }
    Real hardest = 0;
    for (int n = 0; n < 600; ++n) {
        world.step(1.0 / 60);
        for (const Hit& hit : world.events().hits)
            hardest = std::max(hardest, hit.speed);
    }
    std::printf("%d of 9 bodies awake, %.1f m/s the hardest hit\n",
                world.work().awake, hardest);
    std::printf("the lowest box is at %.3f m\n", world.position(boxes[0]).y());
    const std::string bytes = world.save();  // and goes on there to the same bits
    return World::load(bytes).hash() == world.hash() && hardest > 1 ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
//! [world]
