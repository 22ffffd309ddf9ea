// The functions of dantzig_drive.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/dantzig_drive.hpp"

namespace rigid {

DantzigDrive::DantzigDrive(const Mlcp& mlcp, int limit)
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

DantzigDrive::Place DantzigDrive::run()
{
    for (const Index d : order_) {
        const Place place = drive(d);
        if (place != Place::right) return place;
        is_done_[index(d)] = true;
    }
    return Place::right;
}

void DantzigDrive::refine()
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

//! [drive]
DantzigDrive::Place DantzigDrive::drive(Index d)
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
            const Real none = depends_[index(i)]
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

DantzigDrive::Place DantzigDrive::set_case(Index d)
{
    const bool inside = lambda[d] > mlcp_.lo[d] && lambda[d] < mlcp_.hi[d];
    cases[index(d)] = !inside && lambda[d] <= mlcp_.lo[d] ? BoundState::at_lo
                      : !inside                           ? BoundState::at_hi
                                                          : BoundState::between;
    // F already keeps its w at zero
    if (inside && !join(d)) waiting_.push_back(d);
    return Place::right;
}

//! [direction]
void DantzigDrive::find_direction(Index d, Real sign)
{
    const Index f = factor_.size();
    VecX answer(f);
    for (Index k = 0; k < f; ++k) answer[k] = -sign * A_(factor_.rows[index(k)], d);
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

}  // namespace rigid
