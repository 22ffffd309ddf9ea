/// \file names_kept.hpp
/// How much of the impulses of a step finds its row again in the next one.
#pragma once

#include "chapters/08_warm_starting/warm_start.hpp"

namespace rigid {

/// Names and impulses of the contacts of one step.
struct NamedImpulses {
    std::vector<ImpulseCache::Entry> of;  ///< ascending

    void remember(const StepData<3>& now)
    {
        of.clear();
        for (std::size_t i = 0; i < now.sources.size(); ++i)
            if (now.sources[i].of == Source::Of::contact)
                of.push_back(
                    {.key = key_of(now.sources[i], now.contacts),
                     .lambda = now.solution.lambda[static_cast<Index>(i)]});
        std::sort(of.begin(), of.end(),
                  [](const auto& a, const auto& b) { return a.key < b.key; });
    }

    //! [share]
    /// Σ λ of those that are there again, divided by Σ λ; 1 if there was none.
    Real share_kept(const StepData<3>& now) const
    {
        Real all = 0, again = 0;
        std::vector<ImpulseKey> keys;
        for (const Source& source : now.sources)
            keys.push_back(key_of(source, now.contacts));
        std::sort(keys.begin(), keys.end());
        for (const ImpulseCache::Entry& entry : of) {
            all += entry.lambda;
            if (std::binary_search(keys.begin(), keys.end(), entry.key))
                again += entry.lambda;
        }
        return all > 0 ? again / all : 1;
    }
    //! [share]
};

}  // namespace rigid
