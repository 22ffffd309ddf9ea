/// Chapter 21: what joints in space cost.
///
///     rows/N        the rows of N rods on ball joints and constant-velocity joints, where the bodies are
///     WAY/N         a step of them at 240 steps a second, all rows at once or swept island by island; visits of a step

#include "chapters/21_joints_in_space/hung_scenes.hpp"
#include "chapters/21_joints_in_space/joint_methods.hpp"

#include <benchmark/benchmark.h>

using namespace rigid;

namespace {

void rows(benchmark::State& state)
{
    JointedSolids scene = rod_chain(static_cast<int>(state.range(0)));
    StepData<6> now;
    AllSolids::list_joints(
        scene, [](Index) { return true; }, now);
    for (auto _ : state) {
        evaluate_constraints(scene, now);
        benchmark::DoNotOptimize(now.constraints.data());
    }
    state.counters["rows"] = static_cast<Real>(now.sources.size());
}

template <class Method>
void steps(benchmark::State& state)
{
    JointedSolids scene = rod_chain(static_cast<int>(state.range(0)));
    Method method;
    StepData<6> now;
    std::int64_t visits = 0, count = 0;
    for (auto _ : state) {
        step(scene, {.h = 1.0 / 240}, method, now);
        visits += now.visits, ++count;
    }
    state.counters["visits"] = static_cast<Real>(visits) / static_cast<Real>(count);
}

}  // namespace

BENCHMARK(rows)->RangeMultiplier(4)->Range(4, 64);
BENCHMARK_TEMPLATE(steps, SpaceExact)
    ->Name("exact")
    ->RangeMultiplier(4)
    ->Range(4, 64);
BENCHMARK_TEMPLATE(steps, SpaceIslands)
    ->Name("islands")
    ->RangeMultiplier(4)
    ->Range(4, 64);

BENCHMARK_MAIN();
