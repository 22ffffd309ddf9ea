/// \file bundles.hpp
/// Which rows may be visited at the same time.
///
///     bundle    all rows between the same two bodies: their velocities are read once and written once
///     colour    bundles of one colour share no body that can move, so none of them waits for another
///
/// Chapter 6 colours rows one by one (6.15). With friction a contact of two points is four rows of the same two bodies,
/// which would need four colours; a bundle of them needs one.
#pragma once

#include "chapters/06_sequential_impulse/row_order.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace rigid {

/// Which of the two bodies of a bundle its rows can move.
struct Movers {
    bool low = false, high = false;

    bool operator==(const Movers&) const = default;
};

/// Rows in bundles, and the bundles in colours. Memory is kept from step to step.
struct Bundles {
    /// rows of a bundle; what is more becomes another bundle, between rows of which
    /// none bounds the other
    static constexpr int most_rows = 15;
    /// the last colour: bundles that found no free one, to be visited one by one
    static constexpr int rest = Colouring::most - 1;

    /// row numbers, bundle after bundle, those of a bundle as they came
    std::vector<int> rows;
    std::vector<int> first;  ///< where each bundle begins; one more for the end
    /// of each bundle; −1: neither body can move
    std::vector<int> colour;
    std::vector<int> of_row;  ///< the bundle of each row
    std::vector<Movers> movers;
    int colours = 0;  ///< the rest not counted

    // What the two functions below need.
    std::vector<int> sorted, bins;
    std::vector<std::uint64_t> used;  ///< as in Colouring
    std::vector<Movers> movers_now;

    std::size_t count() const { return first.size() - 1; }
};

/// The two bodies of a row: the one with the smaller number first, so the world always is.
template <int Dof>
std::pair<Index, Index> bodies_of(const Row<Dof>& row)
{
    return std::minmax(row.a, row.b);
}

//! [cut]
/// More rows of two bodies than a bundle has become several: a row that bounds
/// others stays with them.
/// \param from, to  places in out.rows; a bundle begins at the first
/// \throws std::invalid_argument  if a row bounds more of them than fit
template <int Dof>
void cut_bundle(const std::vector<Row<Dof>>& rows, std::size_t from, std::size_t to,
                Bundles& out)
{
    const auto set_of = [&](int i) {
        const int n = rows[static_cast<std::size_t>(i)].bounded_by;
        return n < 0 ? i : n;
    };
    const auto at = [&](std::size_t k) {
        return out.rows.begin() + static_cast<std::ptrdiff_t>(k);
    };
    std::stable_sort(at(from), at(to),
                     [&](int i, int j) { return set_of(i) < set_of(j); });
    std::size_t begin = from;
    for (std::size_t k = from, end = from; k < to; k = end) {
        while (end < to && set_of(*at(end)) == set_of(*at(k))) ++end;
        if (end > k + Bundles::most_rows)
            throw std::invalid_argument(
                "row " + std::to_string(set_of(*at(k))) + " bounds " +
                std::to_string(end - k - 1) + " rows; in a bundle there are " +
                std::to_string(Bundles::most_rows) + " in all");
        if (end - begin <= Bundles::most_rows) continue;
        std::sort(at(begin), at(k));  // as they came
        begin = k;
        out.first.push_back(static_cast<int>(k));
    }
    std::sort(at(begin), at(to));
}
//! [cut]

