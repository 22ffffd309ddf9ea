/// Chapter 18: each island by its own solver, beside one solver for all, on the same scenes.
///
///     SCENE/METHOD   four seconds at 60 steps a second; METHOD: by_island, exact, sweeps
///         ms_all     all steps together [ms]       us_step    the longest one [µs]
///         price      of all steps, by (18.2) and (18.3) [10⁶ entries]
///         unsolved   steps that end with an island above what is good enough
///         overlap    the deepest, when a step begins [m]
///         gap        the largest error of a joint after a step [m]

#include "chapters/18_islands/island_method.hpp"
#include "chapters/18_islands/island_scenes.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <string>

using namespace rigid;

namespace {

constexpr int steps = 240;

/// The largest error of a joint [m], [rad].
Real largest_error(const JointedScene& scene)
{
    Real largest = 0;
    for (const PointJoint& row : scene.joints)
        if (row.kind == ConstraintKind::bilateral)
            largest = std::max(largest,
                               std::abs(joint_constraint(scene.bodies.x, row).C));
    return largest;
}

void run(benchmark::State& state, const JointedScene& start, Solving solving)
{
    for (auto _ : state) {
        JointedScene scene = start;
        IslandMethod method = island_method(scene, {.solving = solving});
        StepData<3> now;
        Real all = 0, longest = 0, price = 0, overlap = 0, gap = 0;
        int unsolved = 0;
        for (int n = 0; n < steps; ++n) {
            const auto begin = std::chrono::steady_clock::now();
            step(scene, {}, method, now);
            const Real us = std::chrono::duration<Real, std::micro>(
                                std::chrono::steady_clock::now() - begin)
                                .count();
            all += us, longest = std::max(longest, us);
            if (now.active.empty()) continue;
            price += static_cast<Real>(price_of_step(method, now));
            unsolved +=
                std::max(method.solver.unsolved, method.correction.unmet) > 0;
            for (const Contact& contact : now.contacts)
                overlap = std::max(overlap, -contact.gap);
            gap = std::max(gap, largest_error(scene));
        }
        state.counters["ms_all"] = all / 1000;
        state.counters["us_step"] = longest;
        state.counters["price"] = price / 1e6;
        state.counters["unsolved"] = unsolved;
        state.counters["overlap"] = overlap;
        state.counters["gap"] = gap;
    }
}

void add(const std::string& name, const JointedScene& scene)
{
    for (const Solving solving :
         {Solving::by_island, Solving::exact, Solving::sweeps})
        benchmark::RegisterBenchmark(
            (name + '/' + std::string(to_string(solving))).c_str(),
            [scene, solving](benchmark::State& state) {
                run(state, scene, solving);
            })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv)
{
    add("struck tower", struck_tower_scene());
    add("pyramid of 20", rough_scene(box_pyramid(20)));
    add("heavy on ten", rough_scene(loaded_column(10, 1000)));
    add("net of 10", net_scene(10));
    add("60 poured", poured_scene(60));
    add("heap and net", mixed_scene(60, 6));
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
