// Two engines step a scene: worlds built by chapter 8, timed without the building.
#include "docs/results/runs.hpp"

#ifdef RIGID_HAS_BOX2D
#include "chapters/08_warm_starting/benchmark/peers_box2d.hpp"
#endif
#ifdef RIGID_HAS_CHIPMUNK
#include "chapters/08_warm_starting/benchmark/peers_chipmunk.hpp"
#endif

#include <ctime>

namespace rigid::results {
namespace {

template <class World>
[[maybe_unused]] void add_engine(Registry& registry, const SharedRun& run, const std::string& method,
                                 int substeps, bool sleeping = false)
{
    registry.add({"peer", method, run->engine.name,
                  run->parameters + " substeps=" + std::to_string(substeps) +
                      " unit=none reference=" + (run->engine.rests ? "rest" : "exact_tensions"),
                  run->h(), false, [=] {
                      const auto seconds = std::make_shared<Real>();
                      Task task;
                      task.run = [=] {
                          World world(run->engine, sleeping);
                          const std::clock_t start = std::clock();
                          for (int k = 0; k < run->steps; ++k) world.step(run->h(), substeps);
                          *seconds = static_cast<Real>(std::clock() - start) / CLOCKS_PER_SEC;
                      };
                      task.judge = [=] {
                          World world(run->engine, sleeping);
                          DiscScene scene = run->engine.scene;
                          PoseWatch watch(run->engine, run->steps, run->h());
                          for (int k = 0; k < run->steps; ++k) {
                              world.step(run->h(), substeps);
                              world.poses(scene);
                              watch.look(scene);
                          }
                          return judged(watch, {}, "finished");
                      };
                      task.seconds = [=] { return *seconds; };
                      return task;
                  }});
}

}  // namespace

void add_engine_runs([[maybe_unused]] Registry& registry, [[maybe_unused]] const SharedRun& run)
{
#ifdef RIGID_HAS_BOX2D
    for (const int substeps : {1, 4, 8}) add_engine<Box2dWorld>(registry, run, "box2d", substeps);
    if (run->resting) add_engine<Box2dWorld>(registry, run, "box2d_sleeping", 1, true);
#endif
#ifdef RIGID_HAS_CHIPMUNK
    for (const int substeps : {1, 4, 8}) add_engine<ChipmunkSpace>(registry, run, "chipmunk", substeps);
    if (run->resting) add_engine<ChipmunkSpace>(registry, run, "chipmunk_sleeping", 1, true);
#endif
}

}  // namespace rigid::results
