/// \file warm_step.hpp
/// The step of a scene of discs whose sweeps start from the answer of the step before.
///
///     forces → u* → contacts → λ start → C, J → rows (b, bounds) → λ → u → x
///
/// Chapter 7's step with one arrow more: between the contacts and the sweeps, the cache says where λ starts. It
/// cannot change what the sweeps converge to, only how soon.
#pragma once

#include "chapters/07_baumgarte/stabilized_step.hpp"
#include "chapters/08_warm_starting/impulse_cache.hpp"

namespace rigid {

/// What a step depends on besides the state and the cache.
struct WarmStepSettings : StabilizedStepSettings {
    bool from_yesterday = true;  ///< false: each step starts from λ = 0
    Real share = 1;              ///< of yesterday's impulse, 0 … 1, that today starts from
    int keep = 0;                ///< steps that an impulse outlives its row
};

/// What the step finds on its way, and what it remembers for the next one.
struct WarmStep : StabilizedStep {
    std::vector<ImpulseKey> keys;  ///< who the rows are
    ImpulseCache cache;
    VecX start;  ///< where λ started [N s]
};

/// One key for each link, then one for each contact: the order of the rows of a scene of discs.
inline void disc_keys(std::size_t links, const std::vector<Contact>& contacts, std::vector<ImpulseKey>& keys)
{
    keys.clear();
    for (std::size_t i = 0; i < links; ++i) keys.push_back(joint_key(i));
    for (const Contact& contact : contacts) keys.push_back(contact_key(contact));
}

//! [step]
/// One time step. Depends on its arguments alone.
inline void warm_step(DiscScene& scene, const WarmStepSettings& settings, WarmStep& now)
{
    const Real h = settings.h / settings.substeps;  // what the impulses belong to

    // Contacts, and under which names yesterday knew these rows.
    find_step_contacts(scene, settings, now);
    disc_keys(scene.links.size(), now.contacts, now.keys);

    // Yesterday's answer is today's guess (8.4).
    if (settings.from_yesterday) load(now.cache, now.keys, h, now.solution.lambda);
    now.solution.lambda *= settings.share;
    now.start = now.solution.lambda;

    // Chapter 7, word for word, and what it found is remembered.
    advance(scene, settings, now);
    now.cache.keep = settings.keep;
    store(now.cache, now.keys, now.solution.lambda, h);
}
//! [step]

}  // namespace rigid
