/// Chapter 20: work against error for a body that spins freely.
///
///     spin/WAY/N    five seconds of I = (1, 2, 3) in N steps: the error of ω [rad/s] beside (20.24), how far the energy is
///                   off at the end, and the time

#include "chapters/20_turning_in_space/exact_tumbling.hpp"
#include "chapters/20_turning_in_space/tumbling.hpp"

#include <benchmark/benchmark.h>

using namespace rigid;

namespace {

void spin(benchmark::State& state, Tumbling way)
{
    const auto steps = static_cast<int>(state.range(0));
    const Vec3 inertia(1, 2, 3), start(0.5, 0, 1);
    Vec3 theta(0, 0, 0), omega = start;
    for (auto _ : state) {
        theta.setZero();
        omega = start;
        for (int n = 0; n < steps; ++n)
            tumble(way, inertia, 5.0 / steps, theta, omega);
        benchmark::DoNotOptimize(theta.data());
    }
    state.counters["error"] = (omega - exact_spin(inertia, 0.5, 1, 5)).norm();
    state.counters["energy_error"] =
        inertia.dot(omega.cwiseAbs2()) / inertia.dot(start.cwiseAbs2()) - 1;
}

}  // namespace

BENCHMARK_CAPTURE(spin, explicit, Tumbling::explicit_term)
    ->RangeMultiplier(2)
    ->Range(64, 4096);
BENCHMARK_CAPTURE(spin, implicit, Tumbling::implicit_term)
    ->RangeMultiplier(2)
    ->Range(64, 4096);
BENCHMARK_CAPTURE(spin, momentum, Tumbling::momentum_kept)
    ->RangeMultiplier(2)
    ->Range(64, 4096);
BENCHMARK_CAPTURE(spin, middle, Tumbling::middle)
    ->RangeMultiplier(2)
    ->Range(64, 4096);

BENCHMARK_MAIN();
