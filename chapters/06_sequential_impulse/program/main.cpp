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
    Demo scene =
        impulse_scene("triangle", "A triangle of discs between walls: it sinks, and to which side?", 10, 0);
    scene.view = {{0, 0.7}, {1.1, 0.9}};
    scene.tunables.insert(scene.tunables.begin(),
                          {"base", "", "discs in the lowest row", 10, 2, 30, true, true, true});
    scene.start = [view = scene.view](const Settings& settings) {
        const auto base = static_cast<Index>(settings["base"]);
        return std::make_unique<ImpulseRun>(settings, triangle(base), 10 / static_cast<Real>(base), view);
    };
    return scene;
}

Demo column_scene()
{
    Demo scene = impulse_scene("column", "A column of discs, with a heavy one on top if you like", 10, 0);
    scene.view = {{0, 1.05}, {0.9, 1.2}};
    scene.tunables.insert(scene.tunables.begin(),
                          {{"rows", "", "N, discs in the column", 15, 1, 100, true, true, true},
                           {"top_mass", "kg", "mass of the uppermost; the others have 1 kg", 1, 0.01, 1000,
                            false, true, false}});
    scene.start = [view = scene.view](const Settings& settings) {
        const auto N = static_cast<Index>(settings["rows"]);
        return std::make_unique<ImpulseRun>(settings, column(N, settings["top_mass"]),
                                            10 / static_cast<Real>(N), view);
    };
    return scene;
}

Demo chain_scene()
{
    Demo scene =
        impulse_scene("hanging_chain", "A chain with a heavy end: pull it, and see it stretch", 100, 0);
    scene.view = {{0, -1.05}, {1, 1.45}};
    scene.tunables.insert(scene.tunables.begin(),
                          {{"links", "", "N, links of 0.1 m", 20, 1, 60, true, true, true},
                           {"end_mass", "kg", "mass of the lowest disc; the others have 1 kg", 10, 0.01, 1000,
                            false, true, false}});
    scene.start = [view = scene.view](const Settings& settings) {
        const auto N = static_cast<Index>(settings["links"]);
        DiscScene chain = hanging_chain(N, settings["end_mass"]);
        for (Index k = 1; k <= N; ++k)  // a little aside
            chain.bodies.position(k) = 0.1 * static_cast<Real>(k) * Vec2(std::sin(0.2), -std::cos(0.2));
        chain.linked = PairSet::all();
        return std::make_unique<ImpulseRun>(settings, std::move(chain), 20 / static_cast<Real>(N), view);
    };
    return scene;
}

Demo ten_discs_scene()
{
    Demo scene = impulse_scene("ten_discs", "The ten discs, whose links nobody repairs yet", 200, 6);
    set_up_ten_discs(scene);
    scene.start = [view = scene.view](const Settings& settings) {
        return std::make_unique<ImpulseRun>(settings, ten_discs(), 1, view, true);
    };
    return scene;
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "06_sequential_impulse";
        program.title = "Chapter 6. Sequential impulse";
        program.scenes = {groove_scene(), bounce_scene(), cradle_scene(),    lift_scene(),
                          belt_scene(),   rope_scene(),   one_sweep_scene(), triangle_scene(),
                          column_scene(), chain_scene(),  ten_discs_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
