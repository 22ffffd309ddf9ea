/// \file runs.hpp
/// The task "step a scene for so long", as an engine is used: h = 1/60 s, g = 10 m/s², everything from rest.
///
///     error = max(error of a link, overlap, way of the centre of mass from where it belongs) / 0.1 m
///
/// over all steps, from the positions alone, by chapter 8's PoseWatch: 0.1 m is the length of a link and the
/// radius of a disc. A heap whose discs change places has the error infinity.
#pragma once

#include "docs/results/measurement.hpp"

#include "chapters/08_warm_starting/benchmark/pose_errors.hpp"

#include <memory>

namespace rigid::results {

struct RunScene {
    EngineScene engine;
    std::string parameters;
    int steps = 300;
    bool exact = true;   ///< exact solvers end in time
    bool dense = false;  ///< those with dense matrices too
    bool resting =
        false;  ///< it is about what sleeps: chapter 10 with and without it, and the engines' own sleep

    Real h() const { return 1.0 / 60; }
};
using SharedRun = std::shared_ptr<const RunScene>;

/// What a watch has seen, as a row of the table. \param status  of a run whose discs kept their order
inline Result judged(const PoseWatch& watch, std::optional<std::int64_t> work, const char* status)
{
    const PoseErrors& errors = watch.errors;
    const Real error = std::max(errors.position(), errors.drift) / 0.1;
    if (!errors.in_order || !std::isfinite(error)) return {work, {}, infinity, "fell"};
    return {work, {}, error, status};
}

/// Adds a way to step.
/// \param make  make() gives step(DiscScene&, std::int64_t& work, bool& solved): a new one remembers no step
template <class Make>
void add_run(Registry& registry, const SharedRun& run, const std::string& chapter, const std::string& method,
             const std::string& parameters, bool quick, const Make& make)
{
    registry.add(
        {chapter, method, run->engine.name,
         run->parameters + ' ' + parameters + " reference=" + (run->engine.rests ? "rest" : "exact_tensions"),
         run->h(), quick, [=] {
             const auto scene = std::make_shared<DiscScene>(run->engine.scene);
             const auto work = std::make_shared<std::int64_t>();
             const auto solved = std::make_shared<bool>();
             const auto go = [=](const std::function<void()>& after_step) {
                 auto step = make();
                 scene->bodies = run->engine.scene.bodies;
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
                 PoseWatch watch(run->engine, run->steps, run->h());
                 go([&] { watch.look(*scene); });
                 return judged(watch, *work, *solved ? "finished" : "not solved");
             };
             return task;
         }});
}

void add_matrix_runs(Registry& registry, const SharedRun& run);    ///< chapters 3 to 5 and 9
void add_impulse_runs(Registry& registry, const SharedRun& run);   ///< chapters 6 to 8
void add_skipping_runs(Registry& registry, const SharedRun& run);  ///< chapter 10
void add_engine_runs(Registry& registry, const SharedRun& run);    ///< Box2D, Chipmunk

}  // namespace rigid::results
