// Chapter 10 steps a scene: chapter 8's step without what needs nothing. The world is built before the clock starts,
// as those of the other engines are. Errors are corrected apart from the impulses that are remembered, as section 8.5
// wants it.
#include "docs/results/runs.hpp"

#include "chapters/10_skipping_work/skipping_world.hpp"

#include <ctime>

namespace rigid::results {
namespace {

/// \param sweeps  at most, in each sub-step; they end at a residual of 1 µm/s
void add_skipping(Registry& registry, const SharedRun& run, const std::string& method, int sweeps,
                  int substeps, bool quick, bool sleep, int exact_rows = SkippingSettings{}.exact_rows)
{
    SkippingSettings settings;
    settings.h = run->h();
    settings.substeps = substeps;
    settings.sweeps.max_sweeps = sweeps;
    settings.sweeps.tolerance = 1e-6;
    settings.stabilizer.method = Stabilizer::split_impulse;
    settings.sleep = sleep;
    settings.exact_rows = exact_rows;
    registry.add({"10", method, run->engine.name,
                  run->parameters + " sweeps=" + std::to_string(sweeps) +
                      (substeps > 1 ? " substeps=" + std::to_string(substeps) : "") +
                      " unit=row_visit reference=" + (run->engine.rests ? "rest" : "exact_tensions"),
                  run->h(), quick, [=] {
                      const auto fresh = std::make_shared<SkippingWorld>(
                          make_world(run->engine.scene, filter_of(run->engine.scene)));
                      const auto work = std::make_shared<std::int64_t>();
                      const auto seconds = std::make_shared<Real>();
                      Task task;
                      task.run = [=] {
                          SkippingWorld world = *fresh;
                          *work = 0;
                          const std::clock_t start = std::clock();
                          for (int k = 0; k < run->steps; ++k) {
                              skipping_step(world, settings);
                              *work += world.counters.visits;
                          }
                          *seconds = static_cast<Real>(std::clock() - start) / CLOCKS_PER_SEC;
                      };
                      task.judge = [=] {
                          SkippingWorld world = *fresh;
                          PoseWatch watch(run->engine, run->steps, run->h());
                          for (int k = 0; k < run->steps; ++k) {
                              skipping_step(world, settings);
                              watch.look(world.scene);
                          }
                          return judged(watch, *work, "finished");
                      };
                      task.seconds = [=] { return *seconds; };
                      return task;
                  }});
}

}  // namespace

void add_skipping_runs(Registry& registry, const SharedRun& run)
{
    for (const int sweeps : {10, 40, 400}) {
        const bool quick = sweeps == 10 && run->dense;
        add_skipping(registry, run, "skipping", sweeps, 1, quick, true);
        if (run->resting)
            add_skipping(registry, run, "skipping_without_sleep", sweeps, 1, sweeps == 10, false);
    }
    for (const int substeps : {4, 8, 16, 32})
        add_skipping(registry, run, "skipping", 40, substeps, false, true);
    if (run->resting) add_skipping(registry, run, "skipping_exact_islands", 40, 1, true, true, 32);
}

}  // namespace rigid::results
