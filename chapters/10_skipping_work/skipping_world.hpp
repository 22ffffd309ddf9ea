/// \file skipping_world.hpp
/// A scene of discs with all that is remembered from step to step, so that a step can leave out what needs nothing.
/// What is remembered is only true while nobody changes the scene behind the step's back: see doors.hpp.
#pragma once

#include "chapters/06_sequential_impulse/row_order.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"
#include "chapters/08_warm_starting/impulse_cache.hpp"
#include "chapters/10_skipping_work/broad_phase.hpp"
#include "chapters/10_skipping_work/exact_island.hpp"
#include "chapters/10_skipping_work/incidence.hpp"
#include "chapters/10_skipping_work/islands.hpp"
#include "chapters/10_skipping_work/kept_contacts.hpp"
#include "chapters/10_skipping_work/sleeping.hpp"
#include "common/scenes.hpp"
#include "common/text.hpp"

#include <cstdint>
#include <vector>

namespace rigid {

/// What a step depends on besides the world.
struct SkippingSettings {
    Real h = 1.0 / 60;              ///< time step [s]
    Vec2 gravity = {0, -9.81};      ///< [m/s²]
    Real stiffness = 0;             ///< k of the torsional springs, a pure number; see add_bend_springs()
    Real damping = 0;               ///< of the bends [1/s]
    Index pulled = world;           ///< the disc that a hand pulls; world = none
    Vec2 hand = {0, 0};             ///< where to [m]
    ImpulseSettings sweeps;         ///< of each island; a tolerance of 0 makes all sweeps
    StabilizerSettings stabilizer;  ///< none or baumgarte
    RestSettings rest;
    Order order = Order::coloured;  ///< of the rows in their island: given or coloured
    Real row_slack = 0;             ///< contacts keep their normal while their discs have moved by less [m]
    int exact_rows = 8;             ///< islands of up to so many rows are solved exactly
    bool warm = true;               ///< the sweeps start from yesterday's answer
    bool islands = true;            ///< false: all rows are one problem
    bool sleep = true;              ///< false: nobody falls asleep
};

/// What a step has done. Each number is one of this step alone.
struct SkippingCounters {
    int awake = 0;    ///< bodies that the step looked at
    int islands = 0;  ///< of these, single bodies included
    int contacts = 0;
    int rows = 0;             ///< solved
    int kept_rows = 0;        ///< of these, kept from the step before but for C and b
    int sweeps = 0;           ///< of the island that needed the most
    int exact = 0;            ///< islands that were solved exactly
    int unsolved = 0;         ///< islands whose residual did not meet the tolerance
    int asked = 0;            ///< discs that asked the grid
    std::int64_t tested = 0;  ///< pairs of discs whose distance was computed
    std::int64_t visits = 0;  ///< rows visited
    int woken = 0;            ///< bodies
    int fell_asleep = 0;      ///< bodies
};

//! [world]
struct SkippingWorld {
    DiscScene scene;  ///< read it; to change it, see doors.hpp
    AwakeSet set;
    BroadPhase broad;
    Incidence links_on, bends_on;  ///< by body
    std::vector<Rest> rests;       ///< K: how long each body has been at rest
    ImpulseCache cache;            ///< of those who are awake
    SleepingForces forces;         ///< of those who are asleep

    // What the last step found on its way.
    std::vector<int> links, bends;  ///< of those who are awake
    std::vector<Bend> active_bends;
    bool changed = true;  ///< who is awake has changed since `links` and `bends` were listed
    std::vector<Contact> contacts;
    KeptContacts kept;  ///< used where row_slack > 0
    std::vector<Constraint<2>> constraints;
    std::vector<Row<2>> rows;
    std::vector<ImpulseKey> keys, arranged;  ///< who the rows are, and who they were when islands were found
    Order ordered = Order::given;            ///< and how they were ordered then
    std::vector<int> order;
    Colouring colouring;
    Islands islands;
    ImpulseMemory<2> memory;
    std::vector<ExactScratch> exact;
    VecX lambda;  ///< one for each row [N s]
    SkippingCounters counters;
    SkippingSettings last;  ///< settings of the last step
};
//! [world]

/// \param filter  which pairs collide; see filter_of() for what the scene itself says
/// \param margin  [m], as in find_contacts()
/// \param skin    how far a disc may move before it asks the grid again [m]; changes nothing but the time
/// \throws std::invalid_argument  for a scene or a filter that makes no sense
inline SkippingWorld make_world(DiscScene scene, CollisionFilter filter, Real margin = 0.02, Real skin = 0.01)
{
    require_valid(scene);
    const auto K = static_cast<std::size_t>(scene.bodies.count());
    const auto refuse = [](const std::string& sentence) { throw std::invalid_argument(sentence); };
    if (!(margin >= 0) || !std::isfinite(margin))
        refuse("the margin is " + shortest(margin) + " m; it must be zero or positive and finite");
    if (!(skin >= 0) || !std::isfinite(skin))
        refuse("the skin is " + shortest(skin) + " m; it must be zero or positive and finite");
    if (!filter.group.empty() && filter.group.size() != K)
        refuse("there are " + std::to_string(filter.group.size()) + " groups for " + std::to_string(K) +
               " discs");
    for (const std::uint8_t group : filter.group)
        if (group >= most_groups) refuse("there is a group " + std::to_string(group) + "; they go to 63");
    if (!filter.first.empty() && filter.first.size() != K + 1)
        refuse("the filter was made for another number of discs than " + std::to_string(K));
    for (Index k = 0; k < scene.bodies.count(); ++k)
        if (scene.bodies.inverse_mass[2 * k] != scene.bodies.inverse_mass[2 * k + 1])
            refuse("disc " + std::to_string(k) + " has two different masses");

    SkippingWorld now;
    now.scene = std::move(scene);
    now.set = everybody_awake(now.scene.bodies);
    now.broad.margin = margin;
    now.broad.skin = skin;
    now.broad.reset(now.scene, std::move(filter));
    now.links_on = incidence(K, now.scene.links.size(), [&](std::size_t i, const auto& visit) {
        visit(now.scene.links[i].a);
        visit(now.scene.links[i].b);
    });
    now.bends_on = incidence(K, now.scene.bends.size(), [&](std::size_t i, const auto& visit) {
        visit(now.scene.bends[i].left);
        visit(now.scene.bends[i].middle);
        visit(now.scene.bends[i].right);
    });
    now.rests.assign(K, {});
    now.forces.head.assign(K, -1);
    now.memory.u = now.scene.bodies.u;
    return now;
}

}  // namespace rigid
