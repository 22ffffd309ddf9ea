/// \file turning_runs.hpp
/// The task "step a scene of bodies that turn": h = 1/60 s, from the start of the scene.
///
///     error = how far the bodies are from where they belong, in metres or radians, at worst over all steps
///
/// Boxes at rest belong where they are, and so do the planks of a bridge; a box on a slope where its closed form says; the
/// rods of a pendulum where their equations in angles say after a second; a chain where its equations in the coordinates of its
/// joints say. The joints of a doll belong together, and within their limits.
#pragma once

#include "docs/results/measurement.hpp"

#include "chapters/13_friction/slopes.hpp"
#include "chapters/14_joints/joint.hpp"

#include <algorithm>
#include <functional>
#include <memory>

namespace rigid::results {

struct TurningScene {
    std::string name, parameters, reference;
    JointedScene scene;
    int steps = 120;
    bool rests = true;    ///< sleep is allowed
    bool touches = true;  ///< bodies collide
    bool quick = false;
    /// after step n, counted from 1
    std::function<Real(const JointedScene&, int n)> error = {};
    std::vector<std::pair<Index, Index>> apart = {};  ///< bodies that do not collide

    Real h() const { return 1.0 / 60; }
};
using SharedTurning = std::shared_ptr<const TurningScene>;

/// A scene of the chapters before the joints.
inline JointedScene jointed(const RoughScene& scene)
{
    JointedScene all;
    static_cast<RoughScene&>(all) = scene;
    return all;
}

/// Keeps the worst of the errors of a run.
class WorstError {
public:
    explicit WorstError(const TurningScene& run) : run_(run) {}
    void look(const JointedScene& scene)
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
/// \param make  make() gives step(JointedScene&, std::int64_t& work, bool& solved): a new one remembers no step
template <class Make>
void add_turning_run(Registry& registry, const SharedTurning& run, const std::string& chapter,
                     const std::string& method, const std::string& parameters, bool quick, const Make& make)
{
    registry.add({chapter, method, run->name,
                  run->parameters + ' ' + parameters + " reference=" + run->reference, run->h(), quick, [=] {
                      const auto scene = std::make_shared<JointedScene>(run->scene);
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
void add_joints(Registry& registry);                                     ///< of bodies on joints
void add_rubble(Registry& registry);                                     ///< one step of heaps with friction
void add_turning_methods(Registry& registry, const SharedTurning& run);  ///< chapters 11 to 13
void add_joint_methods(Registry& registry, const SharedTurning& run);    ///< chapters 14 and 15
void add_turning_engines(Registry& registry, const SharedTurning& run);  ///< chapter 19, Box2D, Chipmunk

}  // namespace rigid::results
