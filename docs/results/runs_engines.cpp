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

/// How many small steps of one iteration (1: its own number of iterations), what sleeps, and the slop.
template <class World>
[[maybe_unused]] void add_engine(Registry& registry, const SharedRun& run, const std::string& method,
                                 int substeps, const PeerSettings& settings)
{
    registry.add({"peer", method, run->engine.name,
                  run->parameters + " substeps=" + std::to_string(substeps) +
                      " slop=" + shortest(settings.slop) +
                      " unit=none reference=" + (run->engine.rests ? "rest" : "exact_tensions"),
                  run->h(), false, [=] {
                      const auto seconds = std::make_shared<Real>();
                      Task task;
                      task.run = [=] {
                          World world(run->engine, settings);
                          const std::clock_t start = std::clock();
                          for (int k = 0; k < run->steps; ++k) world.step(run->h(), substeps);
                          *seconds = static_cast<Real>(std::clock() - start) / CLOCKS_PER_SEC;
                      };
                      task.judge = [=] {
                          World world(run->engine, settings);
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

/// As many small steps as the book's own methods have, sleep or none where something rests, and in piles three slops:
/// whatever does best is an engine's answer. Nothing of a chain touches, so its slop is the engine's own.
template <class World>
[[maybe_unused]] void add_engine(Registry& registry, const SharedRun& run, const std::string& method)
{
    for (const int substeps : {1, 4, 8, 16, 32}) {
        for (const Real slop : {5e-3, 5e-4, 5e-5}) {
            if (!run->engine.collides && slop != PeerSettings{}.slop) continue;
            add_engine<World>(registry, run, method, substeps, {false, slop});
            if (run->engine.rests)
                add_engine<World>(registry, run, method + "_sleeping", substeps, {true, slop});
        }
    }
}

}  // namespace

void add_engine_runs([[maybe_unused]] Registry& registry, [[maybe_unused]] const SharedRun& run)
{
#ifdef RIGID_HAS_BOX2D
    add_engine<Box2dWorld>(registry, run, "box2d");
#endif
#ifdef RIGID_HAS_CHIPMUNK
    add_engine<ChipmunkSpace>(registry, run, "chipmunk");
#endif
}

}  // namespace rigid::results
