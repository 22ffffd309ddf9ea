/// \file dormand_prince.hpp
/// One step with two answers: the pair of Dormand and Prince, orders 5 and 4.
///
///     y' = y + h Σ b_i k_i,   err = h Σ e_i k_i
///
/// Seven slopes k_i give an answer of order 5 (1.38) and, for free, one of order 4;
/// their difference (1.39) estimates the error. The seventh slope is the first of the next
/// step, so a step costs six evaluations. What is done with the error is in
/// adaptive.hpp. \cite dormand1980
#pragma once

#include "chapters/01_euler_integration/integrators.hpp"

namespace rigid {

/// dy/dt of the state y = (x, u), which is (u, a), and sums of such pairs.
template <int N>
struct Slope {
    Vec<N> u, a;
    friend Slope operator+(const Slope& p, const Slope& q)
    {
        return {p.u + q.u, p.a + q.a};
    }
    friend Slope operator*(Real c, const Slope& p) { return {c * p.u, c * p.a}; }
    friend Slope operator-(const Slope& p, const Slope& q)
    {
        return {p.u - q.u, p.a - q.a};
    }
    friend State<N> operator+(const State<N>& s, const Slope& p)
    {
        return {s.x + p.u, s.u + p.a};
    }
    friend State<N> operator-(const State<N>& s, const Slope& p)
    {
        return {s.x - p.u, s.u - p.a};
    }
};

/// One step of the pair, not yet judged.
template <int N>
struct PairStep {
    State<N> s;      ///< the answer of order 5
    Vec<N> a;        ///< a(s), the first slope of the next step
    Slope<N> error;  ///< (1.39): the difference to the answer of order 4 [m, m/s]
};

//! [pair]
/// (1.38) and (1.39): one step of Dormand and Prince's pair. Six evaluations.
/// \param now  a(s) [m/s²], the last slope of the step before
template <int N, Acceleration<N> A>
PairStep<N> dormand_prince_step(const State<N>& s, const Vec<N>& now, Real h,
                                const A& a)
{
    const auto slope = [&a](const State<N>& y) {
        return Slope<N>{y.u, acceleration(a, y)};
    };
    const Slope<N> k1{s.u, now};
    const Slope<N> k2 = slope(s + 1. / 5 * h * k1);
    const Slope<N> k3 = slope(s + 3. / 40 * h * k1 + 9. / 40 * h * k2);
    const Slope<N> k4 =
        slope(s + 44. / 45 * h * k1 - 56. / 15 * h * k2 + 32. / 9 * h * k3);
    const Slope<N> k5 = slope(s + 19372. / 6561 * h * k1 - 25360. / 2187 * h * k2 +
                              64448. / 6561 * h * k3 - 212. / 729 * h * k4);
    const Slope<N> k6 =
        slope(s + 9017. / 3168 * h * k1 - 355. / 33 * h * k2 +
              46732. / 5247 * h * k3 + 49. / 176 * h * k4 - 5103. / 18656 * h * k5);
    const State<N> y = s + 35. / 384 * h * k1 + 500. / 1113 * h * k3 +
                       125. / 192 * h * k4 - 2187. / 6784 * h * k5 +
                       11. / 84 * h * k6;
    const Slope<N> k7 = slope(y);
    return {y, k7.a,
            71. / 57600 * h * k1 - 71. / 16695 * h * k3 + 71. / 1920 * h * k4 -
                17253. / 339200 * h * k5 + 22. / 525 * h * k6 - 1. / 40 * h * k7};
}
//! [pair]

}  // namespace rigid
