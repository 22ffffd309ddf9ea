/// \file box_sweep.hpp
/// Pairs of boxes that overlap, by chapter 10's sort and sweep: along x, in an order that is kept from step to step.
#pragma once

#include "chapters/12_contact_manifolds/placed_shape.hpp"

#include <algorithm>
#include <cstdint>

namespace rigid {

struct BoxSweep {
    std::vector<int> order;      ///< boxes by their left ends
    std::int64_t tested = 0;     ///< pairs whose shadows met
    std::int64_t exchanged = 0;  ///< neighbours that changed places
};

//! [box_sweep]
/// Calls visit(a, b), a < b, for each pair of boxes that overlap.
template <class Visit>
void overlapping_pairs(const std::vector<Box>& boxes, BoxSweep& memory,
                       const Visit& visit)
{
    auto& order = memory.order;
    const auto box = [&](int k) -> const Box& {
        return boxes[static_cast<std::size_t>(k)];
    };
    const auto by_left = [&](int a, int b) {
        return box(a).low.x() < box(b).low.x();
    };
    memory.tested = memory.exchanged = 0;
    if (order.size() != boxes.size()) {
        order.resize(boxes.size());
        for (std::size_t k = 0; k < order.size(); ++k)
            order[k] = static_cast<int>(k);
        // stable: what std::sort does with equal ends is the library's own affair
        std::stable_sort(order.begin(), order.end(), by_left);
    }
    for (std::size_t i = 1; i < order.size(); ++i)  // nearly sorted: insert
        for (std::size_t j = i; j > 0 && by_left(order[j], order[j - 1]); --j) {
            std::swap(order[j], order[j - 1]);
            ++memory.exchanged;
        }
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const Box &a = box(order[i]), &b = box(order[j]);
            if (b.low.x() > a.high.x()) break;
            ++memory.tested;
            if (overlap(a, b))
                visit(std::min(order[i], order[j]), std::max(order[i], order[j]));
        }
}
//! [box_sweep]

}  // namespace rigid
