/// \file turning_runs.hpp
/// The task "step a scene of bodies that turn": h = 1/60 s, from the start of the scene.
///
///     error = how far the bodies are from where they belong, in metres or radians, at worst over all steps
///
/// Boxes at rest belong where they are; a box on a slope where its closed form says; the rods of a pendulum where their
/// equations in angles say after a second.
#pragma once

#include "docs/results/measurement.hpp"

#include "chapters/13_friction/slopes.hpp"

#include <algorithm>
#include <functional>
#include <memory>

namespace rigid::results {

struct TurningScene {
    std::string name, parameters, reference;
    RoughScene scene;
    int steps = 120;
    bool rests = true;  ///< sleep is allowed
    bool quick = false;
    /// after step n, counted from 1
    std::function<Real(const RoughScene&, int n)> error = {};

    Real h() const { return 1.0 / 60; }
};
using SharedTurning = std::shared_ptr<const TurningScene>;

/// Keeps the worst of the errors of a run.
class WorstError {
public:
    explicit WorstError(const TurningScene& run) : run_(run) {}
    void look(const RoughScene& scene)
    {
        const Real error = run_.error(scene, ++steps_);
        if (!(error <= worst_)) worst_ = std::isfinite(error) ? error : infinity;
    }
    Result result(std::optional<std::int64_t> work, const char* status) const
    {
        return {work, {}, worst_, worst_ < infinity ? status : "fell"};
    }

private:
    const TurningScene& run_;
    int steps_ = 0;
    Real worst_ = 0;
};

/// Adds a way to step.
/// \param make  make() gives step(RoughScene&, std::int64_t& work, bool& solved): a new one remembers no step
template <class Make>
void add_turning_run(Registry& registry, const SharedTurning& run, const std::string& chapter,
                     const std::string& method, const std::string& parameters, bool quick, const Make& make)
{
    registry.add({chapter, method, run->name,
                  run->parameters + ' ' + parameters + " reference=" + run->reference, run->h(), quick, [=] {
                      const auto scene = std::make_shared<RoughScene>(run->scene);
                      const auto work = std::make_shared<std::int64_t>();
                      const auto solved = std::make_shared<bool>();
                      const auto go = [=](const std::function<void()>& after_step) {
                          auto step = make();
                          scene->bodies = run->scene.bodies;
                          *work = 0;
                          *solved = true;
                          for (int k = 0; k < run->steps; ++k) {
                              step(*scene, *work, *solved);
                              if (after_step) after_step();
                          }
                      };
                      Task task;
                      task.run = [=] { go({}); };
                      task.judge = [=] {
                          WorstError watch(*run);
                          go([&] { watch.look(*scene); });
                          return watch.result(*work, *solved ? "finished" : "not solved");
                      };
                      return task;
                  }});
}

void add_turning(Registry& registry);                                    ///< all scenes of bodies that turn
void add_turning_methods(Registry& registry, const SharedTurning& run);  ///< chapters 11 to 13
void add_turning_engines(Registry& registry, const SharedTurning& run);  ///< Box2D, Chipmunk

}  // namespace rigid::results
