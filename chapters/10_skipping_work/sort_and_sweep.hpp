/// \file sort_and_sweep.hpp
/// Pairs of discs that can touch, by their shadows on one axis.
///
///     |x_b − x_a| ≤ r_a + r_b + margin   only if   left_b ≤ right_a,   for left = x − r, right = x + r + margin
///
/// Sort by the left ends, then run along: each disc meets those that begin before it ends \cite baraff1992
/// \cite cohen1995. The order is kept: next time the list is nearly sorted, and insertion sort is done at once.
#pragma once

#include "common/math.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace rigid {

struct SortAndSweep {
    struct Shadow {
        Real left, right;  ///< [m]
        Real other;        ///< the other coordinate [m]
        Real half;         ///< radius [m]
        int k;
    };
    std::vector<Shadow> shadows;  ///< sorted by `left`
    std::int64_t tested = 0;      ///< pairs whose shadows met
    std::int64_t exchanged = 0;   ///< shadows that changed places while sorting
};

/// Calls visit(a, b), a < b, for each pair of discs whose boxes, grown by the margin, overlap.
/// \param x       [m], 2K numbers
/// \param radius  [m], K numbers
/// \param axis    0 = along x, 1 = along y
template <class Visit>
void sort_and_sweep(const VecX& x, const VecX& radius, Real margin, int axis,
                    SortAndSweep& memory, const Visit& visit)
{
    const auto K = static_cast<std::size_t>(radius.size());
    auto& shadows = memory.shadows;
    const auto by_left = [](const SortAndSweep::Shadow& a,
                            const SortAndSweep::Shadow& b) {
        return a.left < b.left;
    };
    const bool known = shadows.size() == K;
    shadows.resize(K);
    for (std::size_t i = 0; i < K; ++i) {
        SortAndSweep::Shadow& s = shadows[i];
        if (!known) s.k = static_cast<int>(i);
        const Real along = x[2 * s.k + axis];
        s = {along - radius[s.k], along + radius[s.k] + margin,
             x[2 * s.k + 1 - axis], radius[s.k], s.k};
    }
    memory.tested = memory.exchanged = 0;
    // stable: what std::sort does with equal ends is the library's own affair
    if (!known) std::stable_sort(shadows.begin(), shadows.end(), by_left);
    for (std::size_t i = 1; i < K; ++i)  // nearly sorted: insert
        for (std::size_t j = i; j > 0 && by_left(shadows[j], shadows[j - 1]); --j) {
            std::swap(shadows[j], shadows[j - 1]);
            ++memory.exchanged;
        }
    //! [sweep]
    for (std::size_t i = 0; i < K; ++i)
        for (std::size_t j = i + 1; j < K && shadows[j].left < shadows[i].right;
             ++j) {
            const SortAndSweep::Shadow &a = shadows[i], &b = shadows[j];
            ++memory.tested;
            const Real apart = std::abs(a.other - b.other);
            if (apart < a.half + b.half + margin)
                visit(std::min(a.k, b.k), std::max(a.k, b.k));
        }
    //! [sweep]
}

}  // namespace rigid
