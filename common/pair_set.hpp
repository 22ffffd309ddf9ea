/// \file pair_set.hpp
/// Pairs of bodies, as a sorted list: its memory grows with the pairs and not with K².
#pragma once

#include "common/math.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace rigid {

class PairSet {
public:
    using Pair = std::pair<Index, Index>;  ///< the lower number first

    PairSet() = default;
    /// The order in a pair does not matter, nor does a pair that is named twice.
    explicit PairSet(std::vector<Pair> pairs) : pairs_(std::move(pairs))
    {
        for (Pair& pair : pairs_)
            if (pair.first > pair.second) std::swap(pair.first, pair.second);
        std::sort(pairs_.begin(), pairs_.end());
        pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    }

    /// Every pair that there is, whatever the number of bodies.
    static PairSet all()
    {
        PairSet set;
        set.all_ = true;
        return set;
    }

    bool is_all() const { return all_; }
    bool empty() const { return !all_ && pairs_.empty(); }
    void clear() { *this = {}; }
    const std::vector<Pair>& pairs() const { return pairs_; }  ///< ascending; not those of all()

    /// \param a, b  in any order
    bool contains(Index a, Index b) const
    {
        return all_ || std::binary_search(pairs_.begin(), pairs_.end(), Pair(std::min(a, b), std::max(a, b)));
    }

private:
    std::vector<Pair> pairs_;
    bool all_ = false;
};

}  // namespace rigid
