/// \file timing.hpp
/// How long a task takes, as a multiple of the baseline, measured in turns with it by Google Benchmark.
#pragma once

#include "docs/results/baseline.hpp"
#include "docs/results/measurement.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace rigid::results {

/// Keeps the least time per iteration [s] instead of printing anything.
class LeastTime : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override
    {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration || run.error_occurred || run.iterations == 0) continue;
            const Real total = manual ? run.real_accumulated_time : run.cpu_accumulated_time;
            least = std::min(least, total / static_cast<Real>(run.iterations));
        }
    }
    bool manual = false;  ///< the task has its own clock
    Real least = infinity;
};

/// The least time of the baseline that this process has seen [s]; infinite before the first.
inline Real& least_baseline()
{
    static Real least = infinity;
    return least;
}

/// Time of the task over time of the baseline: of each the least of several turns, because what disturbs only
/// adds.
/// \param seconds  about what one run takes; a long one is not repeated often
/// \param quick    fewer turns
inline Real time_ratio(const Task& task, Real seconds, bool quick)
{
    static Baseline baseline;
    benchmark::ClearRegisteredBenchmarks();
    const Real least_time = quick ? 0.001 : 0.004;
    auto* const of_task = benchmark::RegisterBenchmark("task", [&](benchmark::State& state) {
        for (auto _ : state) {
            task.run();
            if (task.seconds) state.SetIterationTime(task.seconds());
        }
    });
    if (task.seconds) of_task->UseManualTime();
    if (seconds > 0.02) of_task->Iterations(1);
    else of_task->MinTime(least_time);
    benchmark::RegisterBenchmark("baseline", [](benchmark::State& state) {
        for (auto _ : state) benchmark::DoNotOptimize(baseline.run());
    })->MinTime(0.001);

    LeastTime of_both[2];
    of_both[0].manual = static_cast<bool>(task.seconds);
    const int turns = quick || seconds > 0.1 ? 2 : 5;
    for (int turn = 0; turn < turns; ++turn) {
        benchmark::RunSpecifiedBenchmarks(&of_both[0], "^task");
        benchmark::RunSpecifiedBenchmarks(&of_both[1], "^baseline");
    }
    least_baseline() = std::min(least_baseline(), of_both[1].least);
    return of_both[0].least / of_both[1].least;
}

}  // namespace rigid::results
