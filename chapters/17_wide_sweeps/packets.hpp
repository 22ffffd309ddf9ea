/// \file packets.hpp
/// Where the numbers of a wide sweep lie: bundles of one colour and one shape, L at a time.
///
///     colour 0: packet packet packet | colour 1: packet packet | …
///     packet:   row 0 of L bundles, row 1 of L bundles, …      each row field by field, L numbers a field
///
/// A sweep reads this memory from front to back. Only the velocities of the bodies are somewhere else.
#pragma once

#include "chapters/17_wide_sweeps/bundles.hpp"
#include "chapters/17_wide_sweeps/wide_visit.hpp"

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

//! [packet]
/// L bundles, visited side by side.
template <int L>
struct Packet {
    int first = 0;  ///< its rows, in WideRows::rows
    int rows = 0;
    int number = 0;  ///< how many of its colour and shape are before it
    /// where the velocities of the two bodies of each lane are, in WideRows::u
    std::array<int, static_cast<std::size_t>(L)> a{}, b{};
};

/// Where a row is: which row of which packets, and which lane. −1: nowhere, nothing
/// can move it.
struct Place {
    int row = -1, lane = 0;
};

/// All rows of a solve as the sweeps read them.
template <int Dof, class T, int L>
struct WideRows {
    using V = Lanes<T, L>;
    std::vector<Packet<L>> packets;
    std::vector<LaneMasses<Dof, V>> inverse;  ///< masses, of each packet
    /// where the packets of each colour begin; the rest comes last
    std::vector<int> colour_first;
    std::vector<WideRow<Dof, V>> rows;
    std::vector<RowShape> shapes;  ///< of each of them
    /// of each body; then one of its own for each empty lane
    std::vector<Slot<Dof, T>> u;
    std::vector<Place> place;  ///< of each row, by its number

    // What arrange() needs.
    std::vector<std::uint64_t> shape_of;  ///< of each bundle
    std::vector<std::uint64_t> known;     ///< shapes
    std::vector<int> kind_of, sorted, bins;
};
//! [packet]

//! [shape]
/// The shape of bundle g: of each row one more than the place of the row that bounds
/// it, in 4 bits, below a leading 1.
/// \throws std::invalid_argument  if a row is bounded by one of another bundle
template <int Dof>
std::uint64_t shape_of_bundle(const std::vector<Row<Dof>>& rows,
                              const Bundles& bundles, std::size_t g)
{
    std::uint64_t shape = 1;
    for (int k = bundles.first[g]; k < bundles.first[g + 1]; ++k) {
        const int i = bundles.rows[static_cast<std::size_t>(k)];
        const int n = rows[static_cast<std::size_t>(i)].bounded_by;
        int bounding = -1;
        for (int j = bundles.first[g]; n >= 0 && j < bundles.first[g + 1]; ++j)
            if (bundles.rows[static_cast<std::size_t>(j)] == n)
                bounding = j - bundles.first[g];
        if (n >= 0 && bounding < 0)
            throw std::invalid_argument("row " + std::to_string(i) +
                                        " is bounded by row " + std::to_string(n) +
                                        ", which is not one of the rows between "
                                        "the same two bodies; a wide "
                                        "sweep visits these together");
        shape = shape << 4 | static_cast<std::uint64_t>(bounding + 1);
    }
    return shape;
}
//! [shape]

/// A packet of zeros for bundles like g. Its lanes are empty: each has a body of its own that nothing moves.
/// \param nobody  the next such body
template <int Dof, class T, int L>
void begin_packet(const Bundles& bundles, std::size_t g,
                  const std::vector<Row<Dof>>& rows, int& nobody,
                  WideRows<Dof, T, L>& out)
{
    Packet<L> packet;
    packet.first = static_cast<int>(out.shapes.size());
    packet.rows = bundles.first[g + 1] - bundles.first[g];
    for (std::size_t i = 0; i < packet.a.size(); ++i)
        packet.a[i] = packet.b[i] = nobody++;
    out.packets.push_back(packet);
    for (int k = bundles.first[g]; k < bundles.first[g + 1]; ++k) {
        const int n = rows[static_cast<std::size_t>(
                               bundles.rows[static_cast<std::size_t>(k)])]
                          .bounded_by;
        RowShape shape;
        for (int j = bundles.first[g]; n >= 0 && j < bundles.first[g + 1]; ++j)
            if (bundles.rows[static_cast<std::size_t>(j)] == n)
                shape.bounding = j - bundles.first[g];
        out.shapes.push_back(shape);
    }
}

