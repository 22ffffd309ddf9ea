/// \file adaptive.hpp
/// Steps that choose their own size, from the error that a pair of methods estimates.
///
///     error(h) ≈ C h⁵,   wanted: error = tolerance,   so   h ← 0.8 h (tolerance /
///     error)^(1/5)
///
/// That is (1.41); the error is measured by (1.40). A run ends with an outcome that says
/// why, also when the force is stiff or not a number: nothing here loops forever. Between
/// its two ends a step is a Hermite polynomial (1.45). \cite hairer1993, §II.4
#pragma once

#include "chapters/01_euler_integration/dormand_prince.hpp"
#include "chapters/01_euler_integration/hermite.hpp"
#include "common/elementary.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace rigid {

/// How large the estimated error of one step may be: relative · length + absolute.
struct Tolerance {
    Real relative = 1e-9;
    Real position = 1e-9;  ///< absolute part for positions [m]
    Real velocity = 1e-9;  ///< absolute part for velocities [m/s]
};

/// How a run with adaptive steps ended.
enum class Outcome { reached, event, step_limit, step_too_small, not_finite };

/// The outcome as half a sentence, for messages.
inline const char* to_string(Outcome outcome)
{
    switch (outcome) {
    case Outcome::reached: return "the end was reached";
    case Outcome::event: return "the event was found";
    case Outcome::step_limit:
        return "the step limit was reached before the end; is the force stiff?";
    case Outcome::step_too_small:
        return "the tolerance requires a step too small for the clock";
    case Outcome::not_finite: return "the force is not finite near this state";
    }
    return "";
}

//! [norm]
/// (1.40): the square of the error in units of what the tolerance allows. Vectors
/// are measured by their length, so it does not matter how the axes lie; a NaN
/// anywhere gives NaN.
template <int N>
Real scaled_error2(const Slope<N>& error, const State<N>& from, const State<N>& to,
                   const Tolerance& tolerance)
{
    const Real size_x =
        std::sqrt(std::max(from.x.squaredNorm(), to.x.squaredNorm()));
    const Real size_u =
        std::sqrt(std::max(from.u.squaredNorm(), to.u.squaredNorm()));
    const Real allowed_x = tolerance.position + tolerance.relative * size_x;
    const Real allowed_u = tolerance.velocity + tolerance.relative * size_u;
    return error.u.squaredNorm() / (allowed_x * allowed_x) +
           error.a.squaredNorm() / (allowed_u * allowed_u);
}
//! [norm]

/// A run with adaptive steps: where it is, and all that the next step needs.
template <int N>
struct Adaptive {
    State<N> s;       ///< the state now
    Vec<N> a;         ///< its acceleration [m/s²]
    Real t = 0;       ///< [s]
    Real h = 0;       ///< what the next step will try [s]
    Hermite<N> last;  ///< the last accepted step: the motion from t - last.h to t
    Index accepted = 0, rejected = 0, evaluations = 0;
    Index step_limit = 1'000'000;  ///< accepted and rejected steps of the whole run
};

/// Starts a run at time 0 and guesses its first step from the sizes of the state, its slope
/// and the change of its slope over a small explicit Euler step \cite hairer1993, §II.4.
/// Two evaluations. \throws std::invalid_argument  for a state that isn't finite or a
/// tolerance that isn't positive
template <int N, Acceleration<N> A>
Adaptive<N> start_adaptive(const State<N>& s, const A& a,
                           const Tolerance& tolerance)
{
    require_finite(s);
    const auto require_positive = [](Real value, const char* name,
                                     const char* unit) {
        if (!(value > 0) || !std::isfinite(value))
            throw std::invalid_argument(std::string("the ") + name +
                                        " tolerance is " + shortest(value) + unit +
                                        "; it must be positive and finite");
    };
    require_positive(tolerance.relative, "relative", "");
    require_positive(tolerance.position, "position", " m");
    require_positive(tolerance.velocity, "velocity", " m/s");

    Adaptive<N> run{s, acceleration(a, s), 0, 0, {}};
    const auto size = [&](const Slope<N>& v) {
        return std::sqrt(scaled_error2(v, s, s, tolerance));
    };
    const Slope<N> k1{s.u, run.a};
    const Real d0 = size({s.x, s.u});
    const Real d1 = size(k1);
    const Real h0 = d0 > 1e-5 && d1 > 1e-5 ? d0 / d1 / 100 : 1e-6;
    const State<N> probe = s + h0 * k1;
    const Slope<N> bend{probe.u - s.u, acceleration(a, probe) - run.a};
    const Real d2 = std::max(d1, size(bend) / h0);
    run.h = std::min(100 * h0, pow(0.01 / std::max(d2, 1e-15), 0.2));
    run.evaluations = 2;
    return run;
}

