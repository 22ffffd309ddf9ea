//! [stack]
// A box of 100 kg falls on ten of half a kilogram, and all come to rest.
#include "chapters/19_engine/world.hpp"

#include <cstdio>

int main()
{
    using namespace rigid;
    World world;  // metres, kilograms, seconds; y is up
    world.add_wall({{0, 1}, 0});
    BodyId top;
    for (int i = 0; i < 10; ++i)
        top =
            world.add_body({.shape = box(1, 0.5), .position = {0, 0.25 + 0.5 * i}});
    world.add_body({.shape = box(1, 1), .position = {0, 7}, .density = 100});
    for (int n = 1; n <= 120; ++n) {
        world.step(1.0 / 60);
        if (n % 30 == 0)
            std::printf("%.1f s: top at %.3f m, %d bodies awake\n", n / 60.0,
                        world.position(top).y(), world.work().awake);
    }
    return world.work().awake;  // 0: the last box sleeps, too
}
//! [stack]
