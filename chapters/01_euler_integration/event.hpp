/// \file event.hpp
/// Where a motion meets the ground: the time at which a gap closes, found to the last digits.
///
///     gap(x(t*), u(t*)) = 0,   gap > 0 before
///
/// The polynomial (1.45) of an accepted step costs nothing and finds t* to the accuracy of the
/// polynomial; one or two real steps, from the start of that step to t*, then make it as accurate as
/// the steps themselves (1.47).
#pragma once

#include "chapters/01_euler_integration/dormand_prince.hpp"

namespace rigid {

/// How many parts of a step are looked at: a gap that closes and opens again in less may be missed.
inline constexpr int event_samples = 8;

//! [polish]
/// Puts the run, which has just taken a step, back to the event between the parts `before` and `after` of it.
template <int N, Acceleration<N> A, class Closes, class Gap>
void go_back_to_event(Adaptive<N>& run, Real before, Real after, const A& a, const Closes& closes,
                      const Gap& gap)
{
    // (1.46): halve the interval on the polynomial until no number fits in between.
    for (Real middle = (before + after) / 2; before < middle && middle < after; middle = (before + after) / 2)
        (closes(middle) > 0 ? before : after) = middle;

    // (1.47): Newton's method with real steps; the slope of the polynomial is good enough for it.
    const Hermite<N> whole = run.last;
    const Real slope = (closes(after + 1e-3) - closes(after - 1e-3)) / (2e-3 * whole.h);
    Real h = after * whole.h;
    for (int i = 0;; ++i) {
        const PairStep<N> step = dormand_prince_step(whole.s0, whole.a0, h, a);
        run.evaluations += 6;
        run.s = step.s;
        run.a = step.a;
        run.last = {whole.s0, step.s, whole.a0, step.a, h};
        const Real change = -gap(step.s) / slope;
        const Real next = std::clamp(h + change, before * whole.h / 2, whole.h);
        const bool close = !(std::abs(next - h) > 4 * std::numeric_limits<Real>::epsilon() * run.t);
        if (close || i == 9) break;
        h = next;
    }
    run.t += h - whole.h;
}
//! [polish]

//! [event]
/// Takes adaptive steps until gap(s) passes from above zero to zero or below, or until t_end [s].
/// At `Outcome::event` the run stands at the moment of the event. Whoever then changes run.s (a
/// bounce) sets run.a to its acceleration too. A run that starts at gap ≤ 0 has no event before it
/// was above zero.
/// \param gap  gap(s): a number with the sign of the distance, continuous in the state
/// \throws std::invalid_argument  for a t_end that is not finite or lies in the past
template <int N, Acceleration<N> A, class Gap>
Outcome integrate_to_event(Adaptive<N>& run, Real t_end, const A& a, const Tolerance& tolerance,
                           const Gap& gap)
{
    require_end(run, t_end);
    while (run.t < t_end) {
        const Outcome outcome = advance(run, t_end, a, tolerance);
        if (outcome != Outcome::reached) return outcome;

        // Look along the step for a place where the gap closes.
        const auto closes = [&](Real theta) { return gap(run.last.at(theta)); };
        Real before = 0;
        bool open = gap(run.last.s0) > 0;
        for (int i = 1; i <= event_samples; ++i) {
            const Real after = static_cast<Real>(i) / event_samples;
            const bool still_open = (i < event_samples ? closes(after) : gap(run.last.s1)) > 0;
            if (open && !still_open) {
                go_back_to_event(run, before, after, a, closes, gap);
                return Outcome::event;
            }
            open = still_open;
            before = after;
        }
    }
    return Outcome::reached;
}
//! [event]

}  // namespace rigid