/// Where the velocities of bundle g's bodies are. If only one of them can move, both are that one, as in chapter 6:
/// what is written last is right.
template <int Dof, int L>
void set_bodies(const Bundles& bundles, std::size_t g, const Row<Dof>& row,
                std::size_t i, Packet<L>& packet)
{
    const auto [low, high] = bodies_of(row);
    const Movers moves = bundles.movers[g];
    packet.a[i] = static_cast<int>(moves.low ? low : high);
    packet.b[i] = static_cast<int>(moves.high ? high : low);
}

//! [arrange]
/// Puts the bundles into packets: colour by colour, and in a colour shape by shape,
/// by counting. Lanes that stay empty get a body of their own that nothing moves.
/// \param bodies  K
template <int Dof, class T, int L>
void arrange(const std::vector<Row<Dof>>& rows, Index bodies,
             const Bundles& bundles, WideRows<Dof, T, L>& out)
{
    constexpr std::size_t lanes = static_cast<std::size_t>(L);
    // shapes are few, so a list of them is enough
    const std::size_t count = bundles.count();
    out.known.clear();
    out.kind_of.resize(count);
    for (std::size_t g = 0; g < count; ++g) {
        const std::uint64_t shape = shape_of_bundle(rows, bundles, g);
        const auto found = std::find(out.known.begin(), out.known.end(), shape);
        out.kind_of[g] = static_cast<int>(found - out.known.begin());
        if (found == out.known.end()) out.known.push_back(shape);
    }
    const std::size_t kinds = out.known.size(), colours = Bundles::rest + 1;
    out.bins.assign(kinds * colours + 1, 0);
    const auto bin = [&](std::size_t g) {
        return static_cast<std::size_t>(bundles.colour[g]) * kinds +
               static_cast<std::size_t>(out.kind_of[g]);
    };
    for (std::size_t g = 0; g < count; ++g)
        if (bundles.colour[g] >= 0) ++out.bins[bin(g) + 1];
    std::partial_sum(out.bins.begin(), out.bins.end(), out.bins.begin());
    out.sorted.resize(static_cast<std::size_t>(out.bins.back()));
    for (std::size_t g = 0; g < count; ++g)
        if (bundles.colour[g] >= 0)
            out.sorted[static_cast<std::size_t>(out.bins[bin(g)]++)] =
                static_cast<int>(g);

    out.packets.clear();
    out.shapes.clear();
    out.colour_first.assign(1, 0);
    out.place.assign(rows.size(), Place{});
    int nobody = static_cast<int>(bodies);
    std::size_t used = lanes;  // of the last packet
    for (std::size_t n = 0; n < out.sorted.size(); ++n) {
        const auto g = static_cast<std::size_t>(out.sorted[n]);
        const auto last = static_cast<std::size_t>(out.sorted[n > 0 ? n - 1 : 0]);
        while (static_cast<int>(out.colour_first.size()) <= bundles.colour[g])
            out.colour_first.push_back(static_cast<int>(out.packets.size()));
        const bool alone = bundles.colour[g] == Bundles::rest,
                   goes_on = n > 0 && !alone && bin(g) == bin(last);
        if (used == lanes || !goes_on) {
            const int number = goes_on ? out.packets.back().number + 1 : 0;
            used = 0, begin_packet(bundles, g, rows, nobody, out);
            out.packets.back().number = number;
        }
        Packet<L>& packet = out.packets.back();
        for (int k = bundles.first[g]; k < bundles.first[g + 1]; ++k) {
            const int i = bundles.rows[static_cast<std::size_t>(k)];
            set_bodies(bundles, g, rows[static_cast<std::size_t>(i)], used, packet);
            out.place[static_cast<std::size_t>(i)] = {
                packet.first + k - bundles.first[g], static_cast<int>(used)};
        }
        ++used;
    }
    out.colour_first.push_back(static_cast<int>(out.packets.size()));
    out.rows.assign(out.shapes.size(), WideRow<Dof, Lanes<T, L>>{});
    out.inverse.assign(out.packets.size(), LaneMasses<Dof, Lanes<T, L>>{});
    out.u.assign(static_cast<std::size_t>(nobody), Slot<Dof, T>{});
}
//! [arrange]

}  // namespace rigid
