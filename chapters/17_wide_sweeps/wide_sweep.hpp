/// \file wide_sweep.hpp
/// The sweep: colour after colour, packet after packet, by one thread or by several.
///
/// Packets of one colour share no body that moves, so it makes no difference which thread visits which, nor when: the bits
/// are those of one thread. Between two colours all threads wait.
#pragma once

#include "chapters/17_wide_sweeps/team.hpp"
#include "chapters/17_wide_sweeps/wide_rows.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace rigid {

/// How far λ of row r of a packet may go beyond its bounds: μ λ_n.
template <int Dof, class T, int L>
inline Lanes<T, L> reach_of(const WideRow<Dof, Lanes<T, L>>* rows,
                            const RowShape* shapes, int r)
{
    Lanes<T, L> none{};
    if (shapes[r].bounding < 0) return none;
    const Lanes<T, L> normal = rows[shapes[r].bounding].lambda;
    // in differences λ_n may fall
    const Lanes<T, L> push = in_differences<T> ? normal : at_least(normal, none);
    return rows[r].friction * push;
}

/// Nothing is done beside a visit.
struct Nothing {
    void before(int, auto&, const RowShape&, const auto&) {}
    void after(int, const auto&) {}
    Nothing visits(const auto&) { return {}; }
    void note(std::size_t, const Nothing&) {}
};

//! [packet]
/// Visits all rows of a packet, one after the other, L bundles side by side.
/// \param excess     the largest |Δλ| − tolerance · mass so far: positive = a row
///                   was off by more than the tolerance
/// \param tolerance  [m/s]
/// \param beside     what is done .before() and .after() each visit
template <int Dof, class T, int L, class Beside = Nothing>
void visit_packet(const Packet<L>& packet, WideRow<Dof, Lanes<T, L>>* rows,
                  const RowShape* shapes,
                  const LaneMasses<Dof, Lanes<T, L>>& inverse, T tolerance,
                  Slot<Dof, T>* u, Lanes<T, L>& excess, Beside&& beside = {})
{
    using V = Lanes<T, L>;
    V ua[Dof], ub[Dof];
    gather<Dof, T, L>(u, packet.a.data(), ua);
    gather<Dof, T, L>(u, packet.b.data(), ub);
    for (int r = 0; r < packet.rows; ++r) {
        const V reach = reach_of<Dof, T, L>(rows, shapes, r);
        beside.before(r, rows[r], shapes[r], reach);
        const V change =
            wide_visit<Dof, V>(rows[r], shapes[r], reach, inverse, ua, ub);
        beside.after(r, rows[r]);
        const V off = size_of(change) - tolerance * rows[r].mass;
        excess = at_least(excess, off);
    }
    scatter<Dof, T, L>(ua, packet.a.data(),
                       u);  // b last: where one body moves, both are it
    scatter<Dof, T, L>(ub, packet.b.data(), u);
}
//! [packet]

/// A colour with fewer packets than this is visited by one thread: to wait for others would take longer.
constexpr int shared_packets = 64;

//! [sweep]
/// Visits each row once.
/// \param threads  that share the packets of a colour
/// \param beside   what is done beside the .visits() of a packet
/// \return         whether a row was found off by more than the tolerance
template <int Dof, class T, int L, class Beside = Nothing>
bool wide_sweep(WideRows<Dof, T, L>& all, T tolerance, int threads,
                Beside&& beside = {})
{
    std::array<T, most_threads> excess;
    excess.fill(T{0});
    auto work = [&](Member member) {
        Lanes<T, L> off{};
        bool alone = true;  // the colour before was visited by member 0
        for (std::size_t c = 0; c + 1 < all.colour_first.size(); ++c) {
            int first = all.colour_first[c], end = all.colour_first[c + 1];
            const bool shared = c < Bundles::rest && end - first >= shared_packets;
            if (shared || !alone) wait_for_team(member);
            alone = !shared;
            if (shared) std::tie(first, end) = member.share(first, end);
            else if (member.number > 0) continue;
            for (auto p = static_cast<std::size_t>(first);
                 p < static_cast<std::size_t>(end); ++p) {
                const Packet<L>& packet = all.packets[p];
                const auto row = static_cast<std::size_t>(packet.first);
                auto visits = beside.visits(packet);
                visit_packet<Dof, T, L>(packet, &all.rows[row], &all.shapes[row],
                                        all.inverse[p], tolerance, all.u.data(),
                                        off, visits);
                beside.note(p, visits);
            }
        }
        excess[static_cast<std::size_t>(member.number)] = largest<L>(off);
    };
    run_team(threads, work);
    return *std::max_element(excess.begin(), excess.end()) > 0;
}
//! [sweep]

/// The natural residual of all rows, (3.15), as they are in their lanes [m/s]: what a
/// visit of each, with these velocities, would change. NaN, if one of them is.
template <int Dof, class T, int L>
T wide_residual(const WideRows<Dof, T, L>& all)
{
    using V = Lanes<T, L>;
    const V none{};
    V most{}, finite{};  // NaN, where a number was none
    for (const Packet<L>& packet : all.packets) {
        V ua[Dof], ub[Dof];
        gather<Dof, T, L>(all.u.data(), packet.a.data(), ua);
        gather<Dof, T, L>(all.u.data(), packet.b.data(), ub);
        const auto* rows = &all.rows[static_cast<std::size_t>(packet.first)];
        const RowShape* shapes =
            &all.shapes[static_cast<std::size_t>(packet.first)];
        for (int r = 0; r < packet.rows; ++r) {
            const V reach = reach_of<Dof, T, L>(rows, shapes, r);
            const V lambda = wide_lambda<Dof, V>(rows[r], shapes[r], reach, ua, ub);
            const V off = size_of(lambda - rows[r].lambda) / rows[r].mass;
            const V here = rows[r].mass == none ? none : off;
            most = at_least(here, most);
            finite = finite + (here - here);
        }
    }
    T sum = largest<L>(most);
    for (int l = 0; l < L; ++l) sum += lane(finite, l);
    return sum;
}

/// What the λ that the rows begin with do to the velocities, in the order of the visits.
template <int Dof, class T, int L>
void apply_impulses(WideRows<Dof, T, L>& all)
{
    using V = Lanes<T, L>;
    for (std::size_t p = 0; p < all.packets.size(); ++p) {
        const Packet<L>& packet = all.packets[p];
        V ua[Dof], ub[Dof];
        gather<Dof, T, L>(all.u.data(), packet.a.data(), ua);
        gather<Dof, T, L>(all.u.data(), packet.b.data(), ub);
        for (int r = 0; r < packet.rows; ++r) {
            const auto& row = all.rows[static_cast<std::size_t>(packet.first + r)];
            add_impulse<Dof, V>(row, all.inverse[p], row.lambda, ua, ub);
        }
        scatter<Dof, T, L>(ua, packet.a.data(), all.u.data());
        scatter<Dof, T, L>(ub, packet.b.data(), all.u.data());
    }
}

/// Row numbers in the order in which a sweep visits them: lanes of a packet one after the other.
template <int Dof, class T, int L>
std::vector<int> visiting_order(const WideRows<Dof, T, L>& all)
{
    std::vector<int> order(all.place.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int i, int j) {
        const Place a = all.place[static_cast<std::size_t>(i)],
                    b = all.place[static_cast<std::size_t>(j)];
        return std::tie(a.row, a.lane) < std::tie(b.row, b.lane);
    });
    return order;
}

}  // namespace rigid
