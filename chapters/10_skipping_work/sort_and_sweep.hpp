/// \file sort_and_sweep.hpp
/// Pairs of discs that can touch, by their shadows on one axis.
///
///     |x_b − x_a| ≤ r_a + r_b + margin   only if   left_b ≤ right_a,   for left = x − r, right = x + r + margin
///
/// Both ends are moved out by a few roundings, so that no pair at the very edge of the margin is lost. Sort by the left
/// ends, then run along: each disc meets those that begin before it ends \cite baraff1992 \cite cohen1995. The order is
/// kept: next time the list is nearly sorted, and insertion sort is done at once.
#pragma once

#include "common/math.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
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

/// Sorts what has shadows by their left ends, then calls visit(a, b) for each two whose
/// shadows meet.
/// \param known   the items are nearly sorted
/// \param left    Real(item), where its shadow begins; `right`, where it ends
/// \param memory  counts what is `tested` and `exchanged`
template <class Item, class Left, class Right, class Memory, class Visit>
void sweep_sorted(std::vector<Item>& items, bool known, const Left& left,
                  const Right& right, Memory& memory, const Visit& visit)
{
    const auto by_left = [&](const Item& a, const Item& b) {
        return left(a) < left(b);
    };
    memory.tested = memory.exchanged = 0;
    // stable: what std::sort does with equal ends is the library's own affair
    if (!known) std::stable_sort(items.begin(), items.end(), by_left);
    for (std::size_t i = 1; i < items.size(); ++i)  // nearly sorted: insert
        for (std::size_t j = i; j > 0 && by_left(items[j], items[j - 1]); --j) {
            std::swap(items[j], items[j - 1]);
            ++memory.exchanged;
        }
    //! [sweep]
    for (std::size_t i = 0; i < items.size(); ++i)
        for (std::size_t j = i + 1; j < items.size(); ++j) {
            if (left(items[j]) > right(items[i])) break;
            ++memory.tested;
            visit(items[i], items[j]);
        }
    //! [sweep]
}

/// Calls visit(a, b), a < b, for each pair of discs whose boxes, grown by the margin, overlap.
/// \param x       [m], 2K numbers
/// \param radius  [m], K numbers
/// \param axis    0 = along x, 1 = along y
template <class Visit>
void sort_and_sweep(const VecX& x, const VecX& radius, Real margin, int axis,
                    SortAndSweep& memory, const Visit& visit)
{
    using Shadow = SortAndSweep::Shadow;
    const auto K = static_cast<std::size_t>(radius.size());
    auto& shadows = memory.shadows;
    const bool known = shadows.size() == K;
    shadows.resize(K);
    for (std::size_t i = 0; i < K; ++i) {
        Shadow& s = shadows[i];
        if (!known) s.k = static_cast<int>(i);
        const Real along = x[2 * s.k + axis], r = radius[s.k];
        // of a number that is not infinite: infinity less that is infinity
        const Real rounding = 4 * std::numeric_limits<Real>::epsilon() *
                              std::min(std::abs(along) + r + margin,
                                       std::numeric_limits<Real>::max());
        s = {along - r - rounding, along + r + margin + rounding,
             x[2 * s.k + 1 - axis], r, s.k};
    }
    sweep_sorted(
        shadows, known, [](const Shadow& s) { return s.left; },
        [](const Shadow& s) { return s.right; }, memory,
        [&](const Shadow& a, const Shadow& b) {
            if (std::abs(a.other - b.other) < a.half + b.half + margin)
                visit(std::min(a.k, b.k), std::max(a.k, b.k));
        });
}

}  // namespace rigid