/// Throws std::invalid_argument unless t_end is finite and not in the past of the run.
template <int N>
void require_end(const Adaptive<N>& run, Real t_end)
{
    if (!(t_end >= run.t) || !std::isfinite(t_end))
        throw std::invalid_argument("the end time is " + shortest(t_end) +
                                    " s; it must be finite and at least " +
                                    shortest(run.t) + " s, where the run is");
}

//! [advance]
/// Takes one accepted step, at most to t_end, after as many tries as it needs.
/// \return  `reached` when it did (t < t_end or t = t_end), otherwise why it
///     couldn't
template <int N, Acceleration<N> A>
Outcome advance(Adaptive<N>& run, Real t_end, const A& a,
                const Tolerance& tolerance)
{
    const Real smallest =
        16 * std::numeric_limits<Real>::epsilon() * std::max(run.t, run.h);
    for (bool first_try = true;; first_try = false) {
        if (run.accepted + run.rejected >= run.step_limit)
            return Outcome::step_limit;
        // rather a slightly longer step than a tiny last one
        const bool last = run.t + 1.01 * run.h >= t_end;
        const Real h = last ? t_end - run.t : run.h;
        const PairStep<N> step = dormand_prince_step(run.s, run.a, h, a);
        run.evaluations += 6;
        const Real error2 = scaled_error2(step.error, run.s, step.s, tolerance);
        // (1.41); a guess, for which e^(-0.1 log) has digits enough
        const auto factor = [error2] {
            return 0.8 * exp(-0.1 * log(std::min(error2, 1e30)));
        };
        if (error2 <= 1) {
            // Between 0.2 and 0.5 the step is as good as right: no power, and the
            // next step need not wait.
            if (error2 < 0.04 || error2 > 0.25) {
                const Real wanted = h * std::min(factor(), first_try ? 5. : 1.);
                run.h = last ? std::max(wanted, run.h) : wanted;
            }
            run.last = {run.s, step.s, run.a, step.a, h};
            run.s = step.s;
            run.a = step.a;
            run.t = last ? t_end : run.t + h;
            ++run.accepted;
            return Outcome::reached;
        }
        // Too much error: again with less. A NaN or an overflow comes here too.
        ++run.rejected;
        run.h = h * (error2 < infinity ? std::max(0.2, factor()) : 0.2);
        if (!(run.h > smallest))
            return error2 < infinity ? Outcome::step_too_small
                                     : Outcome::not_finite;
    }
}
//! [advance]

/// Steps until t_end [s], not before run.t. The motion of the last step stays in run.last.
/// \throws std::invalid_argument  for a t_end that is not finite or lies in the past
template <int N, Acceleration<N> A>
Outcome integrate(Adaptive<N>& run, Real t_end, const A& a,
                  const Tolerance& tolerance)
{
    require_end(run, t_end);
    Outcome outcome = Outcome::reached;
    while (run.t < t_end && outcome == Outcome::reached)
        outcome = advance(run, t_end, a, tolerance);
    return outcome;
}

}  // namespace rigid
