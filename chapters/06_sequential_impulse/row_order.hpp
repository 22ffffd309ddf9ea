/// \file row_order.hpp
/// In which order a sweep visits the rows.
///
///     given        as they come
///     alternating  as they come, every second sweep backwards
///     shuffled     another random order in each step, from a seed
///     coloured     first all rows of colour 0, then of colour 1, …; rows of one colour share no body that can move
///
/// Two visits that share no body don't wait for each other, so the processor overlaps them: coloured rows are the
/// same code and the same work in less than half of the time.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "chapters/02_velocity_constraints/row_checks.hpp"
#include "common/random.hpp"

#include <bit>
#include <cstdint>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

namespace rigid {

enum class Order { given, alternating, shuffled, coloured };

constexpr std::string_view to_string(Order order)
{
    switch (order) {
    case Order::given:
        return "given";
    case Order::alternating:
        return "alternating";
    case Order::shuffled:
        return "shuffled";
    case Order::coloured:
        return "coloured";
    }
    return "unknown";
}

/// Memory of a colouring, kept from step to step.
struct Colouring {
    /// colours; rows that would need more share the last one
    static constexpr int most = 64;
    /// of each body: bit c is set if one of its rows has colour c
    std::vector<std::uint64_t> used;
    std::vector<int> colour;  ///< of each row
    /// where each colour begins in the order; one more for the end
    std::vector<int> start;
};

/// The first colour that neither of two bodies has; then both have it.
/// \param a, b  their used colours; null = the body cannot move
int take_colour(std::uint64_t* a, std::uint64_t* b);

//! [colour]
/// Greedy colouring: each row takes the first colour that neither of its bodies has
/// yet. One pass over the rows, and one to sort them by colour. Bodies that cannot
/// move are not counted: nothing can be overwritten there.
/// \param memory  `used` is zero for each body that the rows name
/// \param order   becomes the row numbers, colour by colour, those of one colour as
///                they came
template <int Dof>
void colour_unused(const std::vector<Row<Dof>>& rows, Colouring& memory,
                   std::vector<int>& order)
{
    memory.colour.resize(rows.size());
    memory.start.assign(Colouring::most + 1, 0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row<Dof>& row = rows[i];
        std::uint64_t* const a = row.a != world && !row.Wa.isZero(0)
                                     ? &memory.used[std::size_t(row.a)]
                                     : nullptr;
        std::uint64_t* const b =
            !row.Wb.isZero(0) ? &memory.used[std::size_t(row.b)] : nullptr;
        const int colour = take_colour(a, b);
        memory.colour[i] = colour;
        ++memory.start[static_cast<std::size_t>(colour) + 1];
    }
    std::partial_sum(memory.start.begin(), memory.start.end(),
                     memory.start.begin());
    order.resize(rows.size());
    // advances each start to the next one's
    for (std::size_t i = 0; i < rows.size(); ++i)
        order[static_cast<std::size_t>(
            memory.start[static_cast<std::size_t>(memory.colour[i])]++)] = int(i);
    for (std::size_t c = Colouring::most; c > 0; --c)
        memory.start[c] = memory.start[c - 1];
    memory.start[0] = 0;
}
//! [colour]

/// The same for rows between K bodies.
/// \param bodies  K
template <int Dof>
void colour_rows(const std::vector<Row<Dof>>& rows, Index bodies, Colouring& memory,
                 std::vector<int>& order)
{
    require_bodies<Dof>(rows, bodies);
    memory.used.assign(static_cast<std::size_t>(bodies), 0);
    colour_unused(rows, memory, order);
}

/// A random permutation of 0 … count − 1.
void shuffle_rows(std::size_t count, Random& random, std::vector<int>& order);

/// Fills `order` for a sweep over these rows; empty = as they are (also for `alternating`, which is a setting of
/// the sweeps). Does not allocate once it has seen a scene of this size.
/// \param bodies  K
/// \param random  used by `shuffled` alone
template <int Dof>
void order_rows(const std::vector<Row<Dof>>& rows, Index bodies, Order kind,
                Random& random, Colouring& memory, std::vector<int>& order)
{
    order.clear();
    if (kind == Order::coloured) colour_rows(rows, bodies, memory, order);
    if (kind == Order::shuffled) shuffle_rows(rows.size(), random, order);
}

// Compiled once, in row_order.cpp.
#define RIGID_ROW_ORDER(TEMPLATE, Dof)                                             \
    TEMPLATE void colour_unused(const std::vector<Row<Dof>>&, Colouring&,          \
                                std::vector<int>&);                                \
    TEMPLATE void colour_rows(const std::vector<Row<Dof>>&, Index, Colouring&,     \
                              std::vector<int>&);
RIGID_ROW_ORDER(extern template, 2)
RIGID_ROW_ORDER(extern template, 3)
RIGID_ROW_ORDER(extern template, 6)

}  // namespace rigid