//! [bundle]
/// Sorts the rows by their two bodies, by counting: first by the second body, then,
/// keeping that order, by the first. One pass each, whatever the number of rows.
/// \param bodies  K
template <int Dof>
void bundle_rows(const std::vector<Row<Dof>>& rows, Index bodies, Bundles& out)
{
    const auto by = [&](const std::vector<int>& in, std::vector<int>& to,
                        const auto& key) {
        out.bins.assign(static_cast<std::size_t>(bodies) + 2, 0);
        for (const Row<Dof>& row : rows) ++out.bins[key(row) + 1];
        std::partial_sum(out.bins.begin(), out.bins.end(), out.bins.begin());
        to.resize(rows.size());
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const std::size_t i = in.empty() ? k : static_cast<std::size_t>(in[k]);
            to[static_cast<std::size_t>(out.bins[key(rows[i])]++)] =
                static_cast<int>(i);
        }
    };
    // the world, −1, comes first
    by({}, out.sorted, [](const Row<Dof>& row) {
        return static_cast<std::size_t>(bodies_of(row).second + 1);
    });
    by(out.sorted, out.rows, [](const Row<Dof>& row) {
        return static_cast<std::size_t>(bodies_of(row).first + 1);
    });

    out.first.clear();
    out.of_row.resize(rows.size());
    const auto row = [&](std::size_t n) -> const Row<Dof>& {
        return rows[static_cast<std::size_t>(out.rows[n])];
    };
    for (std::size_t k = 0, end = 0; k < rows.size(); k = end) {
        while (end < rows.size() && bodies_of(row(end)) == bodies_of(row(k))) ++end;
        out.first.push_back(static_cast<int>(k));
        if (end - k > Bundles::most_rows) cut_bundle(rows, k, end, out);
    }
    out.first.push_back(static_cast<int>(rows.size()));
    for (std::size_t g = 0; g < out.count(); ++g)
        for (int k = out.first[g]; k < out.first[g + 1]; ++k) {
            const int i = out.rows[static_cast<std::size_t>(k)];
            out.of_row[static_cast<std::size_t>(i)] = static_cast<int>(g);
        }
}
//! [bundle]

/// Which bodies of each bundle can move.
template <int Dof>
void find_movers(const std::vector<Row<Dof>>& rows, const Bundles& bundles,
                 std::vector<Movers>& movers)
{
    movers.assign(bundles.count(), Movers{});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row<Dof>& row = rows[i];
        Movers& moves = movers[static_cast<std::size_t>(bundles.of_row[i])];
        const bool a = row.a != world && !row.Wa.isZero(0), b = !row.Wb.isZero(0);
        moves.low |= row.a < row.b ? a : b;
        moves.high |= row.a < row.b ? b : a;
    }
}

/// Whether the same bodies can move as when the colours were given.
template <int Dof>
bool same_movers(const std::vector<Row<Dof>>& rows, Bundles& bundles)
{
    find_movers(rows, bundles, bundles.movers_now);
    return bundles.movers_now == bundles.movers;
}

//! [colours]
/// Chapter 6's greedy colours, for bundles: each takes the first colour that
/// neither of its bodies has. A body that cannot move does not count.
template <int Dof>
void colour_bundles(const std::vector<Row<Dof>>& rows, Index bodies, Bundles& out)
{
    out.used.assign(static_cast<std::size_t>(bodies), 0);
    out.colour.resize(out.count());
    out.colours = 0;
    find_movers(rows, out, out.movers);
    for (std::size_t g = 0; g < out.count(); ++g) {
        const auto [low, high] = bodies_of(rows[static_cast<std::size_t>(
            out.rows[static_cast<std::size_t>(out.first[g])])]);
        const Movers moves = out.movers[g];
        const auto used = [&](bool counts, Index body) {
            return counts ? &out.used[static_cast<std::size_t>(body)] : nullptr;
        };
        // what nothing moves is never visited
        const int colour =
            moves.low || moves.high
                ? take_colour(used(moves.low, low), used(moves.high, high))
                : -1;
        out.colour[g] = colour;
        if (colour < Bundles::rest) out.colours = std::max(out.colours, colour + 1);
    }
}
//! [colours]

/// To break it: everything has one colour, and lanes overwrite what others have written.
inline void forget_colours(Bundles& bundles)
{
    for (int& colour : bundles.colour) colour = std::min(colour, 0);
    bundles.colours = 1;
}

}  // namespace rigid
