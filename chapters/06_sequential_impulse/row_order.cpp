// The functions of row_order.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/06_sequential_impulse/row_order.hpp"

namespace rigid {

int take_colour(std::uint64_t* a, std::uint64_t* b)
{
    constexpr std::uint64_t last = std::uint64_t{1} << (Colouring::most - 1);
    //! [greedy]
    // the last colour is never full
    const std::uint64_t taken = ((a ? *a : 0) | (b ? *b : 0)) & ~last;
    const int colour = std::countr_one(taken);
    const std::uint64_t bit = std::uint64_t{1} << colour;
    if (a) *a |= bit;
    if (b) *b |= bit;
    //! [greedy]
    return colour;
}

void shuffle_rows(std::size_t count, Random& random, std::vector<int>& order)
{
    order.resize(count);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = count; k-- > 1;)
        std::swap(order[k], order[static_cast<std::size_t>(
                                random.index(static_cast<Index>(k) + 1))]);
}

RIGID_ROW_ORDER(template, 2)
RIGID_ROW_ORDER(template, 3)
RIGID_ROW_ORDER(template, 6)

}  // namespace rigid
