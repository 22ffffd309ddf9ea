/// \file skipping_world.hpp
/// The method of this chapter, and a scene with all that is remembered from step to step, so that a step can leave out
/// what needs nothing.
///
///     awake bodies → contacts → u* → rows → islands → λ start → λ → u → x → sleep
///
/// Without sleeping and with the same sweeps its bits are those of chapter 8's method.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/07_baumgarte/correction.hpp"
#include "chapters/08_warm_starting/warm_start.hpp"
#include "chapters/10_skipping_work/by_islands.hpp"
#include "chapters/10_skipping_work/enter_awake.hpp"
#include "common/text.hpp"

#include <cstdint>
#include <vector>

namespace rigid {

//! [method]
struct SkippingMethod {
    AwakeBodies contacts;
    Correction correction;
    WarmStart start;
    IslandSolver<2> solver;
};
//! [method]

/// What a step depends on besides the world: the settings of all stages in one place.
struct SkippingSettings {
    Real h = 1.0 / 60;  ///< time step [s]
    int substeps = 1;   ///< the step is taken in so many parts
    /// k of the torsional springs, a pure number; see add_bend_springs()
    Real stiffness = 0;
    Real damping = 0;      ///< of the bends [1/s]
    Index pulled = world;  ///< the disc that a hand pulls; world = none
    Vec2 hand = {0, 0};    ///< where to [m]
    /// of each island; a tolerance of 0 makes all sweeps
    ImpulseSettings sweeps;
    /// what becomes of position errors; for rods in loops not `baumgarte`, see start
    StabilizerSettings stabilizer;
    Restitution bounce;
    /// where the sweeps start. The best multiple adds no energy whatever the scene
    /// if errors are corrected outside of the impulses, (8.15): `split_impulse`,
    /// `projection` or `none`. With a bias, as of `baumgarte`, nothing bounds it.
    Start start = Start::best_multiple;
    RestSettings rest;
    /// of the rows in their island: given or coloured
    Order order = Order::coloured;
    /// contacts keep their normal while their discs have moved by less [ℓ]
    Real row_slack = 0;
    /// islands of up to so many rows are solved exactly
    int exact_rows = 8;
    bool islands = true;  ///< false: all rows are one problem
    bool sleep = true;    ///< false: no body falls asleep
};

/// What a step has done. Each number is one of this step alone.
struct SkippingCounters {
    int awake = 0;    ///< bodies that the step looked at
    int islands = 0;  ///< of these, single bodies included
    int contacts = 0;
    int rows = 0;  ///< solved
    /// of these, kept from the step before but for C and b
    int kept_rows = 0;
    int sweeps = 0;           ///< of the island that needed the most
    int exact = 0;            ///< islands that were solved exactly
    int unsolved = 0;         ///< islands whose residual did not meet the tolerance
    int queries = 0;          ///< discs that queried the grid
    std::int64_t tested = 0;  ///< pairs of discs whose distance was computed
    std::int64_t visits = 0;  ///< rows visited
    int woken = 0;            ///< bodies
    int fell_asleep = 0;      ///< bodies
};

//! [world]
struct SkippingWorld {
    DiscScene scene;     ///< read it; to change it, see scene_edits.hpp
    Real margin = 0.02;  ///< a contact gets its row when its gap is below this [ℓ]
    SkippingMethod method;
    StepData<2> found;  ///< by the last step, on its way
    SkippingCounters counters;
};
//! [world]

/// \param filter  which pairs collide; see filter_of() for what the scene itself says
/// \param margin  as in StepSettings [ℓ]
/// \param skin    how far a disc may move before it queries the grid again [ℓ]; changes nothing but the time
/// \throws std::invalid_argument  for a scene or a filter that makes no sense
inline SkippingWorld make_world(DiscScene scene, CollisionFilter filter,
                                Real margin = 0.02, Real skin = 0.01)
{
    require_valid(scene);
    const auto K = static_cast<std::size_t>(scene.bodies.count());
    const auto refuse = [](const std::string& sentence) {
        throw std::invalid_argument(sentence);
    };
    if (!(margin >= 0) || !std::isfinite(margin))
        refuse("the margin is " + shortest(margin) +
               "; it must be zero or positive and finite");
    if (!(skin >= 0) || !std::isfinite(skin))
        refuse("the skin is " + shortest(skin) +
               "; it must be zero or positive and finite");
    if (!filter.group.empty() && filter.group.size() != K)
        refuse("there are " + std::to_string(filter.group.size()) + " groups for " +
               std::to_string(K) + " discs");
    if (!filter.filters.empty())
        refuse("there are " + std::to_string(filter.filters.size()) +
               " filters of single bodies; a world of discs knows groups only");
    for (const std::uint8_t group : filter.group)
        if (group >= most_groups)
            refuse("there is a group " + std::to_string(group) + "; they go to 63");
    if (!filter.first.empty() && filter.first.size() != K + 1)
        refuse("the filter was made for another number of discs than " +
               std::to_string(K));

    SkippingWorld now;
    now.scene = std::move(scene);
    now.margin = margin;
    const Real length = typical_length(now.scene);
    now.method.contacts.broad.margin = margin * length;
    now.method.contacts.broad.skin = skin * length;
    now.method.contacts.reset(now.scene, std::move(filter));
    return now;
}

/// The settings of a step, written into the stages.
inline StepSettings configure(SkippingMethod& method,
                              const SkippingSettings& settings, Real margin)
{
    method.contacts.rest = settings.rest;
    method.contacts.sleep = settings.sleep;
    method.contacts.row_slack = settings.row_slack;
    static_cast<StabilizerSettings&>(method.correction) = settings.stabilizer;
    static_cast<Restitution&>(method.correction) = settings.bounce;
    method.start.from = settings.start;
    method.solver.sweeps = settings.sweeps;
    method.solver.ordering = settings.order;
    method.solver.exact_rows = settings.exact_rows;
    method.solver.apart = settings.islands;
    StepSettings step;
    step.h = settings.h;
    step.substeps = settings.substeps;
    step.stiffness = settings.stiffness;
    step.damping = settings.damping;
    step.margin = margin;
    step.pulled = settings.pulled;
    step.hand = settings.hand;
    return step;
}

/// What the last step has done.
inline SkippingCounters counters_of(const SkippingMethod& method,
                                    const StepData<2>& found)
{
    const AwakeBodies& bodies = method.contacts;
    const IslandSolver<2>& solver = method.solver;
    SkippingCounters counters;
    counters.woken = bodies.woken;
    counters.fell_asleep = bodies.fell_asleep;
    if (found.active.empty()) return counters;
    counters.awake = static_cast<int>(found.active.size());
    counters.islands = solver.islands.count();
    counters.contacts = static_cast<int>(found.contacts.size());
    counters.rows = static_cast<int>(found.rows.size());
    counters.kept_rows = static_cast<int>(
        std::count(found.kept.begin(), found.kept.end(), std::uint8_t{1}));
    counters.sweeps = solver.most_sweeps;
    counters.exact = solver.exact_count;
    counters.unsolved = solver.unsolved;
    counters.queries = static_cast<int>(bodies.broad.queries);
    counters.tested = bodies.broad.tested;
    counters.visits = found.visits;
    return counters;
}

/// One time step of the world, and what it has done.
inline void skipping_step(SkippingWorld& now, const SkippingSettings& settings)
{
    step(now.scene, configure(now.method, settings, now.margin), now.method,
         now.found);
    now.counters = counters_of(now.method, now.found);
}

// Compiled once, in skipping_world.cpp.
extern template void step(DiscScene&, const StepSettings&, SkippingMethod&,
                          StepData<2>&);

}  // namespace rigid
