/// \file awake_set.hpp
/// The bodies that are awake, in a list, so that a step need not look at the others; and which of them wake together.
///
/// A sleeping island is a ring: each sleeper stores the number of the next one. To wake one of them is to go around the ring
/// once, and that costs as much as there are bodies to wake.
#pragma once

#include "common/bodies.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rigid {

enum class Activity : std::uint8_t {
    fixed,   ///< has no inverse mass and does not move
    awake,   ///< is in the list
    asleep,  ///< could move, and is at rest until something touches it
    gone,    ///< was taken out of the scene
};

struct AwakeSet {
    std::vector<Activity> activity;  ///< K
    std::vector<int> awake;          ///< ascending after tidy()
    /// K: of a sleeper, the next of its island; else itself
    std::vector<int> ring;
    /// since the caller last cleared it; may name one twice before tidy()
    std::vector<int> woken;

    bool is_awake(Index k) const
    {
        return activity[static_cast<std::size_t>(k)] == Activity::awake;
    }
    bool is_asleep(Index k) const
    {
        return activity[static_cast<std::size_t>(k)] == Activity::asleep;
    }

    /// Wakes body k and its whole island; nothing if it is not asleep.
    void wake(Index k);

    /// A new last body k = K − 1: awake if it can move, or does.
    template <int Dof>
    void add(const Bodies<Dof>& bodies, Index k)
    {
        const bool moves =
            bodies.inverse_mass.template segment<Dof>(Dof * k).maxCoeff() > 0 ||
            bodies.velocity(k).cwiseAbs().maxCoeff() > 0;
        activity.push_back(moves ? Activity::awake : Activity::fixed);
        ring.push_back(static_cast<int>(k));
        if (moves) awake.push_back(static_cast<int>(k));
        // as if it had just woken: its pairs are found
        woken.push_back(static_cast<int>(k));
        // Room for the worst case, so that no step has to allocate.
        awake.reserve(ring.capacity());
        woken.reserve(ring.capacity());
    }

    /// These bodies fall asleep together. Call tidy() after the last of such calls.
    void sleep(std::span<const int> members);

    /// Makes the lists right again: only bodies that are awake, ascending, none twice. Linear where that is nearly so.
    void tidy();
};

/// All that can move, or do, are awake.
template <int Dof>
AwakeSet everybody_awake(const Bodies<Dof>& bodies)
{
    AwakeSet set;
    for (Index k = 0; k < bodies.count(); ++k) set.add(bodies, k);
    set.woken.clear();
    return set;
}

}  // namespace rigid
