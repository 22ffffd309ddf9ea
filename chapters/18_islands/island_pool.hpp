/// \file island_pool.hpp
/// Solvers of one kind, as many as a step has islands for.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace rigid {

/// Islands that one kind of solver has in a step; keeps the memory of those that were.
template <class Island>
struct IslandPool {
    std::deque<Island> all;
    int count = 0;
    std::vector<int> place;  ///< of each island of the step here; −1

    void clear(int islands)
    {
        count = 0;
        place.assign(static_cast<std::size_t>(islands), -1);
    }
    Island& take(int island)
    {
        if (count == static_cast<int>(all.size())) all.emplace_back();
        place[static_cast<std::size_t>(island)] = count;
        return all[static_cast<std::size_t>(count++)];
    }
    Island* find(int island)
    {
        const int at = place[static_cast<std::size_t>(island)];
        return at < 0 ? nullptr : &all[static_cast<std::size_t>(at)];
    }
    template <class Visit>
    void for_each(const Visit& visit)
    {
        for (int i = 0; i < count; ++i) visit(all[static_cast<std::size_t>(i)]);
    }
};

}  // namespace rigid
