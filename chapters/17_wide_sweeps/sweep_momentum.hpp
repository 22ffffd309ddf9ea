/// \file sweep_momentum.hpp
/// Sweeps that go further where they go on in one direction.
///
///     λ ← λ + β (λ − λ_before),    u ← u + β (u − u_before),    β = (t − 1)/t′,    t′ = (1 + √(1 + 4 t²))/2                      (17.11)
///
/// between two sweeps: what goes beyond its bounds is taken back when its row is visited. t begins at 1, and again after a
/// sweep that went back, Σ A_ii (λ_start − λ) (λ − λ_before) > 0, λ_start within its bounds, or that changed more than a hundred
/// times what the least one has; where a window of sweeps gains nothing, one without momentum follows. A line of N rows needs
/// some N/π sweeps an e-fold of its error instead of (N/π)², (17.13).
#pragma once

#include "chapters/17_wide_sweeps/wide_sweep.hpp"

#include <algorithm>
#include <array>
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
        rows_.clear();
        for (const auto& row : all.rows)
            rows_.push_back({row.lambda, row.mass > 0 ? 1 / row.mass : V{}});
        u_before_ = all.u;
        of_packets_.assign(all.packets.size(), {});
        t_ = 1, beta_ = 0;
        least_ = before_window_ = std::numeric_limits<T>::infinity();
        plain_ = false;
        window_ = left_ = 256;
    }
    /// Between two sweeps: u ← u + β (u − u_before)
    void go_on(Wide& all)
    {
        const auto [back, change] = last_sweep(all);
        least_ = std::min(least_, change);
        if (--left_ == 0) end_window();
        if (plain_ || back || change > 100 * least_) t_ = 1;
        const T next = plain_ ? 1 : (1 + std::sqrt(1 + 4 * t_ * t_)) / 2;
        go_on((t_ - 1) / next, all);
        t_ = next;
    }
    void go_on(T beta, Wide& all)
    {
        beta_ = beta;
        u_now_ = all.u;
        numbers(all.u) += beta * (numbers(u_now_) - numbers(u_before_));
        std::swap(u_before_, u_now_);
    }
    //! [momentum]

    //! [further]
    /// The rows of a packet: λ ← λ + β (λ − λ_before) before a row is visited, and what
    /// the visit does to it.
    struct Visits {
        SweepMomentum& of;
        std::size_t first;  ///< row of the packet
        V start{}, back{}, most{};

        void before(int r, WideRow<Dof, V>& row, const RowShape& shape,
                    const V& reach)
        {
            Going& own = of.rows_[first + static_cast<std::size_t>(r)];
            const V was = std::exchange(own.before, row.lambda);
            row.lambda = row.lambda + of.beta_ * (row.lambda - was);
            start = clamped(row, shape, reach, row.lambda);
        }
        void after(int r, const WideRow<Dof, V>& row)
        {
            const Going& own = of.rows_[first + static_cast<std::size_t>(r)];
            const V change = own.A * (row.lambda - start);
            back = back - change * (row.lambda - own.before);
            most = at_least(size_of(change), most);
        }
    };
    Visits visits(const Packet<L>& packet)
    {
        return {*this, static_cast<std::size_t>(packet.first)};
    }
    void note(std::size_t p, const Visits& of)
    {
        of_packets_[p] = {of.back, of.most};
    }
    //! [further]

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
    /// Bundle n of a colour and shape is added to sum n mod 16, so the sums are the
    /// same in any number of lanes.
    Look last_sweep(const Wide& all) const
    {
        std::array<V, 16 / L> sums{};
        V most{};
        for (std::size_t p = 0; p < all.packets.size(); ++p) {
            V& sum =
                sums[static_cast<std::size_t>(all.packets[p].number) % sums.size()];
            sum = sum + of_packets_[p].back;
            most = at_least(of_packets_[p].most, most);
        }
        T sum = 0;
        for (const V& some : sums)
            for (int l = 0; l < L; ++l) sum += lane(some, l);
        return {sum > 0, largest<L>(most)};
    }

    static auto numbers(std::vector<Slot<Dof, T>>& slots)
    {
        return Eigen::Map<Eigen::Array<T, Eigen::Dynamic, 1>>(
            slots.data()->u,
            static_cast<Index>(slots.size() * sizeof(Slot<Dof, T>) / sizeof(T)));
    }

    struct Going {
        V before;  ///< λ after the sweep before the last one
        V A;       ///< A_ii
    };
    struct Sums {
        V back{}, most{};
    };
    std::vector<Going> rows_;
    std::vector<Sums> of_packets_;  ///< in the last sweep
    /// velocities after the sweep before the last one, and after the last
    std::vector<Slot<Dof, T>> u_before_, u_now_;
    T t_ = 1, beta_ = 0;
    T least_ = 0,
      before_window_ = 0;        ///< least change of a sweep, and of those before
    bool plain_ = false;         ///< sweeps without momentum
    int window_ = 0, left_ = 0;  ///< sweeps, and how many are left of them
};

}  // namespace rigid
