/// \file collision_filter.hpp
/// Which pairs of bodies may collide at all. What may not is left out before anything is measured.
///
/// Three ways to say no. A group: bodies that carry the same number, and a table that says which groups meet; a
/// group that does not meet itself never makes a pair. A filter of each body's own, in place of groups, where there are many
/// (chapter 19). And single pairs, such as two discs on one rod, in a list that grows with the number of such pairs and not
/// with K².
#pragma once

#include "common/scenes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

inline constexpr int most_groups = 64;

//! [filter]
/// Which bodies meet. Two of the same group, if it is not 0, meet if it is positive and
/// do not if it is negative; all others if each is of a category that the other
/// looks for. Walls meet all.
struct Filter {
    std::uint64_t category = 1;               ///< bits
    std::uint64_t meets = ~std::uint64_t{0};  ///< the categories that it looks for
    std::int32_t group = 0;

    bool operator==(const Filter&) const = default;
};

inline bool lets_meet(const Filter& a, const Filter& b)
{
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.category & b.meets) != 0 && (b.category & a.meets) != 0;
}
//! [filter]

struct CollisionFilter {
    /// K numbers below most_groups; empty = all in group 0
    std::vector<std::uint8_t> group;
    /// bit g of meets[f]: the groups f and g collide
    std::array<std::uint64_t, most_groups> meets{};
    std::vector<Filter> filters;  ///< K, in place of groups; empty = groups
    /// K + 1: the partners of a are partner[first[a]] … partner[first[a + 1] − 1]
    std::vector<int> first;
    std::vector<int> partner;  ///< ascending for each a; all are > a

    CollisionFilter() { meets.fill(~std::uint64_t{0}); }

    int group_of(Index k) const
    {
        return group.empty() ? 0 : group[static_cast<std::size_t>(k)];
    }

    bool lets_meet(Index a, Index b) const
    {
        if (filters.empty())
            return (meets[static_cast<std::size_t>(group_of(a))] >> group_of(b) &
                    1) != 0;
        return rigid::lets_meet(filters[static_cast<std::size_t>(a)],
                                filters[static_cast<std::size_t>(b)]);
    }

    /// Says whether bodies of the groups f and g collide. \throws std::invalid_argument  if there is no such group
    void set_meets(int f, int g, bool yes);

    //! [forbids]
    /// True for a pair on the list, a < b. (Groups are looked at earlier, when the
    /// grid is queried.)
    bool forbids(Index a, Index b) const
    {
        if (first.empty()) return false;
        const auto begin = partner.begin() + first[static_cast<std::size_t>(a)];
        const auto end = partner.begin() + first[static_cast<std::size_t>(a) + 1];
        return begin != end && std::binary_search(begin, end, static_cast<int>(b));
    }
    //! [forbids]
};

/// A filter that forbids these pairs; an order in a pair, or a pair that is named twice, does not matter.
/// \param count  K
CollisionFilter forbid_pairs(Index count,
                             std::vector<std::pair<Index, Index>> pairs);

/// Discs on one rod don't collide.
inline CollisionFilter filter_of_links(Index count, std::span<const Link> links)
{
    std::vector<std::pair<Index, Index>> pairs;
    for (const Link& link : links) pairs.emplace_back(link.a, link.b);
    return forbid_pairs(count, std::move(pairs));
}

/// What the scene's `linked` says.
inline CollisionFilter filter_of(const DiscScene& scene)
{
    CollisionFilter filter =
        forbid_pairs(scene.bodies.count(), scene.linked.pairs());
    if (scene.linked.is_all()) filter.set_meets(0, 0, false);
    return filter;
}

}  // namespace rigid
