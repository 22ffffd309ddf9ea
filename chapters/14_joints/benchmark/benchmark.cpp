/// Chapter 14: sweeps over the rows of joints, one by one and a joint at a time.
///
///     sweeps/SCENE/WAY   from rest under gravity to a natural residual of 10⁻⁶ m/s, WAY rows or joints: how many sweeps,
///                        and the time of one [µs]

#include "chapters/06_sequential_impulse/sequential_impulse.hpp"
#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/14_joints/joint_sweeps.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

using namespace rigid;

namespace {

/// Boxes welded one to the next and to the world.
JointedScene cantilever(int boxes)
{
    JointedScene scene;
    for (int k = 0; k < boxes; ++k) {
        const Vec2 at(k, 0);
        add_body(scene, box(1, 0.2), 5.0, at + Vec2(0.5, 0));
        add_joint(scene, joint_at(scene, JointKind::weld, k - 1, k, at));
    }
    return scene;
}

void sweeps(benchmark::State& state, const JointedScene& scene, bool joints)
{
    std::vector<Row<3>> rows;
    for (const PointJoint& joint : scene.joints)
        rows.push_back(bilateral(joint_constraint(scene.bodies.x, joint),
                                 scene.bodies.inverse_mass));
    VecX u_star = scene.bodies.u;
    for (Index k = 0; k < scene.bodies.count(); ++k)
        if (scene.bodies.can_move(k))
            u_star.segment<2>(3 * k) += scene.gravity / 60;
    const ImpulseSettings settings{.max_sweeps = 200000, .tolerance = 1e-6};
    for (auto _ : state) {
        ImpulseMemory<3> memory;
        std::vector<RowRun> runs;
        Solution solution;
        VecX u = u_star;
        const auto start = std::chrono::steady_clock::now();
        if (joints) joint_sweeps(rows, settings, memory, runs, u, solution);
        else sequential_impulse<3>(rows, {}, settings, memory, u, solution);
        const std::chrono::duration<Real> took =
            std::chrono::steady_clock::now() - start;
        state.counters["rows"] = static_cast<Real>(rows.size());
        state.counters["sweeps"] = static_cast<Real>(solution.iterations);
        state.counters["us"] =
            1e6 * took.count() / static_cast<Real>(solution.iterations);
    }
}

const bool registered = [] {
    const std::vector<std::pair<std::string, JointedScene>> scenes = {
        {"chain_10", chain_scene({10, 0.1, 0.1, 1, 0.3})},
        {"chain_40", chain_scene({40, 0.1, 0.1, 1, 0.3})},
        {"chain_10_under_100", chain_scene({10, 0.1, 0.1, 100, 0.3})},
        {"bridge_20", bridge_scene(20)},
        {"bridge_40", bridge_scene(40)},
        {"cantilever_5", cantilever(5)},
        {"cantilever_10", cantilever(10)}};
    for (const auto& [name, scene] : scenes)
        for (const bool joints : {false, true})
            benchmark::RegisterBenchmark(
                ("sweeps/" + name + (joints ? "/joints" : "/rows")).c_str(),
                [all = scene, joints](benchmark::State& state) {
                    sweeps(state, all, joints);
                })
                ->Iterations(1);
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
