/// \file dantzig_drive.hpp
/// One row at a time: those before it stay right all along, and each is driven until it is right too.
///
///     λ_d grows by t, λ_F by t Δ_F with A_FF Δ_F = −A_Fd        so w_F stays zero (9.16)
///
/// until w_d = 0 or λ_d is at its bound; on the way rows come to their bounds and leave F, others' w comes to
/// zero and they join it (9.17). Principal pivoting after Dantzig, as physics engines have it from
/// \cite baraff1994; \cite cottle1992, §4.3
#pragma once

#include "chapters/03_mlcp_formulation/direct.hpp"
#include "chapters/09_active_sets/first_guess.hpp"
#include "chapters/09_active_sets/incremental_ldlt.hpp"

namespace rigid {

class DantzigDrive {
public:
    VecX lambda, w;
    std::vector<BoundState> cases;
    int pivots = 0;

    enum class Place { right, ray, limit };

    DantzigDrive(const Mlcp& mlcp, int limit)
        : lambda(VecX::Zero(mlcp.size())), w(mlcp.size()), mlcp_(mlcp), A_(mlcp.A),
          factor_(mlcp.size()), limit_(limit),
          is_done_(static_cast<std::size_t>(mlcp.size()), false), depends_(is_done_)
    {
        clamp_into_bounds(mlcp, lambda);
        cases.resize(is_done_.size());
        cases_of(mlcp, lambda, cases);
        w = A_ * lambda + mlcp.q;
        for (const bool bilateral : {true, false})
            for (Index i = 0; i < mlcp.size(); ++i)
                if (is_bilateral(mlcp, i) == bilateral) order_.push_back(i);
    }

    /// Drives all rows.
    Place run()
    {
        for (const Index d : order_) {
            const Place place = drive(d);
            if (place != Place::right) return place;
            is_done_[index(d)] = true;
        }
        return Place::right;
    }

    /// λ_F again from what is left of w_F. Where a row of F nearly depends on the
    /// others this moves λ far for the sake of rounding, out of its bounds even.
    void refine()
    {
        for (int round = 0; round < 2; ++round) {
            w = A_ * lambda + mlcp_.q;
            VecX step(factor_.size());
            for (Index k = 0; k < factor_.size(); ++k)
                step[k] = -w[factor_.rows[index(k)]];
            factor_.solve(step);
            for (Index k = 0; k < factor_.size(); ++k)
                lambda[factor_.rows[index(k)]] += step[k];
        }
    }

    /// The direction of the last step: at a ray it may prove that there is no answer.
    const VecX& direction() const { return direction_; }

