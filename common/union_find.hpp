/// \file union_find.hpp
/// Which of many things hang together: each points to one of its set with a lower number, in the end to the lowest.
/// \cite tarjan1975
#pragma once

#include <cstddef>
#include <vector>

namespace rigid {

//! [find]
/// The lowest of k's set. On the way each is pointed one farther, so the next walk
/// is shorter.
template <class Number>
Number lowest_of(std::vector<Number>& parent, Number k)
{
    const auto up = [&parent](Number i) -> Number& {
        const auto place = static_cast<std::size_t>(i);
        return parent[place];
    };
    while (up(k) != k) k = up(k) = up(up(k));
    return k;
}

/// From now on a and b are of one set.
template <class Number>
void unite(std::vector<Number>& parent, Number a, Number b)
{
    a = lowest_of(parent, a);
    b = lowest_of(parent, b);
    if (a < b) parent[static_cast<std::size_t>(b)] = a;
    else parent[static_cast<std::size_t>(a)] = b;
}
//! [find]

}  // namespace rigid
