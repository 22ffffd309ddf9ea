/// Chapter 23: what it costs to find where two solids touch.
///
///     faces, edges, apart    the touch of two boxes: face on face, edge across edge, nearer than the margin
///     stack/N                a step of N boxes at 60 steps a second, 50 sweeps at most; points of the last step

#include "chapters/23_faces_that_touch/smooth_touching.hpp"
#include "common/elementary.hpp"

#include <benchmark/benchmark.h>

using namespace rigid;

namespace {

/// The touch of a cube with another one.
void touch_of(benchmark::State& state, const Vec3& theta_a, const Vec3& at,
              const Vec3& theta_b)
{
    const SolidForm cube = form_of(solid_box({1, 1, 1}));
    PlacedSolid a, b;
    a.place(cube, {0, 0, 0}, rotation_matrix(theta_a));
    b.place(cube, at, rotation_matrix(theta_b));
    ClipRoom room;
    SolidTouch touch;
    for (auto _ : state) {
        collide(a, b, {0.02, 2e-4}, room, touch);
        benchmark::DoNotOptimize(touch.count);
    }
    state.counters["points"] = static_cast<Real>(touch.count);
}

void faces(benchmark::State& state)
{
    touch_of(state, {0, 0, 0}, {0.1, 1, 0.05}, {0, 0.3, 0});
}

void edges(benchmark::State& state)
{
    touch_of(state, {0, 0, pi / 4}, {0, std::sqrt(2.0), 0}, {pi / 4, 0, 0});
}

void apart(benchmark::State& state)
{
    touch_of(state, {0, 0, 0}, {1.01, 1.01, 0.05}, {0, 0, 0});
}

void stack(benchmark::State& state)
{
    WalledSolids scene;
    for (int i = 0; i < state.range(0); ++i)
        add_body(scene, {solid_box({1, 1, 1})}, 1000.0, {0, i + 0.5, 0},
                 {0, 0.05 * i, 0});
    scene.walls = {{{0, 1, 0}, 0}};
    SmoothSweeps method;
    method.solver.sweeps = {50, 1e-6};
    StepData<6> now;
    for (auto _ : state) step(scene, {.h = 1.0 / 60}, method, now);
    state.counters["points"] = static_cast<Real>(now.contacts.size());
}

}  // namespace

BENCHMARK(faces);
BENCHMARK(edges);
BENCHMARK(apart);
BENCHMARK(stack)->Arg(1)->Arg(10)->Arg(30);

BENCHMARK_MAIN();
