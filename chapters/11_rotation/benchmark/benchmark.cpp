/// Chapter 11: work against error for rods that swing.
///
///     error/SCENE/METHOD/N   one second in N sub-steps, four to a step: the error of the angle [rad], the largest error
///                            of a pin [m], row visits, and the time

#include "chapters/01_euler_integration/exact.hpp"
#include "chapters/11_rotation/mechanisms.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <string>

using namespace rigid;

namespace {

struct Case {
    std::string name;
    int rods;
    Real truth;  ///< angle of the first rod after 1 s from level, at rest [rad]
};

// The pendulum: closed form (chapter 1's exact_pendulum() of 2/3 m); the double one: Runge-Kutta in angles.
const std::array cases = {Case{"pendulum", 1, 0},
                          Case{"double", 2, -1.207716238190638}};

template <class Method>
void measure(benchmark::State& state, const Case& scene, Method fresh, Real truth)
{
    const long parts = state.range(0);
    Real error = 0, pin = 0;
    std::int64_t visits = 0;
    for (auto _ : state) {
        const std::array<Real, 2> level = {pi / 2, pi / 2};
        RigidScene rods = rod_pendulum(std::span<const Real>(level).first(
            static_cast<std::size_t>(scene.rods)));
        Method method = fresh;
        StepData<3> now;
        visits = 0;
        for (long i = 0; i < parts / 4; ++i) {
            step(rods, {.h = 4.0 / static_cast<Real>(parts), .substeps = 4}, method,
                 now);
            visits += now.visits;
        }
        error = std::abs(rod_angle(rods, 0) - truth);
        pin = largest_joint_error(rods);
        benchmark::DoNotOptimize(rods.bodies.x.data());
    }
    state.counters["angle_error"] = error;
    state.counters["pin_error"] = pin;
    state.counters["row_visits"] = static_cast<double>(visits);
}

}  // namespace

int main(int argc, char** argv)
{
    RigidExact exact;
    exact.correction = exact_repair();
    RigidSweeps ten, one, baumgarte;
    ten.correction.method = one.correction.method = Stabilizer::projection;
    ten.solver.sweeps.max_sweeps = baumgarte.solver.sweeps.max_sweeps = 10;
    one.solver.sweeps.max_sweeps = 1;
    one.correction.correction_sweeps = 1;
    for (const Case& scene : cases) {
        const Real truth =
            scene.rods == 1
                ? exact_pendulum({.g = 9.81, .length = 2.0 / 3}, pi / 2, 1).x[0]
                : scene.truth;
        const auto add = [&](const std::string& method, const auto& fresh) {
            auto* const made = benchmark::RegisterBenchmark(
                ("error/" + scene.name + "/" + method).c_str(),
                [&scene, fresh, truth](benchmark::State& state) {
                    measure(state, scene, fresh, truth);
                });
            made->RangeMultiplier(2)->Range(64, 4096)->Unit(
                benchmark::kMicrosecond);
        };
        add("exact", exact);
        add("rattle", RigidRattle{});
        add("projection_10", ten);
        add("projection_1", one);
        add("baumgarte_10", baumgarte);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
