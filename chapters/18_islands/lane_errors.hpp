/// \file lane_errors.hpp
/// What rows in lanes are off by while bodies move: of contacts and limits the gap, of joints all of it. J of contacts and pins
/// goes along.
#pragma once

#include "chapters/13_friction/friction_rows.hpp"
#include "chapters/17_wide_sweeps/wide_solver.hpp"
#include "chapters/18_islands/lane_contacts.hpp"
#include "chapters/18_islands/turning_pins.hpp"

namespace rigid {

/// What a small step asks of a row besides J u: its C, and what it gives back.
template <class V>
struct LaneError {
    int row = 0, packet = 0;  ///< of the lanes
    V begin{};                ///< C₀ [m, rad]
    V C{};                    ///< where the bodies are [m, rad]
    V slop{};                 ///< s/2 [m]
    /// 1: of a contact's normal or a limit; −1: of what a joint holds, but for pins
    V kind{};
    V rate{};  ///< J u of what nothing moves, and b of what has no error [m/s]
    LaneContact<V> contact;
};

/// What goes out of an overlap: so much of it a second, no faster than this [1/s, m/s].
struct LanePush {
    Real per_second = 0, fastest = 0;
};

/// Those of all rows of one heap that can be off.
class LaneErrors {
    static constexpr int lanes = full_lanes<Real>;
    using V = Lanes<Real, lanes>;
    using Wide = WideRows<3, Real, lanes>;

    template <class Lanes>
    static auto& row_at(Lanes& wide, int i)
    {
        return wide.rows[static_cast<std::size_t>(i)];
    }
    template <class Lanes>
    static auto* drag_of(const LaneContact<V>& contact, Lanes& wide)
    {
        return contact.drag < 0 ? nullptr : &row_at(wide, contact.drag);
    }

public:
    std::vector<LaneError<V>> rows;  ///< packet after packet
    TurningPins<lanes> pins;

    /// \param left_alone  s/2 of a constraint [m]
    /// \param whole  the step; row i of the lanes is its row of[i]
    template <class LeftAlone>
    void put_in(const LeftAlone& left_alone, const StepData<3>& whole,
                const StepPart& part, const Wide& wide)
    {
        const std::vector<int>& of = part.rows;
        pins.find(whole, of, wide);
        gone_.assign(wide.u.size(), {});
        elapsed_ = 0;
        number_.assign(wide.rows.size(), -1);
        const auto error_of = [&](std::size_t i) {
            return wide.place[i].row >= 0 &&
                   has_error(
                       whole.constraints[static_cast<std::size_t>(of[i])].kind) &&
                   !pins.has(wide.place[i].row, wide.place[i].lane);
        };
        for (std::size_t i = 0; i < of.size(); ++i)
            if (error_of(i))
                number_[static_cast<std::size_t>(wide.place[i].row)] = 0;
        rows.clear();
        first_.clear();
        for (std::size_t p = 0; p < wide.packets.size(); ++p) {
            const Packet<lanes>& packet = wide.packets[p];
            first_.push_back(rows.size());
            for (int r = packet.first; r < packet.first + packet.rows; ++r) {
                const auto at = static_cast<std::size_t>(r);
                if (number_[at] < 0) continue;
                number_[at] = static_cast<int>(rows.size());
                LaneError<V>& error = rows.emplace_back();
                error.row = r, error.packet = static_cast<int>(p);
                error.rate = wide.rows[at].bias;
            }
        }
        first_.push_back(rows.size());
        for (std::size_t i = 0; i < of.size(); ++i) {
            if (!error_of(i)) continue;
            const auto [row, lane] = wide.place[i];
            const Constraint<3>& c =
                whole.constraints[static_cast<std::size_t>(of[i])];
            LaneError<V>& error = rows[static_cast<std::size_t>(
                number_[static_cast<std::size_t>(row)])];
            write_lane(error.begin, lane, c.C);
            write_lane(error.C, lane, c.C);
            write_lane(error.slop, lane, left_alone(c));
            const bool is_gap = c.kind == ConstraintKind::unilateral;
            write_lane(error.kind, lane, is_gap ? 1 : -1);
            const Source& source = whole.sources[static_cast<std::size_t>(of[i])];
            if (source.of != Source::Of::contact) continue;
            const Packet<lanes>& packet =
                wide.packets[static_cast<std::size_t>(error.packet)];
            const auto l = static_cast<std::size_t>(lane);
            write_contact(whole.contacts[static_cast<std::size_t>(source.index)],
                          whole, part, part.now.rows[i], {packet.a[l], packet.b[l]},
                          lane, error.contact);
        }
        for (std::size_t i = 0; i < of.size(); ++i) find_drag(i, whole, part, wide);
        for (LaneError<V>& error : rows)
            if (error.contact.some)
                begin_contact(row_at(wide, error.row), drag_of(error.contact, wide),
                              error.contact);
    }

