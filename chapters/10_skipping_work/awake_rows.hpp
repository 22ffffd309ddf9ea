/// \file awake_rows.hpp
/// The first half of the step: who is awake, and their forces and rows. Nothing here looks at who sleeps.
#pragma once

#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/10_skipping_work/skipping_world.hpp"
#include "common/forces.hpp"

#include <array>

namespace rigid {

/// What has changed since the last step wakes whom it concerns. Costs the same however many sleep.
inline void wake_by_changes(SkippingWorld& now, const SkippingSettings& settings)
{
    require_step(settings.h);
    require_valid(settings.stabilizer);
    require_valid(settings.rest);
    if (!(settings.row_slack >= 0) || !std::isfinite(settings.row_slack))
        throw std::invalid_argument("row_slack is " + std::to_string(settings.row_slack) +
                                    " m; it must be zero or positive and finite");
    if (settings.stabilizer.method != Stabilizer::none && settings.stabilizer.method != Stabilizer::baumgarte)
        throw std::invalid_argument("the stabilizer is " +
                                    std::string(to_string(settings.stabilizer.method)) +
                                    "; this step knows none and baumgarte");
    if (settings.order != Order::given && settings.order != Order::coloured)
        throw std::invalid_argument("the order is " + std::string(to_string(settings.order)) +
                                    "; this step knows given and coloured");
    if (settings.pulled < world || settings.pulled >= now.scene.bodies.count())
        throw std::invalid_argument("the hand pulls disc " + std::to_string(settings.pulled) +
                                    "; there are discs 0 to " + std::to_string(now.scene.bodies.count() - 1));
    if (!settings.gravity.allFinite()) throw std::invalid_argument("gravity is not finite");
    if (settings.gravity != now.gravity || settings.stiffness != now.stiffness ||
        settings.damping != now.damping)
        for (Index k = 0; k < now.scene.bodies.count(); ++k) now.set.wake(k);  // this once
    now.gravity = settings.gravity;
    now.stiffness = settings.stiffness;
    now.damping = settings.damping;
    if (settings.pulled == world) return;
    now.set.wake(settings.pulled);
    now.rested[static_cast<std::size_t>(settings.pulled)] = 0;
}

/// Who was woken starts from the forces that it fell asleep with, and has to rest anew.
inline void get_up(SkippingWorld& now)
{
    remember_woken(now.forces, now.set.woken, now.cache);
    for (const int k : now.set.woken) now.rested[static_cast<std::size_t>(k)] = 0;
    now.counters.woken = static_cast<int>(now.set.woken.size());
    now.set.woken.clear();
    now.set.tidy();
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
    if (settings.pulled != world) add_pull(bodies, settings.pulled, settings.hand);
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

}  // namespace rigid
