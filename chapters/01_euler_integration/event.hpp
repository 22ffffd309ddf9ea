/// \file event.hpp
/// Where a motion meets the ground: the time at which a gap closes, found to the last
/// digits.
///
///     gap(x(t*), u(t*)) = 0,   gap > 0 before
///
/// The polynomial (1.45) of an accepted step costs no evaluation and finds t*, (1.46), to the
/// accuracy of the polynomial; one or two real steps, from the start of that step to t*, then make it
/// as accurate as the steps themselves (1.47).
#pragma once

#include "chapters/01_euler_integration/adaptive.hpp"
#include "chapters/01_euler_integration/first_closing.hpp"

namespace rigid {

//! [polish]
/// Puts a run that has just taken a step back to the one event between the parts
/// `open` and `closed` of it.
template <int N, Acceleration<N> A, class Gap>
void go_back_to_event(Adaptive<N>& run, Real open, Real closed, const A& a,
                      const Gap& gap)
{
    const Hermite<N> whole = run.last;
    const auto gap_at = [&](Real theta) { return gap(whole.at(theta)); };

    // (1.46): halve the interval on the polynomial until no number fits in between.
    for (Real theta = (open + closed) / 2; open < theta && theta < closed;
         theta = (open + closed) / 2)
        (gap_at(theta) > 0 ? open : closed) = theta;

    // (1.47): Newton's method with real steps; the slope of the polynomial is good
    // enough for it.
    const Real beside = 1e-6 * closed;
    const Real slope = (gap_at(closed + beside) - gap_at(closed - beside)) /
                       (2 * beside * whole.h);
    Real h = closed * whole.h;
    for (int i = 0;; ++i) {
        const PairStep<N> step = dormand_prince_step(whole.s0, whole.a0, h, a);
        run.evaluations += 6;
        run.s = step.s;
        run.a = step.a;
        run.last = {whole.s0, step.s, whole.a0, step.a, h};
        const Real next = std::clamp(h - gap(step.s) / slope, h / 2, whole.h);
        const bool close = !(std::abs(next - h) >
                             4 * std::numeric_limits<Real>::epsilon() * run.t);
        if (close || i == 9) break;
        h = next;
    }
    run.t += h - whole.h;
}
//! [polish]

//! [event]
/// Takes one accepted step, at most to t_end; when gap(s) passes from above zero to
/// zero or below on the way, the run goes back to that moment and the outcome is
/// `event`. A caller that then changes run.s (a bounce) sets run.a to its acceleration
/// too. A run that starts at gap ≤ 0 has no event before it was above zero.
/// \param gap  gap(s): a finite number with the sign of the distance, continuous in
///             the state
template <int N, Acceleration<N> A, class Gap>
Outcome advance_to_event(Adaptive<N>& run, Real t_end, const A& a,
                         const Tolerance& tolerance, const Gap& gap)
{
    const Outcome outcome = advance(run, t_end, a, tolerance);
    if (outcome != Outcome::reached) return outcome;

    // Look along the step for the first place where the gap closes.
    const auto closing = first_closing([&](Real theta) {
        return gap(theta < 1 ? run.last.at(theta) : run.last.s1);
    });
    if (!closing) return Outcome::reached;
    go_back_to_event(run, closing->from, closing->to, a, gap);
    return Outcome::event;
}
//! [event]

/// Takes adaptive steps until the event or until t_end [s]. A ball with e < 1 meets the
/// ground infinitely often in a finite time: a caller that lets it bounce has to say from
/// which speed on it rests.
/// \throws std::invalid_argument  for a t_end that is not finite or lies in the past
template <int N, Acceleration<N> A, class Gap>
Outcome integrate_to_event(Adaptive<N>& run, Real t_end, const A& a,
                           const Tolerance& tolerance, const Gap& gap)
{
    require_end(run, t_end);
    Outcome outcome = Outcome::reached;
    while (run.t < t_end && outcome == Outcome::reached)
        outcome = advance_to_event(run, t_end, a, tolerance, gap);
    return outcome;
}

}  // namespace rigid
