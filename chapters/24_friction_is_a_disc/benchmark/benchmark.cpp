/// Chapter 24: what friction costs in a box, on a disc, and on a disc solved exactly.
///
///     stack/WAY/N    a step of N boxes at 60 steps a second, 50 sweeps at most
///     heap/WAY/N     a step of N solids in a pit, from a second after they were let go, at 120 steps a second
///                    sweeps    of the last step
///                    residual  of the last step [m/s]
///                    sideways  the farthest that a body has moved across the vertical in all steps [m]

#include "chapters/24_friction_is_a_disc/rough_touching.hpp"
#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"

#include <benchmark/benchmark.h>

using namespace rigid;

namespace {

template <class Method>
Method swept()
{
    Method method;
    method.solver.sweeps = {50, 1e-6};
    return method;
}

RoughCones exact() { return solved_exactly(); }

template <class Method>
void steps(benchmark::State& state, RoughSolids scene, Method method, Real h,
           int before)
{
    StepData<6> now;
    for (int n = 0; n < before; ++n) step(scene, {.h = h}, method, now);
    const VecX start = scene.bodies.x;
    for (auto _ : state) step(scene, {.h = h}, method, now);
    Real sideways = 0;
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Vec3 way = scene.bodies.x.segment<3>(6 * k) - start.segment<3>(6 * k);
        sideways = std::max(sideways, Vec2(way.x(), way.z()).norm());
    }
    state.counters["sweeps"] = static_cast<Real>(now.solution.iterations);
    state.counters["residual"] = now.solution.residual;
    state.counters["sideways"] = sideways;
}

template <auto make>
void stack(benchmark::State& state)
{
    steps(state, box_stack(static_cast<int>(state.range(0)), 0.05, 0.5), make(),
          1.0 / 60, 0);
}

template <auto make>
void heap(benchmark::State& state)
{
    steps(state, mixed_heap(static_cast<int>(state.range(0)), 0.5, 1), make(),
          1.0 / 120, 120);
}

}  // namespace

// 240 steps are four seconds, and the same steps in each row.
BENCHMARK(stack<swept<RoughBoxes>>)->Name("stack/box")->Arg(10)->Iterations(240);
BENCHMARK(stack<swept<RoughCones>>)->Name("stack/disc")->Arg(10)->Iterations(240);
BENCHMARK(stack<exact>)->Name("stack/exact")->Arg(10)->Iterations(240);
BENCHMARK(heap<swept<RoughBoxes>>)->Name("heap/box")->Arg(30)->Iterations(240);
BENCHMARK(heap<swept<RoughCones>>)->Name("heap/disc")->Arg(30)->Iterations(240);
BENCHMARK(heap<exact>)->Name("heap/exact")->Arg(30)->Iterations(240);

BENCHMARK_MAIN();
