/// Chapter 26: every way on every scene, run time against error.
///
///     SCENE/WAY/N     in steps of 1/N s: time of the steps of one second of the scene [µs], best of five runs; the error at its end, and
///                     the energy gained [J]. A run that flies apart has the error 10
///     beads/WAY/N     a chain of N rods, 240 steps a second: time of a step for each rod [ns], for how ways grow
///
///     SCENE/PEER/N    the same of an engine that is installed: ODE, Bullet, Bullet's trees, Simbody, MuJoCo
///
///     forces/PROBLEM/SOLVER   (26.5) where a scene starts: time of its solution [µs], best of many, and its residual [m/s², rad/s²];
///                             a solver that has no answer has the error 10
///
/// With --tables it prints the tables of the text instead.

#include "chapters/26_four_ways/benchmark/force_problems.hpp"
#include "chapters/26_four_ways/benchmark/peer_ways.hpp"
#include "chapters/26_four_ways/program/who_can.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <cstring>

using namespace rigid;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array rates{30, 60, 120, 240, 480, 960, 1920, 3840};  // 1/h

Real microseconds(Clock::time_point since)
{
    return std::chrono::duration<Real, std::micro>(Clock::now() - since).count();
}

/// What a run came to, and the time of its steps alone.
struct Timed {
    WayResult result;
    Real us = 0;
};

Timed timed(Way way, const WayScene& scene, Real h)
{
    Timed timed;
    WayRun run(way, scene, settings_of(scene));
    const auto start = Clock::now();
    timed.result.why_not = advance_to_end(run, scene, steps_of(scene, h));
    timed.us = microseconds(start);
    if (timed.result.why_not.empty()) timed.result = result_of(scene, run.scene());
    return timed;
}

template <class Peer>
Timed timed(const WayScene& scene, Real h)
{
    Timed timed;
    const int steps = steps_of(scene, h);
    Peer peer(scene);
    const auto start = Clock::now();
    for (int i = 0; i < steps; ++i) peer.step(scene.time / steps);
    timed.us = microseconds(start);
    JointedScene end = scene.scene;
    peer.read(end);
    timed.result = result_of(scene, end);
    return timed;
}

/// \param run  Timed(Real h)
template <class Run>
void measure(benchmark::State& state, const WayScene& scene, const Run& run)
{
    const Real h = 1.0 / static_cast<Real>(state.range(0));
    Real best = infinity;
    WayResult result;
    for (auto _ : state)
        for (int round = 0; round < 5; ++round) {
            const Timed now = run(h);
            result = now.result;
            best = std::min(best, now.us);
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

/// A name as Google Benchmark's filter takes it.
std::string in_one_word(std::string name)
{
    for (char& c : name)
        if (c == ' ' || c == '\'') c = '_';
    return name;
}

void list_forces()
{
    for (const ForceProblem& problem : force_problems())
        for (const ForceSolver& solver : force_solvers()) {
            if (!solver.solve(problem).ran) continue;
            auto* const one = benchmark::RegisterBenchmark(
                in_one_word("forces/" + problem.name + "/" + solver.name).c_str(),
                [problem, solver](benchmark::State& state) {
                    Real best = infinity, residual = infinity;
                    for (auto _ : state)
                        for (int round = 0; round < 200; ++round) {
                            const Forces found = solver.solve(problem);
                            residual = problem.residual(found.f);
                            best = std::min(best, found.us);
                        }
                    state.counters["us"] = best;
                    state.counters["error"] = residual < 1 ? residual : 10;
                    state.counters["energy"] = state.counters["ns"] = 0;
                });
            one->Iterations(1);
        }
}

/// \param run  Timed(Real h)
template <class Run>
void list(const WayScene& scene, const std::string& way, const Run& run)
{
    auto* const one = benchmark::RegisterBenchmark(
        in_one_word(scene.name + "/" + way).c_str(),
        [scene, run](benchmark::State& state) { measure(state, scene, run); });
    for (const int n : rates) one->Args({n});
    one->Iterations(1);
}

template <class Peer>
void list_peer(const WayScene& scene)
{
    if (Peer::can_take(scene))
        list(scene, Peer::name, [scene](Real h) { return timed<Peer>(scene, h); });
}

void list()
{
    for (const WayScene& scene : way_scenes()) {
        for (const Way way : all_ways)
            if (can_take(way, scene))
                list(scene, std::string(to_string(way)),
                     [way, scene](Real h) { return timed(way, scene, h); });
        for_each_peer([&scene]<class Peer>(std::type_identity<Peer>) {
            list_peer<Peer>(scene);
        });
    }
    list_forces();
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

/// Error and energy gained of each engine at 240 steps a second: one line a scene and engine.
std::vector<std::string> peer_table()
{
    std::vector<std::string> lines;
    for (const WayScene& scene : way_scenes())
        for_each_peer([&]<class Peer>(std::type_identity<Peer>) {
            if (!Peer::can_take(scene)) return;
            const WayResult result = timed<Peer>(scene, 1.0 / 240).result;
            const bool went = result.why_not.empty();
            lines.push_back(line_of(
                {scene.name, Peer::name, went ? one_digit(result.error) : "gone",
                 went && scene.keeps_energy ? signed_digit(result.energy_gain)
                                            : "–"}));
        });
    return lines;
}

/// What each solver leaves of (26.5): one line a problem and solver, as forces.csv has it, without the time.
std::vector<std::string> force_table()
{
    std::vector<std::string> lines;
    for (const ForceProblem& problem : force_problems())
        for (const ForceSolver& solver : force_solvers()) {
            const Forces found = solver.solve(problem);
            if (!found.ran) continue;
            char text[160];
            const Real residual = problem.residual(found.f);
            std::snprintf(text, sizeof text, "%s,%d,%s,%.6g,", problem.name.c_str(),
                          static_cast<int>(problem.mlcp.size()),
                          solver.name.c_str(), residual < 1 ? residual : 10);
            lines.emplace_back(text);
        }
    return lines;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc == 2 && std::strcmp(argv[1], "--tables") == 0) {
        const std::vector<WayScene> scenes = way_scenes();
        const Real h = 1.0 / 240;
        print("error at 240 steps a second", error_table(scenes, h));
        print("energy gained at 240 steps a second", energy_table(scenes, h));
        print("|C| and |dC/dt| at 240 steps a second", drift_table(scenes, h));
        print("order in h", order_table(scenes));
        print("longest step within 0.05", step_table(scenes, 0.05));
        print("longest stable step", stable_table(scenes));
        print("engines at 240 steps a second", peer_table());
        print("problem,rows,solver,residual,us", force_table());
        return 0;
    }
    peers::single_thread();
    list();
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
