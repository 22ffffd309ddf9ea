/// \file collision_filter.hpp
/// Which pairs of bodies may collide at all. What may not is left out before anything is measured.
///
/// Two ways to say no. A group: bodies that carry the same number, and a table that says which groups meet; a
/// group that does not meet itself never makes a pair. And single pairs, such as two discs on one rod, in a list
/// that grows with the number of such pairs and not with K².
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

struct CollisionFilter {
    /// K numbers below most_groups; empty = all in group 0
    std::vector<std::uint8_t> group;
    /// bit g of meets[f]: the groups f and g collide
    std::array<std::uint64_t, most_groups> meets{};
    /// K + 1: the partners of a are partner[first[a]] … partner[first[a + 1] − 1]
    std::vector<int> first;
    std::vector<int> partner;  ///< ascending for each a; all are > a

    CollisionFilter() { meets.fill(~std::uint64_t{0}); }

    int group_of(Index k) const
    {
        return group.empty() ? 0 : group[static_cast<std::size_t>(k)];
    }

    /// Says whether bodies of the groups f and g collide. \throws std::invalid_argument  if there is no such group
    void set_meets(int f, int g, bool yes)
    {
        if (f < 0 || g < 0 || f >= most_groups || g >= most_groups)
            throw std::invalid_argument(
                "groups " + std::to_string(f) + " and " + std::to_string(g) +
                " cannot be distinguished; they go from 0 to " +
                std::to_string(most_groups - 1));
        const auto bit = [](int i) { return std::uint64_t{1} << i; };
        auto& of_f = meets[static_cast<std::size_t>(f)];
        auto& of_g = meets[static_cast<std::size_t>(g)];
        of_f = yes ? of_f | bit(g) : of_f & ~bit(g);
        of_g = yes ? of_g | bit(f) : of_g & ~bit(f);
    }

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
inline CollisionFilter forbid_pairs(Index count,
                                    std::vector<std::pair<Index, Index>> pairs)
{
    CollisionFilter filter;
    for (auto& [a, b] : pairs) {
        if (a < 0 || b < 0 || a >= count || b >= count || a == b)
            throw std::invalid_argument(
                "the pair of bodies " + std::to_string(a) + " and " +
                std::to_string(b) +
                " cannot be kept apart; there are bodies 0 to " +
                std::to_string(count - 1));
        if (a > b) std::swap(a, b);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    filter.first.assign(static_cast<std::size_t>(count) + 1, 0);
    for (const auto& [a, b] : pairs) {
        ++filter.first[static_cast<std::size_t>(a) + 1];
        filter.partner.push_back(static_cast<int>(b));
    }
    for (std::size_t k = 1; k < filter.first.size(); ++k)
        filter.first[k] += filter.first[k - 1];
    return filter;
}

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