    //! [biases]
    /// The bodies go on with the velocities that they have, for h.
    void follow(const std::vector<int>& active, Real h, Wide& wide)
    {
        for (const int k : active)
            for (int d = 0; d < 3; ++d)
                gone_[static_cast<std::size_t>(k)].u[d] +=
                    h * wide.u[static_cast<std::size_t>(k)].u[d];
        elapsed_ += h;
        pins.turn(h, wide);
    }
    /// C of the rows of a packet where the bodies are by then, and J of contacts
    void look(std::size_t p, Wide& wide)
    {
        if (first_[p] == first_[p + 1]) return;
        V xa[3], xb[3];
        gather<3, Real, lanes>(gone_.data(), wide.packets[p].a.data(), xa);
        gather<3, Real, lanes>(gone_.data(), wide.packets[p].b.data(), xb);
        for (std::size_t i = first_[p]; i < first_[p + 1]; ++i) {
            LaneError<V>& error = rows[i];
            const auto& row = row_at(wide, error.row);
            error.C = error.begin + error.rate * (V{} + elapsed_);
            for (int d = 0; d < 3; ++d)
                error.C = error.C + row.Ja[d] * xa[d] + row.Jb[d] * xb[d];
            if (error.contact.some) turn(error, xa, xb, wide);
        }
    }
    /// (18.4b) for them: a gap may close, and an overlap goes out.
    void set_biases(const LanePush& push, Real h, std::size_t p, Wide& wide) const;
    //! [biases]

    /// How far body k has gone since the step began [m, rad]
    Vec<3> gone(int k) const
    {
        const auto& by = gone_[static_cast<std::size_t>(k)].u;
        return {by[0], by[1], by[2]};
    }

    /// The most that a joint is off by [m, rad]
    Real open_by() const
    {
        V open{};
        for (const LaneError<V>& error : rows)
            open = at_least(-error.kind * size_of(error.C), open);
        return std::max(largest<lanes>(open), pins.open_by());
    }

private:
    /// \param xa, xb  Δx of what impulses move
    void turn(LaneError<V>& error, const V (&xa)[3], const V (&xb)[3],
              Wide& wide) const
    {
        const LaneContact<V>& at = error.contact;
        V x1[3];
        for (int d = 0; d < 3; ++d) x1[d] = at.both * xa[d] + at.u[d] * elapsed_;
        const TurnedContact<V> now(at, x1, xb);
        const V rate =
            turn_rows(at, now, wide.inverse[static_cast<std::size_t>(error.packet)],
                      row_at(wide, error.row), drag_of(at, wide));
        error.C = at.is > V{} ? V(error.begin + now.C) : error.C;
        error.rate = at.is > V{} ? rate : error.rate;
    }

    /// Finds the contact of row i of the part, if that is one of friction.
    void find_drag(std::size_t i, const StepData<3>& whole, const StepPart& part,
                   const Wide& wide)
    {
        const Source& source =
            whole.sources[static_cast<std::size_t>(part.rows[i])];
        const auto [row, lane] = wide.place[i];
        const int normal = part.now.rows[i].bounded_by;
        if (row < 0 || source.of != Source::Of::contact ||
            source.part != tangent_part || normal < 0)
            return;
        const int number = number_[static_cast<std::size_t>(
            wide.place[static_cast<std::size_t>(normal)].row)];
        if (number < 0) return;  // it has no C
        LaneContact<V>& contact = rows[static_cast<std::size_t>(number)].contact;
        contact.drag = row;
        write_lane(contact.drags, lane, 1);
    }

    std::vector<std::size_t> first_;  ///< of each packet, in `rows`
    std::vector<int> number_;         ///< in `rows`, of each row of the lanes; −1
    std::vector<Slot<3, Real>> gone_;  ///< Δx of each body
    Real elapsed_ = 0;                 ///< [s]
};

}  // namespace rigid