    //! [drive]
    /// Moves λ_d, and λ_F with it, until row d is right.
    Place drive(Index d)
    {
        for (;;) {
            const bool up = w[d] < -noise(d) && lambda[d] < mlcp_.hi[d];
            const bool down = w[d] > noise(d) && lambda[d] > mlcp_.lo[d];
            if (!up && !down) return set_case(d);
            if (pivots >= limit_) return Place::limit;
            find_direction(d, up ? 1 : -1);

            // (9.17): what stops it first?
            Index stops = d;
            bool at_bound = true;
            Real length = (up ? mlcp_.hi[d] - lambda[d] : lambda[d] - mlcp_.lo[d]);
            // else it depends on F: w_d cannot move
            if (w_slope_[d] * direction_[d] > 1e-11 * diagonal(d)) {
                const Real to_zero = -w[d] / w_slope_[d];
                if (to_zero <= length) length = to_zero, at_bound = false;
            }
            for (const Index i : factor_.rows) {
                const Real slope = direction_[i];
                if (slope == 0) continue;
                const Real way =
                    ((slope < 0 ? mlcp_.lo[i] : mlcp_.hi[i]) - lambda[i]) / slope;
                if (way < length)
                    length = std::max(way, Real{0}), stops = i, at_bound = true;
            }
            for (Index i = 0; i < mlcp_.size(); ++i) {
                const BoundState here = cases[index(i)];
                if (!is_done_[index(i)] || here == BoundState::between ||
                    mlcp_.lo[i] == mlcp_.hi[i])
                    continue;
                // What depends on F has a slope by rounding alone.
                const Real none =
                    depends_[index(i)]
                        ? infinity
                        : 1e-12 * std::sqrt(diagonal(i) * diagonal(d));
                if (here == BoundState::at_lo ? w_slope_[i] >= -none
                                              : w_slope_[i] <= none)
                    continue;
                const Real way = -w[i] / w_slope_[i];
                if (way < length)
                    length = std::max(way, Real{0}), stops = i, at_bound = false;
            }
            if (!(length < infinity)) return Place::ray;
            lambda += length * direction_;
            w += length * w_slope_;
            ++pivots;
            if (at_bound) {
                const bool upper = direction_[stops] > 0;
                lambda[stops] = upper ? mlcp_.hi[stops] : mlcp_.lo[stops];
                cases[index(stops)] = upper ? BoundState::at_hi : BoundState::at_lo;
                if (stops == d) return Place::right;
                factor_.remove(place_of(stops));
                std::fill(depends_.begin(), depends_.end(), false);
                std::erase_if(waiting_, [&](Index i) { return join(i); });
            } else {
                w[stops] = 0;
                if (stops == d) return set_case(d);
                if (join(stops)) cases[index(stops)] = BoundState::between;
                else depends_[index(stops)] = true;
            }
        }
    }
    //! [drive]

private:
    static std::size_t index(Index i) { return static_cast<std::size_t>(i); }
    Real diagonal(Index i) const { return A_(i, i) > 0 ? A_(i, i) : 1; }

    /// What rounding can do to a w.
    Real noise(Index i) const
    {
        return 1e-14 *
               (std::abs(mlcp_.q[i]) + A_.col(i).cwiseAbs().dot(lambda.cwiseAbs()));
    }

    /// A row that is right where it is.
    Place set_case(Index d)
    {
        const bool inside = lambda[d] > mlcp_.lo[d] && lambda[d] < mlcp_.hi[d];
        cases[index(d)] = !inside && lambda[d] <= mlcp_.lo[d] ? BoundState::at_lo
                          : !inside                           ? BoundState::at_hi
                                                              : BoundState::between;
        // F already keeps its w at zero
        if (inside && !join(d)) waiting_.push_back(d);
        return Place::right;
    }

    bool join(Index i)
    {
        VecX couplings(factor_.size());
        for (Index k = 0; k < factor_.size(); ++k)
            couplings[k] = A_(i, factor_.rows[index(k)]);
        return factor_.append(i, couplings, A_(i, i), 1e-11 * diagonal(i));
    }

    Index place_of(Index row) const
    {
        return std::find(factor_.rows.begin(), factor_.rows.end(), row) -
               factor_.rows.begin();
    }

    //! [direction]
    /// (9.16): how λ_F answers when λ_d grows, so that w_F stays zero, and what
    /// that does to all w.
    void find_direction(Index d, Real sign)
    {
        const Index f = factor_.size();
        VecX answer(f);
        for (Index k = 0; k < f; ++k)
            answer[k] = -sign * A_(factor_.rows[index(k)], d);
        factor_.solve(answer);
        direction_ = VecX::Zero(mlcp_.size());
        direction_[d] = sign;
        w_slope_ = sign * A_.col(d);
        for (Index k = 0; k < f; ++k) {
            const Index i = factor_.rows[index(k)];
            direction_[i] = answer[k];
            if (answer[k] != 0) w_slope_ += answer[k] * A_.col(i);
        }
        for (const Index i : factor_.rows) w_slope_[i] = 0;
    }
    //! [direction]

    const Mlcp& mlcp_;
    MatX A_;
    IncrementalLdlt factor_;
    int limit_;
    /// rows that are right; rows that F would not take in
    std::vector<bool> is_done_, depends_;
    std::vector<Index> order_;
    /// rows between their bounds that depend on F: in, once a row is removed from F
    std::vector<Index> waiting_;
    VecX direction_, w_slope_;
};

}  // namespace rigid
