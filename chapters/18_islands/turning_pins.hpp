/// \file turning_pins.hpp
/// Pins in small steps: their arms turn with the bodies, from each small step to the next.
///
/// The two rows of a pin, along x and y, have J_θ = (−r_y, r_x): the arm r, turned by a quarter. It turns as the body does,
///
///     (X, Y) ← (c X − s Y, s X + c Y),    c = (1 − t²)/(1 + t²),  s = 2t/(1 + t²),  t = k ω/2                       (18.9)
///
/// by the angle 2 arctan t = k ω − (k ω)³/12 …, and r goes by k ω times the mean of both J_θ, exactly.
#pragma once

#include "chapters/17_wide_sweeps/wide_sweep.hpp"

namespace rigid {

/// Whether rows i and i + 1 of a step are a pin: x and y of one joint, in the axes of the world.
inline bool is_pin(const StepData<3>& now, int i)
{
    const auto at = static_cast<std::size_t>(i);
    if (at + 1 >= now.rows.size()) return false;
    const Source x = now.sources[at], y = now.sources[at + 1];
    const Constraint<3>&of_x = now.constraints[at], &of_y = now.constraints[at + 1];
    if (x.of != Source::Of::joint || y.of != x.of || y.index != x.index + 1 ||
        of_x.a != of_y.a || of_x.b != of_y.b)
        return false;
    const auto along = [&](const Constraint<3>& c, Real to_x, Real to_y) {
        return c.kind == ConstraintKind::bilateral && c.Jb(0) == to_x &&
               c.Jb(1) == to_y;
    };
    return along(of_x, 1, 0) && along(of_y, 0, 1);
}

//! [pins]
template <int L>
class TurningPins {
    using V = Lanes<Real, L>;
    using Wide = WideRows<3, Real, L>;

public:
    /// \param whole  the step; row i of the lanes is its row rows[i]
    void find(const StepData<3>& whole, const std::vector<int>& rows,
              const Wide& wide)
    {
        of_row_.assign(wide.rows.size(), -1);
        pins_.clear();
        for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
            const auto [row, lane] = wide.place[i];
            const auto [next, same] = wide.place[i + 1];
            // two joints of one pair of bodies may have a pin in two bundles
            if (row < 0 || next != row + 1 || same != lane ||
                !is_pin(whole, rows[i]))
                continue;
            int& number = of_row_[static_cast<std::size_t>(row)];
            if (number < 0) {
                number = static_cast<int>(pins_.size());
                pins_.push_back({row, packet_of(row, wide)});
            }
            Pin& pin = pins_[static_cast<std::size_t>(number)];
            write_lane(pin.is_pin, lane, 1);
            for (std::size_t n = 0; n < 2; ++n)
                write_lane(
                    pin.C[n], lane,
                    whole.constraints[static_cast<std::size_t>(rows[i + n])].C);
        }
        for (Pin& pin : pins_) {
            const auto& x = wide.rows[static_cast<std::size_t>(pin.row)];
            const auto& m = wide.inverse[static_cast<std::size_t>(pin.packet)];
            for (int d = 0; d < 2; ++d)
                pin.line = pin.line + x.Ja[d] * (m.a[d] * x.Ja[d]) +
                           x.Jb[d] * (m.b[d] * x.Jb[d]);
            for (std::size_t n = 0; n < 2; ++n)
                pin.rate[n] = wide.rows[static_cast<std::size_t>(pin.row) + n].bias;
        }
    }

    /// Whether a row is one of a pin.
    bool has(int row, int lane_of) const
    {
        for (const int x : {row, row - 1}) {
            const int n = x < 0 ? -1 : of_row_[static_cast<std::size_t>(x)];
            if (n >= 0 &&
                lane(pins_[static_cast<std::size_t>(n)].is_pin, lane_of) > 0)
                return true;
        }
        return false;
    }

    /// The bodies go on with the velocities u for k, and the pins turn with them.
    /// \param k  the small step [s]
    void turn(Real k, Wide& wide)
    {
        for (Pin& pin : pins_) {
            const auto p = static_cast<std::size_t>(pin.packet);
            V ua[3], ub[3];
            gather<3, Real, L>(wide.u.data(), wide.packets[p].a.data(), ua);
            gather<3, Real, L>(wide.u.data(), wide.packets[p].b.data(), ub);
            auto* rows = &wide.rows[static_cast<std::size_t>(pin.row)];
            V gone[2];
            for (int n = 0; n < 2; ++n) {
                gone[n] = pin.rate[n];
                for (int d = 0; d < 3; ++d)
                    gone[n] =
                        gone[n] + rows[n].Ja[d] * ua[d] + rows[n].Jb[d] * ub[d];
                gone[n] = gone[n] * (V{} + k);
            }
            const V half = V{} + k / 2;
            turn(pin.is_pin * ua[2] * half, rows[0].Ja[2], rows[1].Ja[2], gone);
            turn(pin.is_pin * ub[2] * half, rows[0].Jb[2], rows[1].Jb[2], gone);
            const V spin_a = wide.inverse[p].a[2], spin_b = wide.inverse[p].b[2];
            for (int n = 0; n < 2; ++n) {
                pin.C[n] = pin.C[n] + gone[n];
                auto& row = rows[n];
                const V A = pin.line + row.Ja[2] * (row.Ja[2] * spin_a) +
                            row.Jb[2] * (row.Jb[2] * spin_b);
                row.mass = pin.is_pin * row.mass > 0 ? 1 / A : row.mass;
            }
        }
    }
    //! [pins]

    std::size_t count() const { return pins_.size(); }
    /// How far a pin is open [m]
    Vec2 open(std::size_t pin, int lane_of) const
    {
        const V(&C)[2] = pins_[pin].C;
        return {lane(C[0], lane_of), lane(C[1], lane_of)};
    }
    /// The most that any is open by [m]
    Real open_by() const
    {
        V open{};
        for (const Pin& pin : pins_)
            for (const V& C : pin.C) open = at_least(pin.is_pin * size_of(C), open);
        return largest<L>(open);
    }

private:
    struct Pin {
        int row;      ///< of x; that of y follows
        int packet;   ///< of both
        V is_pin{};   ///< 1, or 0 in lanes of others
        V line{};     ///< m_a⁻¹ + m_b⁻¹ [1/kg]
        V C[2]{};     ///< [m]
        V rate[2]{};  ///< J u of what nothing moves [m/s]
    };

    static int packet_of(int row, const Wide& wide)
    {
        const auto after = std::upper_bound(
            wide.packets.begin(), wide.packets.end(), row,
            [](int r, const Packet<L>& packet) { return r < packet.first; });
        return static_cast<int>(after - wide.packets.begin()) - 1;
    }

    /// (18.9)
    /// \param t     k ω/2
    /// \param gone  k ω times half of what J_θ has become more [m]
    static void turn(const V& t, V& X, V& Y, V (&gone)[2])
    {
        const V one = V{} + 1, part = one / (one + t * t);
        const V c = (one - t * t) * part, s = (t + t) * part;
        const V x = c * X - s * Y, y = s * X + c * Y;
        gone[0] = gone[0] + t * (x - X), gone[1] = gone[1] + t * (y - Y);
        X = x, Y = y;
    }

    std::vector<Pin> pins_;
    std::vector<int> of_row_;  ///< the pin of each row; −1: it is no pin's x
};

}  // namespace rigid
