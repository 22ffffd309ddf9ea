// Chapter 29. Waves: run time against error for strings, and what a cell costs on membranes, in water and under hulls.
#include "chapters/29_waves/membrane.hpp"
#include "chapters/29_waves/modes.hpp"
#include "chapters/29_waves/spectral.hpp"
#include "chapters/29_waves/water_field.hpp"
#include "chapters/29_waves/water_scenes.hpp"
#include "common/elementary.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace rigid {
namespace {

/// Each line of a CSV has every column.
/// \param us  of the whole, or of a step [µs]
/// \param ns  of a cell, or of a slice
/// \param GB  a second, of memory
void report(benchmark::State& state, Real us, Real error, Real ns, Real GB)
{
    state.counters["us"] = us;
    state.counters["error"] = error;
    state.counters["ns"] = ns;
    state.counters["GB_a_second"] = GB;
}

Real bell(Real x) { return exp(-(x - 0.4) * (x - 0.4) / 0.0036); }

WaveLine plucked(Index intervals)
{
    WaveLine line(intervals, 1, 1);
    for (Index i = 1; i < intervals; ++i)
        line.y[i] = bell(line.dx * static_cast<Real>(i));
    return line;
}

/// Where a plucked string is after 2.5 s, five quarters of a period: half of the bell runs to the right, half to the left,
/// and both come back upside down.
Real exact(Real x)
{
    return (bell(x - 0.5) - bell(0.5 - x) + bell(x + 0.5) - bell(1.5 - x)) / 2;
}

/// Five quarters of a period by one method: the least time of some runs, and the largest error. (After a whole one each
/// mode is at its turning point, where errors of its phase hardly show.)
void measure(benchmark::State& state, Index intervals,
             const std::function<void(WaveLine&)>& period)
{
    Real best = infinity, error = 0;
    for ([[maybe_unused]] const auto& _ : state) {
        WaveLine line = plucked(intervals);
        const auto start = std::chrono::steady_clock::now();
        period(line);
        best = std::min(best, std::chrono::duration<Real>(
                                  std::chrono::steady_clock::now() - start)
                                  .count());
        error = 0;
        for (Index i = 1; i < intervals; ++i)
            error = std::max(
                error, std::abs(line.y[i] - exact(line.dx * static_cast<Real>(i))));
    }
    report(state, best * 1e6, error, 0, 0);
}

void add_strings()
{
    struct Method {
        std::string name;
        Real C, theta;  ///< θ; 0 = leapfrog
    };
    for (const Index n : {64, 128, 256, 512, 1024, 2048}) {
        for (const Method& method : {Method{"leapfrog_half", 0.5, 0},
                                     {"leapfrog_one", 1, 0},
                                     {"trapezoidal_one", 1, 0.5},
                                     {"trapezoidal_four", 4, 0.5},
                                     {"implicit", 1, 1}}) {
            const auto period = [method, n](WaveLine& line) {
                const auto steps = static_cast<int>(
                    std::lround(2.5 * static_cast<Real>(n) / method.C));
                const Real h = 2.5 / steps;
                ThetaMemory memory;
                if (method.theta == 0) start_leapfrog(line, h);
                for (int i = 0; i < steps; ++i) {
                    if (method.theta == 0) leapfrog(line, h);
                    else theta_step(line, h, method.theta, memory);
                }
            };
            benchmark::RegisterBenchmark(
                ("string/" + method.name + "/" + std::to_string(n)).c_str(),
                [n, period](benchmark::State& state) { measure(state, n, period); })
                ->Iterations(3);
        }
        benchmark::RegisterBenchmark(
            ("string/sines/" + std::to_string(n)).c_str(),
            [n](benchmark::State& state) {
                measure(state, n, [](WaveLine& line) {
                    SpectralStep whole(line, 2.5, SpectralStep::Of::equation);
                    whole.step(line);
                });
            })
            ->Iterations(3);
    }
}

/// A step reads places, velocities and dampings and writes velocities, then reads both again and writes places.
void line(benchmark::State& state)
{
    const auto n = static_cast<Index>(state.range(0));
    WaveLine string(n, static_cast<Real>(n), 1);
    for (Index i = 1; i < n; ++i) string.y[i] = sin(0.01 * static_cast<Real>(i));
    start_leapfrog(string, 0.7);
    Real best = infinity;
    for ([[maybe_unused]] const auto& _ : state) {
        const auto start = std::chrono::steady_clock::now();
        leapfrog(string, 0.7);
        best = std::min(best, std::chrono::duration<Real>(
                                  std::chrono::steady_clock::now() - start)
                                  .count());
    }
    const auto masses = static_cast<Real>(n);
    report(state, best * 1e6, 0, best * 1e9 / masses, 56 * masses / best * 1e-9);
}
BENCHMARK(line)->Arg(1000)->Arg(100000)->Arg(1000000)->Iterations(60);

/// ns a cell, and the bytes a second that 32 bytes a cell are.
void membrane(benchmark::State& state)
{
    const auto n = static_cast<Index>(state.range(0));
    Membrane field(n, n, 1, 1, false);
    touch(field, 0.4 * static_cast<Real>(n), 0.5 * static_cast<Real>(n),
          0.1 * static_cast<Real>(n), 1);
    Real best = infinity;
    for ([[maybe_unused]] const auto& _ : state) {
        const auto start = std::chrono::steady_clock::now();
        leapfrog(field, 0.7);
        best = std::min(best, std::chrono::duration<Real>(
                                  std::chrono::steady_clock::now() - start)
                                  .count());
    }
    const auto cells = static_cast<Real>(field.y.size());
    report(state, best * 1e6, 0, best * 1e9 / cells, 32 * cells / best * 1e-9);
}
BENCHMARK(membrane)->Arg(100)->Arg(300)->Arg(1000)->Arg(3000)->Iterations(40);

/// The least time of a step, and what it means for the memory.
/// \param bytes  that a step reads and writes, a cell
template <class Water>
void time_water(benchmark::State& state, Water& water, Real h, Real bytes)
{
    Real best = infinity;
    for ([[maybe_unused]] const auto& _ : state) {
        const auto start = std::chrono::steady_clock::now();
        step(water, h);
        best = std::min(best, std::chrono::duration<Real>(
                                  std::chrono::steady_clock::now() - start)
                                  .count());
    }
    const auto cells = static_cast<Real>(water.depth.size());
    report(state, best * 1e6, 0, best * 1e9 / cells, bytes * cells / best * 1e-9);
}

/// The check of the step reads depth and u; the step reads bed, depth and u, and writes depth, level and u.
void water(benchmark::State& state)
{
    const auto n = static_cast<Index>(state.range(0));
    ShallowWater tank(n, static_cast<Real>(n), 1);
    for (Index i = 0; i < n / 2; ++i) tank.depth[i] += 0.3;
    time_water(state, tank, 0.15, 64);
}
BENCHMARK(water)->Arg(1000)->Arg(100000)->Arg(1000000)->Iterations(100);

/// The check reads depth, u and v; the step reads these and bed, and writes them.
void field(benchmark::State& state)
{
    const auto n = static_cast<Index>(state.range(0));
    WaterField basin(n, n, 1, 1);
    for (Index k = 0; k < n * n / 2; ++k)
        basin.depth[k] += k % n < n / 2 ? 0.3 : 0.1;
    time_water(state, basin, 0.12, 80);
}
BENCHMARK(field)->Arg(100)->Arg(300)->Arg(1000)->Arg(3000)->Iterations(40);

void afloat(benchmark::State& state)
{
    WaterScene all = pond(256, 16, 1.5);
    add_raft(all, 0, static_cast<int>(state.range(0)));
    Floating floating;
    floating.displace(all.scene, all.water);
    Real best = infinity;
    for ([[maybe_unused]] const auto& _ : state) {
        const auto start = std::chrono::steady_clock::now();
        floating.find(all.scene, all.water);
        floating.push(all.scene, all.water, 1.0 / 240);
        best = std::min(best, std::chrono::duration<Real>(
                                  std::chrono::steady_clock::now() - start)
                                  .count());
    }
    report(state, best * 1e6, 0,
           best * 1e9 / static_cast<Real>(floating.slices.size()), 0);
}
BENCHMARK(afloat)->Arg(1)->Arg(4)->Arg(16)->Iterations(200);

void drum(benchmark::State& state)
{
    const StiffnessMatrix K =
        drum_stiffness(static_cast<Index>(state.range(0)), 1, 1);
    Modes modes;
    Real best = infinity;
    for ([[maybe_unused]] const auto& _ : state) {
        const auto start = std::chrono::steady_clock::now();
        modes = lowest_modes(K, 4);
        best = std::min(best, std::chrono::duration<Real>(
                                  std::chrono::steady_clock::now() - start)
                                  .count());
    }
    report(state, best * 1e6, std::abs(modes.omega[0] - 2.404825557695773), 0, 0);
}
BENCHMARK(drum)->Arg(10)->Arg(20)->Arg(40)->Iterations(1)->Unit(
    benchmark::kMillisecond);

}  // namespace
}  // namespace rigid

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    rigid::add_strings();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
