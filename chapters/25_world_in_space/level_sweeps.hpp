/// \file level_sweeps.hpp
/// The sweeps of cone_rows.hpp over several islands at once, L runs side by side: the same bits, sooner.
///
///     packet: L runs of one level and one shape; its rows lie one after the other, field by field, L numbers a field
///
/// A sweep reads packets, rows and discs from front to back.
#pragma once

#include "chapters/17_wide_sweeps/wide_rows.hpp"
#include "chapters/25_world_in_space/lane_cones.hpp"
#include "chapters/25_world_in_space/visit_levels.hpp"

#include <array>

namespace rigid {

//! [packet]
/// L runs, visited side by side.
template <int L>
struct RunPacket {
    RunKind kind = RunKind::plain;
    int items = 0;
    int row = 0;   ///< its first, in LevelSweeps::rows
    int disc = 0;  ///< in LevelSweeps::discs
    int live = 0;  ///< lanes whose islands are not done
    /// where the velocities of the two bodies are, in LevelSweeps::u; of an empty
    /// lane the packet's own place, which is no body's
    std::array<int, static_cast<std::size_t>(L)> a{}, b{};
    std::array<int, static_cast<std::size_t>(L)> island{};
};
//! [packet]

/// Where a row is: which row of the packets, and which lane.
struct LanePlace {
    int row = 0, lane = 0;
};

template <int L>
struct LevelSweeps {
    using V = Lanes<Real, L>;
    static constexpr auto lanes = static_cast<std::size_t>(L);

    VisitLevels levels;
    std::vector<RunPacket<L>> packets;
    std::vector<LaneBodies<V>> inverse;  ///< masses, of each packet
    std::vector<LaneRow<V>> rows;
    std::vector<LaneDisc<V>> discs;  ///< and rows that are bounded by themselves
    std::vector<std::array<LanePlace, lanes>>
        bounding;  ///< what bounds each of them
    /// two of each body, way and turn; then two of each packet
    std::vector<Slot<3, Real>> u;
    std::vector<LanePlace> place;  ///< of each row as the solver has them
    std::vector<char> off;         ///< of each island: the last sweep changed it
    Index bodies = 0;

    //! [arrange]
    /// Puts the runs of `levels` into packets, and all numbers into their lanes.
    /// \param from  all rows of the solver; feedback, discs likewise
    void arrange(const ConeRows& from, const Bodies<6>& all)
    {
        levels.sort();
        bodies = all.count();
        place.resize(from.rows.size());
        packets.clear();
        int row_count = 0, disc_count = 0;
        const LevelRun* last = nullptr;
        for (const int r : levels.order) {
            LevelRun& run = levels.runs[static_cast<std::size_t>(r)];
            if (!last || packets.back().live == L || run.level != last->level ||
                run.shape() != last->shape()) {
                RunPacket<L> packet{run.kind, run.items, row_count, disc_count};
                packet.a.fill(nobody(packets.size()));
                packet.b = packet.a;
                packets.push_back(packet);
                row_count += run.rows();
                if (run.kind != RunKind::plain) disc_count += run.items;
            }
            take_in(run, from.rows[static_cast<std::size_t>(run.first)]);
            last = &run;
        }
        rows.assign(static_cast<std::size_t>(row_count), LaneRow<V>{});
        discs.assign(static_cast<std::size_t>(disc_count), LaneDisc<V>{});
        bounding.assign(discs.size(), {});
        inverse.assign(packets.size(), LaneBodies<V>{});
        u.assign(2 * (static_cast<std::size_t>(bodies) + packets.size()), {});
        for (Index i = 0; i < all.u.size(); ++i) number(i) = all.u[i];
        off.assign(levels.first_run.size(), 0);
        for (const LevelRun& run : levels.runs) fill(run, from, all.inverse_mass);
    }
    //! [arrange]

    //! [sweep]
    /// One visit of each row and each disc of islands that are not done.
    /// \param small  a change of a row's velocity by less is none [m/s]
    void sweep(Real small)
    {
        std::fill(off.begin(), off.end(), char{0});
        for (std::size_t p = 0; p < packets.size(); ++p) {
            const RunPacket<L>& packet = packets[p];
            if (packet.live == 0) continue;
            LaneBodies<V> now;
            read(packet.a.data(), now.a), read(packet.b.data(), now.b);
            const auto changed = visit_packet(packet, inverse[p], V{} + small, now);
            write(now.a, packet.a.data()), write(now.b, packet.b.data());
            for (std::size_t i = 0; i < lanes; ++i)
                if (changed[i]) off[static_cast<std::size_t>(packet.island[i])] = 1;
        }
    }

