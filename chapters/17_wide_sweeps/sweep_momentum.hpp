/// \file sweep_momentum.hpp
/// Sweeps that go further where they go on in one direction.
///
///     λ ← clamp(λ + β (λ − λ_before)),    β = (t − 1)/t′,    t′ = (1 + √(1 + 4 t²))/2                                            (17.11)
///
/// between two sweeps, and u with it. t begins at 1, and again after a sweep that went back, Σ A_ii (λ_start − λ) (λ − λ_before) > 0,
/// or that changed more than eight times what the least one has; where a window of sweeps gains nothing, one without momentum
/// follows. A line of N rows needs some N/π sweeps an e-fold of its error instead of (N/π)², (17.13).
#pragma once

#include "chapters/17_wide_sweeps/wide_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigid {

//! [momentum]
template <int Dof, class T, int L>
class SweepMomentum {
    using V = Lanes<T, L>;
    using Wide = WideRows<Dof, T, L>;

public:
    /// Before the first sweep.
    void begin(const Wide& all)
    {
        before_.clear();
        for (const auto& row : all.rows) before_.push_back(row.lambda);
        start_ = before_;
        t_ = 1, least_ = before_window_ = std::numeric_limits<T>::infinity();
        plain_ = false;
        window_ = left_ = 256;
    }
    /// Between two sweeps.
    void go_on(Wide& all)
    {
        const auto [back, change] = look_at(all);
        least_ = std::min(least_, change);
        if (--left_ == 0) end_window();
        if (plain_ || back || change > 8 * least_) t_ = 1;
        const T next = plain_ ? 1 : (1 + std::sqrt(1 + 4 * t_ * t_)) / 2;
        extrapolate((t_ - 1) / next, all);
        t_ = next;
    }
    //! [momentum]

    //! [extrapolate]
    /// λ ← clamp(λ + β (λ − λ_before)), and u with it.
    void extrapolate(T beta, Wide& all)
    {
        for (std::size_t p = 0; p < all.packets.size(); ++p) {
            const Packet<L>& packet = all.packets[p];
            V ua[Dof], ub[Dof];
            gather<Dof, T, L>(all.u.data(), packet.a.data(), ua);
            gather<Dof, T, L>(all.u.data(), packet.b.data(), ub);
            const auto first = static_cast<std::size_t>(packet.first);
            for (int r = 0; r < packet.rows; ++r) {
                const auto i = first + static_cast<std::size_t>(r);
                auto& row = all.rows[i];
                const V before = std::exchange(before_[i], row.lambda);
                const V further = row.lambda + beta * (row.lambda - before);
                const V reach =
                    reach_of<Dof, T, L>(&all.rows[first], &all.shapes[first], r);
                start_[i] = clamped(row, all.shapes[i], reach, further);
                const V change = start_[i] - row.lambda;
                row.lambda = start_[i];
                add_impulse<Dof, V>(row, all.inverse[p], change, ua, ub);
            }
            scatter<Dof, T, L>(ua, packet.a.data(), all.u.data());
            scatter<Dof, T, L>(ub, packet.b.data(), all.u.data());
        }
    }
    //! [extrapolate]

private:
    //! [window]
    /// Where sweeps with momentum change as much as before, as many without follow;
    /// and then twice as many with it.
    void end_window()
    {
        if (plain_) window_ *= 2;
        plain_ = !plain_ && !(2 * least_ < before_window_);
        before_window_ = least_;
        left_ = window_;
    }
    //! [window]

    struct Look {
        bool back;  ///< Σ A_ii (λ_start − λ) (λ − λ_before) > 0
        T change;   ///< the largest A_ii |λ − λ_start| [m/s]
    };
    /// At the last sweep. Bundles are added one after the other, so the sum is the
    /// same in any number of lanes.
    Look look_at(const Wide& all) const
    {
        T sum = 0;
        V largest_change{};
        for (const Packet<L>& packet : all.packets) {
            V part{};
            for (int r = packet.first; r < packet.first + packet.rows; ++r) {
                const auto i = static_cast<std::size_t>(r);
                const auto& row = all.rows[i];
                const V none{}, A = row.mass > 0 ? 1 / row.mass : none;
                const V change = A * (row.lambda - start_[i]);
                part = part - change * (row.lambda - before_[i]);
                largest_change = at_least(size_of(change), largest_change);
            }
            for (int k = 0; k < L; ++k) sum += lane(part, k);
        }
        return {sum > 0, largest<L>(largest_change)};
    }

    /// λ after the sweep before the last one, and as the last one began
    std::vector<V> before_, start_;
    T t_ = 1;
    T least_ = 0,
      before_window_ = 0;        ///< least change of a sweep, and of those before
    bool plain_ = false;         ///< sweeps without momentum
    int window_ = 0, left_ = 0;  ///< sweeps, and how many are left of them
};

}  // namespace rigid
