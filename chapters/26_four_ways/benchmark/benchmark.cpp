/// Chapter 26: every way on every scene, run time against error.
///
///     SCENE/WAY/N     in steps of 1/N s: time of one second of the scene [µs], best of five runs; the error at its end, and
///                     the energy gained [J]. A run that flies apart has the error 10
///     beads/WAY/N     a chain of N rods, 240 steps a second: time of a step for each rod [ns], for how ways grow
///
/// With --tables it prints the tables of the text instead.

#include "chapters/26_four_ways/program/who_can.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <cstring>

using namespace rigid;

namespace {

using Clock = std::chrono::steady_clock;

Real microseconds(Clock::time_point since)
{
    return std::chrono::duration<Real, std::micro>(Clock::now() - since).count();
}

void measure(benchmark::State& state, Way way, const WayScene& scene)
{
    const Real h = 1.0 / static_cast<Real>(state.range(0));
    Real best = infinity;
    WayResult result;
    for (auto _ : state)
        for (int round = 0; round < 5; ++round) {
            const auto start = Clock::now();
            result = run_way(way, scene, h, settings_of(scene));
            best = std::min(best, microseconds(start));
            if (best > 1e5) break;  // a tenth of a second needs no second look
        }
    state.counters["us"] = best / scene.time;
    state.counters["error"] = result.why_not.empty() ? result.error : 10;
    state.counters["energy"] = result.why_not.empty() ? result.energy_gain : 0;
    state.counters["ns"] = 0;  // a table has the same columns in each line
}

void grow(benchmark::State& state, Way way)
{
    const auto links = static_cast<int>(state.range(0));
    WayScene chain;
    chain.scene = chain_scene({links, 0.1, 0.1, 1, 20 * pi / 180});
    chain.filter.set_meets(0, 0, false);
    Real best = infinity;
    for (auto _ : state)
        for (int round = 0; round < 5; ++round) {
            WayRun run(way, chain, {1e4, 20});
            run.advance(1.0 / 960);
            const auto start = Clock::now();
            for (int i = 0; i < 10; ++i) run.advance(1.0 / 960);
            best = std::min(best, microseconds(start) / 10);
        }
    state.counters["ns"] = 1000 * best / links;
    state.counters["us"] = state.counters["error"] = state.counters["energy"] = 0;
}

void list()
{
    for (const WayScene& scene : way_scenes())
        for (const Way way : all_ways) {
            if (!can_take(way, scene)) continue;
            std::string name = scene.name;
            for (char& c : name)
                if (c == ' ') c = '_';
            auto* const one = benchmark::RegisterBenchmark(
                (name + "/" + std::string(to_string(way))).c_str(),
                [way, scene](benchmark::State& state) {
                    measure(state, way, scene);
                });
            for (const int n : {30, 60, 120, 240, 480, 960, 1920, 3840})
                one->Args({n});
            one->Iterations(1);
        }
    for (const Way way : {Way::spring, Way::end_spring, Way::acceleration,
                          Way::impulses, Way::positions, Way::coordinates}) {
        auto* const one = benchmark::RegisterBenchmark(
            ("beads/" + std::string(to_string(way))).c_str(),
            [way](benchmark::State& state) { grow(state, way); });
        for (const int n : {10, 20, 40, 80, 160}) one->Args({n});
        one->Iterations(1);
    }
}

void print(const char* title, const std::vector<std::string>& lines)
{
    std::printf("%s\n", title);
    for (const std::string& line : lines) std::printf("%s\n", line.c_str());
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc == 2 && std::strcmp(argv[1], "--tables") == 0) {
        print("error at 240 steps a second", error_table(way_scenes(), 1.0 / 240));
        print("energy gained at 240 steps a second",
              energy_table(way_scenes(), 1.0 / 240));
        print("longest step within 0.05", step_table(without_doll(), 0.05));
        return 0;
    }
    list();
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
