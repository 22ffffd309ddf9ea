/// \file turning_pins.hpp
/// Pins in small steps: their arms turn with the bodies, from each small step to the next.
///
/// The two rows of a pin, along x and y, have J_θ = (−r_y, r_x): the arm r, turned by a quarter. It turns as the body does,
///
///     (X, Y) ← (c X − s Y, s X + c Y),    c = (1 − t²)/(1 + t²),  s = 2t/(1 + t²),  t = k ω/2                       (18.8)
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
    /// \param inverse_mass  of the bodies of the lanes
    void find(const StepData<3>& whole, const std::vector<int>& rows,
              const VecX& inverse_mass, const Wide& wide)
    {
        is_pin_.assign(wide.rows.size(), V{});
        for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
            const auto [row, lane] = wide.place[i];
            const auto [next, same] = wide.place[i + 1];
            // two joints of one pair of bodies may have a pin in two bundles
            if (row >= 0 && next == row + 1 && same == lane &&
                is_pin(whole, rows[i]))
                write_lane(is_pin_[static_cast<std::size_t>(row)], lane, 1);
        }
        pins_.clear();
        for (const Packet<L>& packet : wide.packets)
            for (int r = packet.first; r < packet.first + packet.rows; ++r) {
                const V& is = is_pin_[static_cast<std::size_t>(r)];
                if (!(largest<L>(is) > 0)) continue;
                Pin& pin = pins_.emplace_back(Pin{r, is});
                const auto& x = wide.rows[static_cast<std::size_t>(r)];
                for (int d = 0; d < 2; ++d)
                    pin.line = pin.line + x.Ja[d] * x.Wa[d] + x.Jb[d] * x.Wb[d];
                for (int k = 0; k < L; ++k) {
                    const auto spin = [&](int body) {  // of an empty lane: none
                        const Index at = 3 * static_cast<Index>(body) + 2;
                        return at < inverse_mass.size() ? inverse_mass[at] : 0;
                    };
                    const auto at = static_cast<std::size_t>(k);
                    write_lane(pin.spin_a, k, spin(packet.a[at]));
                    write_lane(pin.spin_b, k, spin(packet.b[at]));
                }
            }
    }

    /// Turns the pins of a packet.
    /// \param next  the first of them; the first of the next packet afterwards
    /// \param k     the small step [s]
    /// \param move  (row, C that its arms have gone besides k J u)
    template <class Move>
    void turn(std::size_t& next, const Packet<L>& packet, const V& spin_a,
              const V& spin_b, Real k, Wide& wide, const Move& move) const
    {
        for (; next < pins_.size() && pins_[next].row < packet.first + packet.rows;
             ++next) {
            const Pin& pin = pins_[next];
            auto* rows = &wide.rows[static_cast<std::size_t>(pin.row)];
            V gone[2] = {};
            turn(pin.is_pin * spin_a * (V{} + k / 2), rows[0].Ja[2], rows[1].Ja[2],
                 gone);
            turn(pin.is_pin * spin_b * (V{} + k / 2), rows[0].Jb[2], rows[1].Jb[2],
                 gone);
            for (int n = 0; n < 2; ++n) {
                auto& row = rows[n];
                const V Wa = row.Ja[2] * pin.spin_a, Wb = row.Jb[2] * pin.spin_b;
                const V A = pin.line + row.Ja[2] * Wa + row.Jb[2] * Wb;
                row.Wa[2] = pin.is_pin > 0 ? Wa : row.Wa[2];
                row.Wb[2] = pin.is_pin > 0 ? Wb : row.Wb[2];
                row.mass = pin.is_pin * row.mass > 0 ? 1 / A : row.mass;
                move(pin.row + n, gone[n]);
            }
        }
    }
    //! [pins]

private:
    struct Pin {
        int row;               ///< of x; that of y follows
        V is_pin;              ///< 1, or 0 in lanes of others
        V line{};              ///< m_a⁻¹ + m_b⁻¹ [1/kg]
        V spin_a{}, spin_b{};  ///< I⁻¹ [1/(kg m²)]
    };

    /// (18.8)
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
    std::vector<V> is_pin_;  ///< of each row
};

}  // namespace rigid
