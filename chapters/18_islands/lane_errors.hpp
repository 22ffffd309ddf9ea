/// \file lane_errors.hpp
/// What rows in lanes are off by while bodies move: of contacts and limits the gap, of joints all of it.
#pragma once

#include "chapters/17_wide_sweeps/wide_solver.hpp"
#include "chapters/18_islands/turning_pins.hpp"

namespace rigid {

/// What a small step asks of a row besides J u: its C, and what it gives back.
template <class V>
struct LaneError {
    V C{};        ///< [m, rad]
    V slop{};     ///< s/2 [m]
    V is_gap{};   ///< 1: of a contact's normal or a limit; 0: of others
    V is_held{};  ///< 1: of what a joint holds; 0: of others
    V rate{};     ///< J u of what nothing moves, and b of friction [m/s]
};

/// Those of all rows of one heap.
class LaneErrors {
    static constexpr int lanes = full_lanes<Real>;
    using V = Lanes<Real, lanes>;
    using Wide = WideRows<3, Real, lanes>;

public:
    std::vector<LaneError<V>> rows;  ///< of the lanes

    LaneError<V>& at(int row) { return rows[static_cast<std::size_t>(row)]; }

    /// \param left_alone  s/2 of a constraint [m]
    /// \param whole  the step; row i of the lanes is its row of[i]
    /// \param inverse_mass  of the bodies of the lanes
    template <class LeftAlone>
    void put_in(const LeftAlone& left_alone, const StepData<3>& whole,
                const std::vector<int>& of, const VecX& inverse_mass,
                const Wide& wide)
    {
        rows.assign(wide.rows.size(), {});
        for (std::size_t i = 0; i < of.size(); ++i) {
            const auto [row, lane] = wide.place[i];
            const Constraint<3>& c =
                whole.constraints[static_cast<std::size_t>(of[i])];
            if (row < 0 || !has_error(c.kind)) continue;
            LaneError<V>& error = at(row);
            write_lane(error.C, lane, c.C);
            write_lane(error.slop, lane, left_alone(c));
            const bool is_gap = c.kind == ConstraintKind::unilateral;
            write_lane(is_gap ? error.is_gap : error.is_held, lane, 1);
        }
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i].rate = wide.rows[i].bias;
        pins_.find(whole, of, inverse_mass, wide);
    }

    //! [biases]
    /// (18.4b): a gap may close; of an overlap so much goes out a second, no faster
    /// than this.
    void set_biases(Real per_second, Real fastest, Real h, Wide& wide) const
    {
        const V none{}, step = none + h, part = none + per_second,
                        most = none - fastest;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const LaneError<V>& error = rows[i];
            const V open = at_least(error.C, none),
                    deep = at_most(error.C + error.slop, none);
            wide.rows[i].bias =
                error.rate +
                error.is_gap * (open / step + at_least(part * deep, most));
        }
    }
    /// C ← C + h J u, with the mean of a pin's J before and after
    void follow(Real h, Wide& wide)
    {
        std::size_t pin = 0;
        for (const Packet<lanes>& packet : wide.packets) {
            V ua[3], ub[3];
            gather<3, Real, lanes>(wide.u.data(), packet.a.data(), ua);
            gather<3, Real, lanes>(wide.u.data(), packet.b.data(), ub);
            for (int r = packet.first; r < packet.first + packet.rows; ++r) {
                const auto& row = wide.rows[static_cast<std::size_t>(r)];
                V speed = at(r).rate;
                for (int d = 0; d < 3; ++d)
                    speed = speed + row.Ja[d] * ua[d] + row.Jb[d] * ub[d];
                at(r).C = at(r).C + speed * (V{} + h);
            }
            pins_.turn(pin, packet, ua[2], ub[2], h, wide,
                       [&](int r, const V& gone) { at(r).C = at(r).C + gone; });
        }
    }
    //! [biases]

    /// The most that a joint is off by [m, rad]
    Real open_by() const
    {
        V open{};
        for (const LaneError<V>& error : rows)
            open = at_least(error.is_held * size_of(error.C), open);
        return largest<lanes>(open);
    }

private:
    TurningPins<lanes> pins_;
};

}  // namespace rigid
