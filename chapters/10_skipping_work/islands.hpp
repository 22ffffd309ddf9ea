/// \file islands.hpp
/// Bodies that push each other, directly or through others, are an island; different islands do not affect each
/// other, so their rows are separate problems.
///
///     A_ij = J_i M⁻¹ J_jᵀ = 0   for rows i, j of different islands:   A is block diagonal
///
/// (10.5). What cannot move passes nothing on, so it joins nothing. Found by union-find \cite tarjan1975, in time that
/// is linear in the rows and bodies that are awake. An island is numbered by its lowest body; rows keep their order.
#pragma once

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/06_sequential_impulse/row_order.hpp"
#include "common/union_find.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace rigid {

struct Islands {
    std::vector<int> rows;  ///< row numbers, island after island
    /// count() + 1: where the rows of each island begin
    std::vector<int> first_row;
    std::vector<int> bodies;      ///< island after island, ascending in each
    std::vector<int> first_body;  ///< count() + 1
    /// K: a step on the way to the lowest body of the island
    std::vector<int> parent;
    std::vector<int> number;  ///< K: of the body's island, as last found
    std::vector<int> next;    ///< where the next row or body goes

    int count() const { return static_cast<int>(first_body.size()) - 1; }
    std::span<const int> bodies_of(int i) const
    {
        return part(bodies, first_body, i);
    }
    std::span<const int> rows_of(int i) const { return part(rows, first_row, i); }

    /// the lowest body of k's island
    int find(int k) { return lowest_of(parent, k); }
    /// from now on a and b are of one island
    void unite(int a, int b) { rigid::unite(parent, a, b); }

    static int& at(std::vector<int>& list, int i)
    {
        return list[static_cast<std::size_t>(i)];
    }

private:
    static std::span<const int> part(const std::vector<int>& list,
                                     const std::vector<int>& first, int i)
    {
        const int begin = first[static_cast<std::size_t>(i)],
                  end = first[static_cast<std::size_t>(i) + 1];
        return {list.data() + begin, static_cast<std::size_t>(end - begin)};
    }
};

/// Each of these bodies is an island of its own.
/// \param count   K
/// \param bodies  bodies that may be joined, ascending
inline void separate(Index count, std::span<const int> bodies, Islands& islands)
{
    islands.parent.resize(static_cast<std::size_t>(count));
    islands.number.resize(static_cast<std::size_t>(count));
    for (const int k : bodies) Islands::at(islands.parent, k) = k;
}

//! [islands]
/// Joins the islands by rows and lists what is in each of them.
/// \param bodies   as given to separate(); between the two calls unite() may have
///                 joined some of them
/// \param rows     m rows; one that moves no body is in no island, and comes last in
///                 `islands.rows`
/// \param order    row numbers in the order that they are to have in their island;
///                 empty = as they are
/// \param islands  out; memory is kept
template <int Dof>
void join_by_rows(std::span<const int> bodies, const std::vector<Row<Dof>>& rows,
                  std::span<const int> order, Islands& islands)
{
    const auto mover = [](const Row<Dof>& row) {
        return static_cast<int>(moves_a(row)   ? row.a
                                : moves_b(row) ? row.b
                                               : Index{-1});
    };
    for (const Row<Dof>& row : rows)
        if (moves_a(row) && moves_b(row))
            islands.unite(static_cast<int>(row.a), static_cast<int>(row.b));

    // Number them: the lowest body comes first.
    int count = 0;
    for (const int k : bodies) {
        const int root = islands.find(k);
        Islands::at(islands.number, k) =
            root == k ? count++ : Islands::at(islands.number, root);
    }

    // Count, add up, fill in: first bodies, then rows.
    const auto sort_by_island = [&](std::size_t total, const auto& island_of,
                                    std::vector<int>& first,
                                    std::vector<int>& list) {
        first.assign(static_cast<std::size_t>(count) + 1, 0);
        for (std::size_t i = 0; i < total; ++i)
            if (const int island = island_of(i); island >= 0)
                ++Islands::at(first, island + 1);
        for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
        islands.next.assign(first.begin(), first.end());
        list.resize(static_cast<std::size_t>(first.back()));
        for (std::size_t i = 0; i < total; ++i)
            if (const int island = island_of(i); island >= 0)
                Islands::at(list, Islands::at(islands.next, island)++) =
                    static_cast<int>(i);
    };
    sort_by_island(
        bodies.size(),
        [&](std::size_t i) { return Islands::at(islands.number, bodies[i]); },
        islands.first_body, islands.bodies);
    for (int& i : islands.bodies) i = bodies[static_cast<std::size_t>(i)];
    const auto row_at = [&](std::size_t i) {
        return order.empty() ? i : static_cast<std::size_t>(order[i]);
    };
    sort_by_island(
        rows.size(),
        [&](std::size_t i) {
            const int k = mover(rows[row_at(i)]);
            return k < 0 ? -1 : Islands::at(islands.number, k);
        },
        islands.first_row, islands.rows);
    // what moves nothing is in no island, and comes last: each row has a place
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (mover(rows[row_at(i)]) < 0) islands.rows.push_back(static_cast<int>(i));
    for (int& i : islands.rows)
        i = static_cast<int>(row_at(static_cast<std::size_t>(i)));
}
//! [islands]

//! [colours]
/// Chapter 6's colours, for awake bodies alone: rows of one colour share no body
/// that can move.
/// \param bodies  the bodies that the rows may move; only their places in
///                memory.used are looked at
/// \param order   becomes the row numbers, colour by colour, those of one colour as
///                they came
template <int Dof>
void colour_rows_of(std::span<const int> bodies, Index count,
                    const std::vector<Row<Dof>>& rows, Colouring& memory,
                    std::vector<int>& order)
{
    memory.used.resize(static_cast<std::size_t>(count));
    for (const int k : bodies) memory.used[static_cast<std::size_t>(k)] = 0;
    colour_unused(rows, memory, order);
}
//! [colours]

/// The islands of a step: bodies that rows or torsional springs join.
/// \param order  of the rows in their island; empty = as they are
template <int Dof>
void find_islands(const Bodies<Dof>& bodies, const StepData<Dof>& now,
                  std::span<const int> order, Islands& islands)
{
    separate(bodies.count(), now.active, islands);
    // A torsional spring acts on three discs at once: they are of one island, whatever rows they have.
    for (const Bend& bend : now.bends) {
        const std::array<Index, 3> discs = {bend.left, bend.middle, bend.right};
        for (const Index a : discs)
            for (const Index b : discs)
                if (bodies.can_move(a) && bodies.can_move(b))
                    islands.unite(static_cast<int>(a), static_cast<int>(b));
    }
    join_by_rows<Dof>(now.active, now.rows, order, islands);
}

}  // namespace rigid
