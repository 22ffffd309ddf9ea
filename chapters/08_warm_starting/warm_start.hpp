/// \file warm_start.hpp
/// The start stage of the step: the sweeps begin with what is left of the answer of the step before.
///
/// It cannot change what the sweeps converge to, only how soon they are there.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/08_warm_starting/best_multiple.hpp"
#include "chapters/08_warm_starting/impulse_cache.hpp"
#include "common/text.hpp"

#include <string_view>

namespace rigid {

/// Where the sweeps start.
enum class Start {
    cold,      ///< λ = 0
    previous,  ///< the answer of the step before, or a part of it
    /// that answer times the multiple that fits this step best (8.12)
    best_multiple,
};

constexpr std::string_view to_string(Start start)
{
    switch (start) {
    case Start::cold:
        return "cold";
    case Start::previous:
        return "previous";
    case Start::best_multiple:
        return "best_multiple";
    }
    return "unknown";
}

/// Which row comes from this source.
template <class AnyContact>
ImpulseKey key_of(const Source& source, const std::vector<AnyContact>& contacts)
{
    const auto index = static_cast<std::size_t>(source.index);
    if (source.of == Source::Of::body)
        return {ImpulseKey::of_a_body, source.index, 0, source.part};
    return source.of == Source::Of::link ? link_key(index)
           : source.of == Source::Of::contact
               ? contact_key(contacts[index], source.part)
               : joint_key(index, source.part);
}

//! [warm_start]
struct WarmStart : PlainStart {
    Start from = Start::best_multiple;
    /// σ, the part of the previous impulses that the sweeps start from, 0 … 1; see
    /// (8.9)
    Real factor = 1;
    int keep = 0;       ///< steps that an impulse outlives its row
    MultipleRule rule;  ///< of best_multiple: what may be taken instead of the best

    // What is kept from step to step.
    ImpulseCache cache;
    std::vector<ImpulseKey> keys;      ///< of the rows
    std::vector<ImpulseKey> arranged;  ///< of those of the step before
    Start started = Start::cold;       ///< how the last step started
    BodyGroups groups;
    MultipleScratch multiple;

    /// λ of the rows that were there in the step before, (8.4).
    template <int Dof>
    void recall(const StepSettings& settings, StepData<Dof>& now)
    {
        keys.clear();
        for (const Source& source : now.sources)
            keys.push_back(key_of(source, now.contacts));
        now.same_rows = keys == arranged && started == from;
        if (from == Start::cold)
            now.solution.lambda.setZero(static_cast<Index>(keys.size()));
        else load(cache, keys, settings.part(), now.solution.lambda);
    }

    /// Where the sweeps of this sub-step start: λ is what was remembered, and
    /// becomes the guess.
    template <int Dof>
    void choose(const Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        VecX& lambda = now.solution.lambda;
        lambda *= from == Start::cold ? 0 : factor;
        if (from != Start::best_multiple) return;
        // the same rows may join others, once a body can move that could not
        if (now.substep == 0 && !(now.same_rows && now.same_bodies))
            find_groups<Dof>(now.rows, bodies.inverse_mass, groups);
        best_multiple<Dof>(now.rows, bodies.inverse_mass, now.u_star, groups,
                           multiple, lambda, rule);
        now.visits += static_cast<std::int64_t>(now.rows.size());
    }

    template <int Dof>
    void remember(const StepSettings& settings, const StepData<Dof>& now)
    {
        cache.keep = keep;
        store(cache, keys, now.solution.lambda, settings.part());
        arranged = keys;
        started = from;
    }
    ImpulseCache* impulses() { return &cache; }
    //! [warm_start]

    /// Throws std::invalid_argument, naming the setting and its value, unless all of them make sense.
    void require_valid() const;
};

}  // namespace rigid
