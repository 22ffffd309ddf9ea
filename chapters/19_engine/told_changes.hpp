/// \file told_changes.hpp
/// The watch of a scene whose owner reports what it changes: nothing is compared but what there is for all bodies.
///
/// Chapter 12's watch keeps a copy of the scene and compares each body in each step. Everything that a caller can change
/// in a World goes through a call of it, which has checked the new numbers and knows whose they are. So a step looks at
/// what was reported, and at nothing else of what sleeps.
#pragma once

#include "chapters/12_contact_manifolds/awake_manifolds.hpp"
#include "chapters/19_engine/asked_manifolds.hpp"

namespace rigid {

//! [told]
struct ToldChanges {
    using Scene = RigidScene;
    static constexpr bool is_told = true;
    std::vector<int> told;  ///< bodies, since the last step; may name one twice
    Index known = 0;        ///< bodies in the last step: others are new
    Surroundings around;

    /// Body k has been changed, or what it hangs on.
    void tell(Index k)
    {
        if (k < known) told.push_back(static_cast<int>(k));
    }
    //! [told]

    bool is_new() const { return known == 0; }
    /// Each call has checked what it was given.
    static void require(const RigidScene&) {}

    void remember(const RigidScene& scene)
    {
        told.clear();
        known = scene.bodies.count();
        if (around.differ(scene)) around.remember(scene);
    }

    /// What there is for all bodies is compared: it is little.
    bool all_concerned(const RigidScene& scene) const
    {
        return around.differ(scene);
    }

    /// Calls changed(k) for each body that was reported, and returns how many.
    template <class Changed>
    Index compare(const RigidScene&, const Changed& changed) const
    {
        for (const int k : told) changed(k);
        return static_cast<Index>(told.size());
    }
};

using ToldManifolds = AwakeStage<AskedManifolds, ToldChanges>;

}  // namespace rigid