    /// \return  in each lane, whether a row was off by more than `small`
    auto visit_packet(const RunPacket<L>& packet, const LaneBodies<V>& masses,
                      const V& small, LaneBodies<V>& now)
    {
        LaneRow<V>* row = rows.data() + packet.row;
        auto d = static_cast<std::size_t>(packet.disc);
        auto changed = V{} < V{};
        for (int i = 0; i < packet.items; ++i)
            if (packet.kind == RunKind::discs) {
                changed |=
                    ~(visit_disc(row, discs[d], radius(d), masses, now) <= small);
                row += 2, ++d;
            } else {
                V lo = row->lo, hi = row->hi;
                if (packet.kind == RunKind::bounded) hi = radius(d++), lo = -hi;
                const V change = visit(*row, lo, hi, masses, now);
                changed |= ~(size_of(change) <= small * row->mass);
                ++row;
            }
        return changed;
    }
    //! [sweep]

    //! [leave]
    /// An island is done. A packet that has no other is visited no more.
    void leave(int island)
    {
        auto r = static_cast<std::size_t>(
            levels.first_run[static_cast<std::size_t>(island)]);
        for (; r < levels.runs.size() && levels.runs[r].island == island; ++r)
            --packets[static_cast<std::size_t>(levels.runs[r].packet)].live;
    }
    //! [leave]

    /// λ of row k as the solver counts.
    Real lambda(std::size_t k) const
    {
        return lane(rows[static_cast<std::size_t>(place[k].row)].lambda,
                    place[k].lane);
    }
    /// Number i of all velocities, 6K.
    Real& number(Index i) { return u[static_cast<std::size_t>(i / 3)].u[i % 3]; }

private:
    int nobody(std::size_t packet) const
    {
        return 2 * (static_cast<int>(bodies) + static_cast<int>(packet));
    }

    /// The next lane of the last packet is this run's.
    void take_in(LevelRun& run, const SolverRow<6>& row)
    {
        RunPacket<L>& packet = packets.back();
        run.packet = static_cast<int>(packets.size()) - 1;
        run.lane = packet.live++;
        const auto i = static_cast<std::size_t>(run.lane);
        packet.a[i] = row.a / 3, packet.b[i] = row.b / 3;
        packet.island[i] = run.island;
        for (int n = 0; n < run.rows(); ++n)
            place[static_cast<std::size_t>(run.first + n)] = {packet.row + n,
                                                              run.lane};
    }

    void read(const int* at, LaneSix<V>& out) const
    {
        gather<3, Real, L>(u.data(), at, out.way);
        gather<3, Real, L>(u.data() + 1, at, out.turn);
    }
    void write(const LaneSix<V>& in, const int* at)
    {
        scatter<3, Real, L>(in.way, at, u.data());
        scatter<3, Real, L>(in.turn, at, u.data() + 1);
    }

    /// μ λ_n of each lane of a disc.
    V radius(std::size_t disc) const
    {
        V push{};
        for (std::size_t i = 0; i < lanes; ++i) {
            const LanePlace at = bounding[disc][i];
            push[i] = lane(rows[static_cast<std::size_t>(at.row)].lambda, at.lane);
        }
        return discs[disc].friction * at_least(push, V{});
    }

    void fill(const LevelRun& run, const ConeRows& from, const VecX& masses)
    {
        const auto first = static_cast<std::size_t>(run.first),
                   p = static_cast<std::size_t>(run.packet);
        const int l = run.lane;
        for (int d = 0; d < 6; ++d)
            write_lane(inverse[p].a[d], l, masses[from.rows[first].a + d]),
                write_lane(inverse[p].b[d], l, masses[from.rows[first].b + d]);
        for (int n = 0; n < run.rows(); ++n) {
            const SolverRow<6>& row =
                from.rows[first + static_cast<std::size_t>(n)];
            LaneRow<V>& out = rows[static_cast<std::size_t>(packets[p].row + n)];
            for (int d = 0; d < 6; ++d)
                write_lane(out.Ja[d], l, row.Ja[d]),
                    write_lane(out.Jb[d], l, row.Jb[d]);
            write_lane(out.bias, l, row.bias), write_lane(out.mass, l, row.mass);
            write_lane(out.lo, l, row.lo), write_lane(out.hi, l, row.hi);
            write_lane(out.lambda, l, row.lambda);
        }
        const int each = run.rows() / run.items;
        for (int n = 0; run.kind != RunKind::plain && n < run.items; ++n) {
            const std::size_t k = first + static_cast<std::size_t>(each * n),
                              d = static_cast<std::size_t>(packets[p].disc + n);
            write_lane(discs[d].friction, l, from.feedback[k].friction);
            bounding[d][static_cast<std::size_t>(l)] =
                place[static_cast<std::size_t>(from.bound_by(k))];
            if (const DiscOfRows* disc = from.disc(k)) {
                const Mat2& A = disc->A;
                write_lane(discs[d].a, l, A(0, 0)),
                    write_lane(discs[d].b, l, A(1, 1));
                write_lane(discs[d].c, l, A(0, 1));
                write_lane(discs[d].det, l, A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0));
                write_lane(discs[d].largest, l, disc->largest);
            }
        }
    }
};

}  // namespace rigid
