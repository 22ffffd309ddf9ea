// Chapter 10 steps a scene: chapter 8's step without what needs nothing. The world is built before the clock starts,
// as those of the other engines are.
#include "docs/results/runs.hpp"

#include "chapters/10_skipping_work/skipping_world.hpp"

#include <ctime>

namespace rigid::results {
namespace {

void add_skipping(Registry& registry, const SharedRun& run, const std::string& method, int sweeps, bool quick,
                  bool sleep, int exact_rows = SkippingSettings{}.exact_rows)
{
    SkippingSettings settings;
    settings.h = run->h();
    settings.sweeps.max_sweeps = sweeps;
    settings.sweeps.tolerance = 1e-6;
    settings.start = Start::previous;
    settings.stabilizer.method = Stabilizer::baumgarte;
    settings.sleep = sleep;
    settings.exact_rows = exact_rows;
    registry.add({"10", method, run->engine.name,
                  run->parameters + " sweeps=" + std::to_string(sweeps) +
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
    for (const int sweeps : {10, 40}) {
        add_skipping(registry, run, "skipping", sweeps, sweeps == 10 && run->dense, true);
        if (run->resting) add_skipping(registry, run, "skipping_without_sleep", sweeps, sweeps == 10, false);
    }
    if (run->resting) add_skipping(registry, run, "skipping_exact_islands", 40, true, true, 32);
}

}  // namespace rigid::results
