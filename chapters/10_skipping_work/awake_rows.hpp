/// \file awake_rows.hpp
/// The first half of the step: who is awake, and their forces, rows and islands. Nothing here looks at who sleeps.
#pragma once

#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/10_skipping_work/skipping_world.hpp"
#include "common/forces.hpp"
#include "common/text.hpp"

#include <array>
#include <tuple>

namespace rigid {

/// Throws std::invalid_argument, naming the setting and its value, unless all of them make sense.
inline void require_valid(const SkippingSettings& settings, Index discs)
{
    const auto refuse = [](const std::string& sentence) { throw std::invalid_argument(sentence); };
    const auto at_least_zero = [&](const char* name, Real value) {
        if (!(value >= 0) || !std::isfinite(value))
            refuse(std::string(name) + " is " + shortest(value) + "; it must be zero or positive and finite");
    };
    require_step(settings.h);
    require_valid(settings.stabilizer);
    require_valid(settings.rest);
    at_least_zero("row_slack", settings.row_slack);
    at_least_zero("the tolerance of the sweeps", settings.sweeps.tolerance);
    at_least_zero("max_sweeps", settings.sweeps.max_sweeps);
    at_least_zero("the stiffness", settings.stiffness);
    at_least_zero("the damping", settings.damping);
    if (!settings.gravity.allFinite()) refuse("gravity is not finite");
    if (settings.stabilizer.method != Stabilizer::none && settings.stabilizer.method != Stabilizer::baumgarte)
        refuse("the stabilizer is " + std::string(to_string(settings.stabilizer.method)) +
               "; this step knows none and baumgarte");
    if (settings.order != Order::given && settings.order != Order::coloured)
        refuse("the order is " + std::string(to_string(settings.order)) +
               "; this step knows given and coloured");
    if (settings.pulled == world) return;
    if (settings.pulled < world || settings.pulled >= discs)
        refuse("the hand pulls disc " + std::to_string(settings.pulled) + " among " + std::to_string(discs));
    if (!settings.hand.allFinite()) refuse("the hand is at a place that is not finite");
}

/// True if who was at rest with the settings `a` is so with `b`. (The step h is not asked: rest is a balance of
/// forces. Nor are those that say how the balance is found.)
inline bool same_rest(const SkippingSettings& a, const SkippingSettings& b)
{
    const auto repay = [](const StabilizerSettings& s) {
        return std::tuple(s.method, s.beta, s.slop, s.bilateral_slop, s.fastest);
    };
    return a.gravity == b.gravity && a.stiffness == b.stiffness && a.damping == b.damping &&
           repay(a.stabilizer) == repay(b.stabilizer) && a.rest == b.rest && a.sleep == b.sleep;
}

/// What has changed since the last step wakes whom it concerns. Costs the same however many sleep.
inline void wake_by_changes(SkippingWorld& now, const SkippingSettings& settings)
{
    const Index K = now.scene.bodies.count();
    require_valid(settings, K);
    if (!same_rest(settings, now.last))
        for (Index k = 0; k < K; ++k) now.set.wake(k);  // this once
    now.last = settings;
    if (settings.pulled == world) return;
    now.set.wake(settings.pulled);
    now.rests[static_cast<std::size_t>(settings.pulled)] = {};
}

/// Who was woken starts from the forces that it fell asleep with, and has to rest anew.
inline void get_up(SkippingWorld& now)
{
    now.set.tidy();
    remember_woken(now.forces, now.set.woken, now.cache);
    for (const int k : now.set.woken) now.rests[static_cast<std::size_t>(k)] = {};
    now.counters.woken = static_cast<int>(now.set.woken.size());
    now.set.woken.clear();
    now.changed = true;
}

/// The links and bends of those who are awake: listed anew when that has changed.
inline void collect_active(SkippingWorld& now)
{
    if (!now.changed) return;
    const auto counts = [&](Index k) {
        return now.set.activity[static_cast<std::size_t>(k)] != Activity::gone;
    };
    const auto movable = [&](Index k) { return now.scene.bodies.inverse_mass[2 * k] > 0; };
    collect(now.links_on, now.set.awake, now.links);
    std::erase_if(now.links, [&](int i) {
        const Link& link = now.scene.links[static_cast<std::size_t>(i)];
        return !counts(link.a) || !counts(link.b) || !(movable(link.a) || movable(link.b));
    });
    collect(now.bends_on, now.set.awake, now.bends);
    now.active_bends.clear();
    for (const int i : now.bends) {
        const Bend& bend = now.scene.bends[static_cast<std::size_t>(i)];
        if (counts(bend.left) && counts(bend.middle) && counts(bend.right)) now.active_bends.push_back(bend);
    }
    now.changed = false;
}

/// Velocities u* after the forces, in memory.u, of those who are awake (3.4).
inline void awake_forces(SkippingWorld& now, const SkippingSettings& settings)
{
    Bodies<2>& bodies = now.scene.bodies;
    for (const int k : now.set.awake) {
        const Real inverse_mass = bodies.inverse_mass[2 * k];
        bodies.force(k) = inverse_mass > 0 ? Vec2(settings.gravity / inverse_mass) : Vec2(0, 0);
    }
    add_bend_springs(bodies, now.active_bends, settings.stiffness, settings.damping);
    if (settings.pulled != world && now.set.is_awake(settings.pulled))
        add_pull(bodies, settings.pulled, settings.hand);
    for (const int k : now.set.awake)
        now.memory.u.segment<2>(2 * k) =
            bodies.velocity(k) +
            settings.h * bodies.inverse_mass.segment<2>(2 * k).cwiseProduct(bodies.force(k));
}

/// C, J, b, bounds and keys: a row for each active link, then one for each contact. Where the rows are those of the
/// step before, one for one, a contact that has kept its normal keeps its row; only C and b are new (10.10).
inline void awake_rows(SkippingWorld& now, const SkippingSettings& settings, bool same_rows)
{
    const VecX& inverse_mass = now.scene.bodies.inverse_mass;
    const std::size_t links = now.links.size(), count = links + now.contacts.size();
    now.constraints.resize(count);
    if (!same_rows) {
        now.keys.clear();
        for (const int i : now.links) now.keys.push_back(joint_key(static_cast<std::size_t>(i)));
        for (const Contact& contact : now.contacts) now.keys.push_back(contact_key(contact));
    }
    for (std::size_t i = 0; i < links; ++i)
        now.constraints[i] =
            distance_constraint(now.scene.bodies.x, now.scene.links[static_cast<std::size_t>(now.links[i])]);
    if (!same_rows) {
        for (std::size_t i = links; i < count; ++i)
            now.constraints[i] = contact_constraint(now.contacts[i - links]);
        stabilized_rows<2>(now.constraints, links, inverse_mass, settings.stabilizer, settings.h, now.rows);
        return;
    }
    //! [kept_rows]
    for (std::size_t i = 0; i < count; ++i) {
        Constraint<2>& c = now.constraints[i];
        const bool kept = i >= links && now.kept.kept[i - links];
        if (kept) c.C = now.contacts[i - links].gap;
        else if (i >= links) c = contact_constraint(now.contacts[i - links]);
        const Real b = velocity_bias(c.C, i < links, settings.stabilizer, settings.h);
        if (kept) now.rows[i].bias = b;
        else now.rows[i] = i < links ? bilateral(c, inverse_mass, b) : unilateral(c, inverse_mass, b);
    }
    //! [kept_rows]
}

/// Who belongs together, and the order of the rows. While the rows are those of yesterday, so are the islands.
inline void find_islands(SkippingWorld& now, Order order, bool same_bodies)
{
    if (same_bodies && order == now.ordered && now.keys == now.arranged) return;
    const std::span<const int> bodies(now.set.awake);
    separate(now.scene.bodies.count(), bodies, now.islands);
    // A torsional spring acts on three discs at once: they are of one island, whatever rows they have.
    for (const Bend& bend : now.active_bends) {
        const std::array<Index, 3> discs = {bend.left, bend.middle, bend.right};
        for (const Index a : discs)
            for (const Index b : discs)
                if (now.scene.bodies.inverse_mass[2 * a] > 0 && now.scene.bodies.inverse_mass[2 * b] > 0)
                    now.islands.unite(static_cast<int>(a), static_cast<int>(b));
    }
    now.order.clear();
    if (order == Order::coloured)
        colour_rows_of<2>(bodies, now.scene.bodies.count(), now.rows, now.colouring, now.order);
    join_by_rows<2>(bodies, now.rows, now.order, now.islands);
    now.arranged = now.keys;
    now.ordered = order;
}

}  // namespace rigid
