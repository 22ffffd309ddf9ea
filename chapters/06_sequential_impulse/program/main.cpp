/// Chapter 6: sequential impulse.

#include "chapters/06_sequential_impulse/program/scene_belt_and_rope.hpp"
#include "chapters/06_sequential_impulse/program/scene_bounce.hpp"
#include "chapters/06_sequential_impulse/program/scene_cradle.hpp"
#include "chapters/06_sequential_impulse/program/scene_groove.hpp"
#include "chapters/06_sequential_impulse/program/scene_machines.hpp"
#include "chapters/06_sequential_impulse/program/scene_one_sweep.hpp"

using namespace rigid;

namespace {

Demo triangle_scene()
{
    return impulse_demo(
        "triangle",
        "A triangle of discs between walls: it sinks, and to which side?",
        {{0, 0.7}, {1.1, 0.9}}, {tunables::base(2, 30, Keys::up_and_down)}, 10, 0,
        [](const Settings& settings) {
            const auto base = static_cast<Index>(settings["base"]);
            return by_impulses(triangle(base), 10 / static_cast<Real>(base));
        });
}

Demo column_scene()
{
    return impulse_demo("column",
                        "A column of discs, with a heavy one on top if you like",
                        {{0, 1.05}, {0.9, 1.2}},
                        {tunables::in_column("rows", 15, 100, Keys::up_and_down),
                         tunables::top_mass(1)},
                        10, 0, [](const Settings& settings) {
                            const auto N = static_cast<Index>(settings["rows"]);
                            return by_impulses(column(N, settings["top_mass"]),
                                               10 / static_cast<Real>(N));
                        });
}

Demo chain_scene()
{
    return impulse_demo(
        "hanging_chain", "A chain with a heavy end: pull it, and see it stretch",
        {{0, -1.05}, {1, 1.45}},
        {tunables::links(20, 1, 60, Keys::up_and_down), tunables::end_mass(10)},
        100, 0, [](const Settings& settings) {
            const auto N = static_cast<Index>(settings["links"]);
            return by_impulses(leaning_chain(N, settings["end_mass"]),
                               20 / static_cast<Real>(N));
        });
}

Demo ten_discs_scene()
{
    Demo demo = impulse_demo(
        "ten_discs", "The ten discs, whose links are not repaired yet",
        ten_discs_view, ten_discs_tunables(), 200, 6, [](const Settings&) {
            return by_impulses(ten_discs(), 1, Pointer::steers);
        });
    set_up_ten_discs(demo);
    return demo;
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "06_sequential_impulse";
        program.title = "Chapter 6. Sequential impulse";
        program.scenes = {groove_scene(),    bounce_scene(),   cradle_scene(),
                          lift_scene(),      belt_scene(),     rope_scene(),
                          one_sweep_scene(), triangle_scene(), column_scene(),
                          chain_scene(),     ten_discs_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
