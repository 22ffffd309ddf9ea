/// \file incidence.hpp
/// Which links, or bends, hang on a body: so that a step finds those of the bodies that are awake without
/// looking at the others.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

namespace rigid {

struct Incidence {
    std::vector<int> first;  ///< K + 1
    std::vector<int> item;   ///< ascending for each body

    std::span<const int> of(int k) const
    {
        const auto i = static_cast<std::size_t>(k);
        return {item.data() + first[i],
                static_cast<std::size_t>(first[i + 1] - first[i])};
    }
};

/// \param bodies    K
/// \param items     number of links, or bends
/// \param for_each  for_each(i, visit) calls visit(k) for each body k of item i
template <class ForEach>
Incidence incidence(std::size_t bodies, std::size_t items, const ForEach& for_each)
{
    Incidence on;
    on.first.assign(bodies + 1, 0);
    for (std::size_t i = 0; i < items; ++i)
        for_each(i, [&](auto k) { ++on.first[static_cast<std::size_t>(k) + 1]; });
    for (std::size_t k = 0; k < bodies; ++k) on.first[k + 1] += on.first[k];
    on.item.resize(static_cast<std::size_t>(on.first.back()));
    std::vector<int> next(on.first.begin(), on.first.end() - 1);
    for (std::size_t i = 0; i < items; ++i)
        for_each(i, [&](auto k) {
            on.item[static_cast<std::size_t>(next[static_cast<std::size_t>(k)]++)] =
                static_cast<int>(i);
        });
    return on;
}

/// The items of these bodies, ascending, none twice. Memory is kept.
void collect(const Incidence& on, std::span<const int> bodies,
             std::vector<int>& items);

}  // namespace rigid
