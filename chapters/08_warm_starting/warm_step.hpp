/// \file warm_step.hpp
/// The step of a scene of discs whose sweeps start from the answer of the step before.
///
///     forces → u* → contacts → C, J → rows (b, bounds) → order → λ start → λ → u → x
///
/// Chapter 7's step with one arrow more: the cache says where λ starts. It cannot change what the sweeps converge
/// to, only how soon they are there.
#pragma once

#include "chapters/06_sequential_impulse/row_order.hpp"
#include "chapters/07_baumgarte/stabilized_step.hpp"
#include "chapters/08_warm_starting/best_multiple.hpp"
#include "chapters/08_warm_starting/impulse_cache.hpp"

#include <string_view>

namespace rigid {

/// Where the sweeps start.
enum class Start {
    cold,           ///< λ = 0
    yesterday,      ///< the answer of the step before, or a share of it
    best_multiple,  ///< yesterday's times the multiple that fits today best (8.14)
};

constexpr std::string_view to_string(Start start)
{
    switch (start) {
    case Start::cold:
        return "cold";
    case Start::yesterday:
        return "yesterday";
    case Start::best_multiple:
        return "best_multiple";
    }
    return "unknown";
}

/// What a step depends on besides the state and the cache.
struct WarmStepSettings : StabilizedStepSettings {
    Start start = Start::yesterday;
    Real share = 1;              ///< σ, of yesterday's impulses that today starts from, 0 … 1; see (8.11)
    int keep = 0;                ///< steps that an impulse outlives its row
    Order order = Order::given;  ///< of the visits
};

/// What the step finds on its way, and what it remembers for the next one.
struct WarmStep : StabilizedStep {
    std::vector<ImpulseKey> keys;     ///< who the rows are
    std::vector<ImpulseKey> grouped;  ///< who they were when `groups` and a coloured order were found
    ImpulseCache cache;
    BodyGroups groups;
    MultipleScratch multiple;
    Colouring colouring;
    Random random{1};  ///< for a shuffled order
};

/// Throws std::invalid_argument, naming the setting and its value, unless what this chapter adds makes sense.
inline void require_valid(const WarmStepSettings& settings)
{
    if (!(settings.share >= 0 && settings.share <= 1))
        throw std::invalid_argument("share is " + std::to_string(settings.share) +
                                    "; it must be from 0 to 1");
    if (settings.keep < 0)
        throw std::invalid_argument("keep is " + std::to_string(settings.keep) +
                                    "; it must be zero or positive");
}

/// One key for each link, then one for each contact: the order of the rows of a scene of discs.
inline void disc_keys(std::size_t links, const std::vector<Contact>& contacts, std::vector<ImpulseKey>& keys)
{
    keys.clear();
    for (std::size_t i = 0; i < links; ++i) keys.push_back(joint_key(i));
    for (const Contact& contact : contacts) keys.push_back(contact_key(contact));
}

/// What depends on who the rows are, and on nothing else: done anew only when one has come or gone.
inline void arrange_rows(const DiscScene& scene, const WarmStepSettings& settings, WarmStep& now)
{
    const Bodies<2>& bodies = scene.bodies;
    const bool same_rows = now.keys == now.grouped;
    if (settings.order != Order::coloured || !same_rows || now.order.size() != now.rows.size())
        order_rows(now.rows, bodies.count(), settings.order, now.random, now.colouring, now.order);
    if (settings.start == Start::best_multiple && (!same_rows || now.groups.of_row.size() != now.rows.size()))
        find_groups<2>(now.rows, bodies.inverse_mass, now.groups);
    now.grouped = now.keys;
}

//! [step]
/// One time step. Depends on its arguments alone.
inline void warm_step(DiscScene& scene, WarmStepSettings settings, WarmStep& now)
{
    require_valid(settings);
    settings.sweeps.alternate = settings.order == Order::alternating;

    // Contacts, under the names that yesterday knew them by; yesterday's answer is today's guess (8.4).
    find_step_contacts(scene, settings, now);
    const Real h = settings.h / settings.substeps;  // what the impulses belong to
    disc_keys(scene.links.size(), now.contacts, now.keys);
    if (settings.start != Start::cold) load(now.cache, now.keys, h, now.solution.lambda);

    for (int k = 0; k < settings.substeps; ++k) {
        substep_rows(scene, settings, h, now);
        if (k == 0) arrange_rows(scene, settings, now);

        now.solution.lambda *= settings.start == Start::cold ? 0 : settings.share;
        if (settings.start == Start::best_multiple) {
            best_multiple<2>(now.rows, scene.bodies.inverse_mass, now.u_star, now.groups, now.multiple,
                             now.solution.lambda);
            now.visits += static_cast<std::int64_t>(now.rows.size());
        }

        substep_solve(scene, settings, h, now);  // chapter 7, word for word
    }

    now.cache.keep = settings.keep;
    store(now.cache, now.keys, now.solution.lambda, h);
}
//! [step]

}  // namespace rigid
