/// \file box_sweep.hpp
/// Pairs of boxes that overlap, by chapter 10's sort and sweep: along x, in an order that is kept from step to step.
#pragma once

#include "chapters/10_skipping_work/sort_and_sweep.hpp"
#include "chapters/12_contact_manifolds/placed_shape.hpp"

#include <cstdint>
#include <numeric>

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
    const bool known = order.size() == boxes.size();
    order.resize(boxes.size());
    if (!known) std::iota(order.begin(), order.end(), 0);
    const auto box = [&](int k) -> const Box& {
        return boxes[static_cast<std::size_t>(k)];
    };
    sweep_sorted(
        order, known, [&](int k) { return box(k).low.x(); },
        [&](int k) { return box(k).high.x(); }, memory,
        [&](int a, int b) {
            if (overlap(box(a), box(b))) visit(std::min(a, b), std::max(a, b));
        });
}
//! [box_sweep]

}  // namespace rigid
