/// Chapter 10: skipping what a scene doesn't need.

#include "chapters/10_skipping_work/program/skipping_scenes.hpp"
#include "chapters/10_skipping_work/program/skipping_setup.hpp"

using namespace rigid;

namespace {

Demo rain_scene()
{
    return skipping_demo(
        "rain",
        "Discs rain on hills, come to rest and sleep; pull one to wake its island",
        {{0, 1.2}, {18.2, 5}}, 1.0 / 120, 40,
        tunables::count("discs", "how many", 2000, 1, 20000),
        [](const Settings& settings) {
            const auto count = static_cast<Index>(settings["discs"]);
            return skipping(rain_on_hills(count, settings.seed), {}, 0.03,
                            settings["skin"]);
        });
}

Demo field_scene()
{
    return skipping_demo(
        "field",
        "A pendulum above discs at rest: it costs the same above ten thousand",
        {{0, 2.6}, {4.5, 3}}, 1.0 / 60, 30,
        tunables::count("sleepers", "discs on the floor", 1000, 0, 100000),
        [](const Settings& settings) {
            const DiscScene discs = field(static_cast<Index>(settings["sleepers"]));
            return skipping(discs,
                            filter_of_links(discs.bodies.count(), discs.links),
                            0.02, settings["skin"]);
        });
}

/// Body 0, the ball, is let go after a time: it gets its mass and 5 m/s.
void let_go(const Settings& settings, const Input&, SkippingState& state)
{
    if (state.steps != static_cast<int>(std::ceil(settings["wait"] / settings.h)))
        return;
    edit(state, [](SkippingWorld& now) {
        change_disc(now, 0, now.scene.bodies.position(0), {5, 0},
                    1 / (100 * pi * 0.09));
    });
}

Demo columns_scene()
{
    return skipping_demo(
        "columns",
        "Columns asleep; a ball wakes those that it meets, one after the other",
        {{0, 1.7}, {4.2, 2}}, 1.0 / 120, 50,
        tunables::at_start("wait", "s", "before the ball is let go", 2, 0, 10),
        [](const Settings&) {
            SkippingSetup setup = skipping(columns_and_ball(8, 5), {}, 0.02, 0.01);
            setup.before = let_go;
            return setup;
        });
}

Demo net_scene()
{
    return skipping_demo(
        "net",
        "A net of linked discs that never collide with each other: no pair is "
        "tested",
        {{0, -1.7}, {2.6, 2.2}}, 1.0 / 240, 30,
        tunables::count("side", "discs along each side", 30, 2, 100),
        [](const Settings& settings) {
            const DiscScene discs = net(static_cast<Index>(settings["side"]));
            return skipping(discs, net_filter(discs), 0.02, settings["skin"]);
        });
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "10_skipping_work";
        program.title = "Chapter 10. Skipping work";
        program.scenes = {rain_scene(), columns_scene(), field_scene(),
                          net_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
