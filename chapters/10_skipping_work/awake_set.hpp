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

    //! [wake]
    /// Wakes body k and its whole island; nothing if it is not asleep.
    void wake(Index k)
    {
        while (is_asleep(k)) {
            const auto i = static_cast<std::size_t>(k);
            activity[i] = Activity::awake;
            awake.push_back(static_cast<int>(k));
            woken.push_back(static_cast<int>(k));
            k = std::exchange(ring[i], static_cast<int>(k));
        }
    }
    //! [wake]

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
    void sleep(std::span<const int> members)
    {
        for (std::size_t i = 0; i < members.size(); ++i) {
            const auto k = static_cast<std::size_t>(members[i]);
            activity[k] = Activity::asleep;
            ring[k] = members[(i + 1) % members.size()];
        }
    }

    /// Makes the lists right again: only bodies that are awake, ascending, none twice. Linear where that is nearly so.
    void tidy()
    {
        std::erase_if(awake, [this](int k) { return !is_awake(k); });
        for (std::vector<int>* const list : {&awake, &woken}) {
            if (!std::is_sorted(list->begin(), list->end()))
                std::sort(list->begin(), list->end());
            list->erase(std::unique(list->begin(), list->end()), list->end());
        }
    }
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
