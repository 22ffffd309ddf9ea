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

/// What a step depends on besides the state and the cache. `carry` is not used: `share` says it for all substeps.
struct WarmStepSettings : StabilizedStepSettings {
    Start start = Start::yesterday;
    Real share = 1;  ///< σ, of yesterday's impulses that today starts from, 0 … 1; see (8.11)
    int keep = 0;    ///< steps that an impulse outlives its row
    MultipleRule multiple;  ///< of best_multiple: what may be taken instead of the best
};

/// What the step finds on its way, and what it remembers for the next one.
struct WarmStep : StabilizedStep {
    ImpulseCache cache;
    std::vector<ImpulseKey> keys;      ///< who the rows are
    std::vector<ImpulseKey> arranged;  ///< who they were when `order` and `groups` were found
    Start started = Start::cold;       ///< how the last step started
    BodyGroups groups;
    MultipleScratch multiple;
};

/// Throws std::invalid_argument, naming the setting and its value, unless what this chapter adds makes sense.
inline void require_valid(const WarmStepSettings& settings)
{
    if (!(settings.share >= 0 && settings.share <= 1))
        throw std::invalid_argument("share is " + std::to_string(settings.share) +
                                    "; it must be from 0 to 1");
    require_valid(settings.multiple);
    if (settings.keep < 0)
        throw std::invalid_argument("keep is " + std::to_string(settings.keep) +
                                    "; it must be zero or positive");
}

/// Who the rows of a scene of discs are, in their order: links, contacts, machines.
inline void disc_keys(std::size_t links, const std::vector<Contact>& contacts, std::size_t machines,
                      std::vector<ImpulseKey>& keys)
{
    keys.clear();
    for (std::size_t i = 0; i < links; ++i) keys.push_back(joint_key(i));
    for (const Contact& contact : contacts) keys.push_back(contact_key(contact));
    for (std::size_t i = 0; i < machines; ++i) keys.push_back(machine_key(i));
}

//! [start]
/// Where the sweeps of this substep start: now.solution.lambda is what was remembered, and becomes the guess.
inline void choose_start(const Bodies<2>& bodies, const WarmStepSettings& settings, bool same_rows,
                         WarmStep& now)
{
    VecX& lambda = now.solution.lambda;
    lambda *= settings.start == Start::cold ? 0 : settings.share;
    if (settings.start != Start::best_multiple) return;
    if (!same_rows) find_groups<2>(now.rows, bodies.inverse_mass, now.groups);
    best_multiple<2>(now.rows, bodies.inverse_mass, now.u_star, now.groups, now.multiple, lambda,
                     settings.multiple);
    now.visits += static_cast<std::int64_t>(now.rows.size());
}
//! [start]

//! [step]
/// One time step. Depends on its arguments alone.
inline void warm_step(DiscScene& scene, const WarmStepSettings& settings, WarmStep& now)
{
    require_valid(settings);
    find_step_contacts(scene, settings, now);
    const Real h = settings.h / settings.substeps;

    // Who is who; the order and the groups stay while the rows are those of yesterday.
    disc_keys(scene.links.size(), now.contacts, now.machines.size(), now.keys);
    const bool same_rows = now.keys == now.arranged && now.started == settings.start;
    now.ordered = same_rows && settings.order == Order::coloured && now.order.size() == now.keys.size();

    // Yesterday's answer is today's guess (8.4).
    if (settings.start != Start::cold) load(now.cache, now.keys, h, now.solution.lambda);

    for (int k = 0; k < settings.substeps; ++k) {
        substep_rows(scene, settings, h, now);
        choose_start(scene.bodies, settings, same_rows || k > 0, now);
        substep_solve(scene, settings, h, k + 1 == settings.substeps, now);  // chapter 7, word for word
    }

    now.cache.keep = settings.keep;
    store(now.cache, now.keys, now.solution.lambda, h);
    now.arranged = now.keys;
    now.started = settings.start;
}
//! [step]

}  // namespace rigid
