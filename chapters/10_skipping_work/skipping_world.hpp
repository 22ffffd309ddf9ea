/// \file skipping_world.hpp
/// A scene of discs with all that is remembered from step to step, so that a step can leave out what needs nothing;
/// and the only doors through which a scene may be changed from outside, for each of them wakes whom it concerns.
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
    int exact_rows = 0;             ///< islands of up to so many rows are solved exactly
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
    DiscScene scene;  ///< read it; to change it, see below
    AwakeSet set;
    BroadPhase broad;
    Incidence links_on, bends_on;  ///< by body
    std::vector<Real> rested;      ///< K: how long each body has been at rest [s]
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
    Vec2 gravity = {0, 0};  ///< of the last step, and so on
    Real stiffness = 0, damping = 0;
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
        refuse("the margin is " + std::to_string(margin) + " m; it must be zero or positive and finite");
    if (!(skin >= 0) || !std::isfinite(skin))
        refuse("the skin is " + std::to_string(skin) + " m; it must be zero or positive and finite");
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
    now.rested.assign(K, 0);
    now.forces.head.assign(K, -1);
    now.memory.u = now.scene.bodies.u;
    return now;
}

inline void require_disc(const SkippingWorld& now, Index k)
{
    if (k < 0 || k >= now.scene.bodies.count())
        throw std::invalid_argument("there is no disc " + std::to_string(k) + "; they go from 0 to " +
                                    std::to_string(now.scene.bodies.count() - 1));
}

//! [doors]
/// Everybody within the margin of disc k, and who hangs on a link or a bend with it, wakes.
inline void wake_neighbours(SkippingWorld& now, Index k)
{
    const auto i = static_cast<int>(k);
    if (now.broad.grid.contains(i))
        now.broad.grid.near(now.broad.grid.position(i),
                            now.scene.radius[k] + now.broad.margin + 2 * now.broad.skin, ~std::uint64_t{0},
                            [&](int b) { now.set.wake(b); });
    for (const int l : now.links_on.of(i)) {
        const Link& link = now.scene.links[static_cast<std::size_t>(l)];
        now.set.wake(link.a == k ? link.b : link.a);
    }
    for (const int l : now.bends_on.of(i)) {
        const Bend& bend = now.scene.bends[static_cast<std::size_t>(l)];
        for (const Index b : {bend.left, bend.middle, bend.right}) now.set.wake(b);
    }
}

/// Gives a disc another place, velocity and mass, and wakes whom that concerns, where it was and where it is.
/// \param inverse_mass  [1/kg]; 0 makes it a fixed disc, or, with a velocity, one that moves and is not moved
inline void change_disc(SkippingWorld& now, Index k, const Vec2& x, const Vec2& u, Real inverse_mass)
{
    require_disc(now, k);
    if (!x.allFinite() || !u.allFinite() || !(inverse_mass >= 0) || !std::isfinite(inverse_mass))
        throw std::invalid_argument(
            "disc " + std::to_string(k) +
            " is to get a place, a velocity or a mass that is not finite or negative");
    now.set.wake(k);
    wake_neighbours(now, k);
    const auto i = static_cast<std::size_t>(k);
    if (now.set.activity[i] == Activity::gone) return;
    now.scene.bodies.position(k) = x;
    now.scene.bodies.velocity(k) = u;
    now.memory.u.segment<2>(2 * k) = u;
    now.scene.bodies.inverse_mass.segment<2>(2 * k).setConstant(inverse_mass);
    now.broad.grid.move(static_cast<int>(k), x);
    wake_neighbours(now, k);
    const bool moves = inverse_mass > 0 || u.squaredNorm() > 0;
    if (moves && !now.set.is_awake(k)) now.set.awake.push_back(static_cast<int>(k));
    now.set.activity[i] = moves ? Activity::awake : Activity::fixed;
    now.set.woken.push_back(static_cast<int>(k));  // as if it had just woken: its pairs are found anew
}

/// Takes a disc out of the scene, with its links. What stood on it wakes.
inline void take_away(SkippingWorld& now, Index k)
{
    require_disc(now, k);
    now.set.wake(k);
    wake_neighbours(now, k);
    const auto i = static_cast<std::size_t>(k);
    if (now.set.activity[i] == Activity::gone) return;
    now.broad.grid.remove(static_cast<int>(k));
    now.set.activity[i] = Activity::gone;
    now.set.woken.push_back(static_cast<int>(k));
}
//! [doors]

}  // namespace rigid
