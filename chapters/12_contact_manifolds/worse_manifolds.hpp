/// \file worse_manifolds.hpp
/// What this chapter's two points and their names are good for: the same stage with one of them left out.
#pragma once

#include "chapters/12_contact_manifolds/manifold_stage.hpp"

namespace rigid {

/// Of each pair only the deepest point.
struct OnePoint : Manifolds {
    template <class Method>
    void begin(const RigidScene& scene, const StepSettings& settings,
               Method& method, StepData<3>& now)
    {
        Manifolds::begin(scene, settings, method, now);
        std::vector<Contact> deepest;
        for (const Contact& c : now.contacts) {
            const bool same = !deepest.empty() && deepest.back().a == c.a &&
                              deepest.back().b == c.b &&
                              deepest.back().normal == c.normal;
            if (!same) deepest.push_back(c);
            else if (c.gap < deepest.back().gap) deepest.back() = c;
        }
        std::erase_if(now.sources, [](const Source& source) {
            return source.of == Source::Of::contact;
        });
        for (std::size_t i = 0; i < deepest.size(); ++i)
            now.sources.push_back({Source::Of::contact, static_cast<int>(i)});
        now.contacts.swap(deepest);
    }
};

/// A contact is called by its place in the list.
struct Nameless : Manifolds {
    template <class Method>
    void begin(const RigidScene& scene, const StepSettings& settings,
               Method& method, StepData<3>& now)
    {
        Manifolds::begin(scene, settings, method, now);
        for (std::size_t i = 0; i < now.contacts.size(); ++i)
            now.contacts[i].feature = static_cast<Index>(i);
    }
};

}  // namespace rigid
