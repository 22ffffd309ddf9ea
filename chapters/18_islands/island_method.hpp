/// \file island_method.hpp
/// The method of this chapter: chapter 15's that lets bodies sleep, with one stage replaced, the solver.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/15_trees/tree_method.hpp"
#include "chapters/18_islands/island_choice.hpp"

namespace rigid {

//! [method]
/// Chapter 15's `SkippingJoints`, with a solver for each island.
struct IslandMethod {
    WithLoadedLines<WithFriction<AwakeManifolds>> contacts;
    LoadedJoints correction;
    WarmStart start = last_impulses();
    IslandChoice solver;
};
//! [method]

struct IslandSettings {
    Solving solving = Solving::by_island;
    int substeps = 1;  ///< of the steps to come
    int sweeps = 60;   ///< over an island, at most
    bool sleep = true;

    bool operator==(const IslandSettings&) const = default;
};

/// Other settings from the next step on. Throws std::invalid_argument for fewer than one sub-step.
void change(IslandMethod& method, const IslandSettings& settings);

/// The method, ready for the steps of a scene: shapes look ahead, (12.14), and what hangs on joints is not stopped on
/// its way.
IslandMethod island_method(const JointedScene& scene,
                           const IslandSettings& settings = {});

/// What the last step cost, by (18.2) and (18.3) [entries, about a nanosecond each].
inline std::int64_t price_of_step(IslandMethod& method, const StepData<3>& now)
{
    return method.solver.all_entries() + price::visit * now.visits;
}

// Compiled once, in island_method.cpp.
extern template void step(JointedScene&, const StepSettings&, IslandMethod&,
                          StepData<3>&);

}  // namespace rigid
