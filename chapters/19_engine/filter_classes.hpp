/// \file filter_classes.hpp
/// Filters of bodies as the groups of chapter 10: bodies with equal filters are one group, and a table says which groups
/// meet, so that a pair costs one bit to refuse.
#pragma once

#include "chapters/10_skipping_work/collision_filter.hpp"
#include "chapters/19_engine/definitions.hpp"

#include <array>

namespace rigid {

//! [classes]
struct FilterClasses {
    /// what meets nothing: a sensor, a place without a body
    static constexpr std::uint8_t nothing = 0;

    std::array<Filter, most_groups> filters{};
    std::array<int, most_groups> users{};  ///< bodies with this filter

    /// The group of a filter, with one body more in it.
    /// Throws std::invalid_argument if 63 other filters are in use.
    std::uint8_t enter(const Filter& filter, CollisionFilter& table)
    {
        int place = -1;
        for (int g = most_groups - 1; g > 0; --g) {
            const auto i = static_cast<std::size_t>(g);
            if (users[i] > 0 && filters[i] == filter) {
                ++users[i];
                return static_cast<std::uint8_t>(g);
            }
            if (users[i] == 0) place = g;
        }
        if (place < 0)
            throw std::invalid_argument(
                "the bodies of a world have 63 filters at most, and this one would "
                "be another; let some of them share one");
        const auto i = static_cast<std::size_t>(place);
        filters[i] = filter;
        users[i] = 1;
        table.set_meets(place, nothing, false);
        for (int g = 1; g < most_groups; ++g)
            if (users[static_cast<std::size_t>(g)] > 0)
                table.set_meets(
                    place, g,
                    lets_meet(filter, filters[static_cast<std::size_t>(g)]));
        return static_cast<std::uint8_t>(place);
    }
    /// The group of the new filter of a body of `group`. Throws as enter() does, and
    /// then nothing has changed.
    std::uint8_t change(std::uint8_t group, const Filter& filter,
                        CollisionFilter& table)
    {
        leave(group);  // first: it may be the only one with its filter
        try {
            return enter(filter, table);
        } catch (...) {
            if (group != nothing) ++users[group];
            throw;
        }
    }
    void leave(std::uint8_t group)
    {
        if (group != nothing) --users[group];
    }
};
//! [classes]

}  // namespace rigid
