/// \file integrators.hpp
/// Fixed time steps: how to get from the state now to the state h seconds later.
///
///     dx/dt = u,   du/dt = a(x, u)
///
/// Every method replaces the two integrals of (1.4) by finite sums: (1.5) explicit Euler,
/// (1.10) symplectic Euler, (1.14) implicit Euler for a linear spring, (1.24) velocity
/// Verlet, (1.28) classical Runge-Kutta, (1.34) Yoshida's fourth-order composition of
/// Verlet steps. A step is a function: state in, next state out. Steps are the inner loop
/// and check nothing; `march` is the door that does. A negative h goes back in time.
/// \cite hairer2006 \cite hairer1993
#pragma once

#include "common/bodies.hpp"
#include "common/text.hpp"

#include <cmath>
#include <concepts>
#include <stdexcept>
#include <string>

namespace rigid {

/// Where a body is and how fast it moves, in N coordinates.
template <int N>
struct State {
    Vec<N> x;  ///< position [m], or angle [rad]
    Vec<N> u;  ///< velocity [m/s], or angular velocity [rad/s]
};

/// An acceleration that depends on the position alone: a(x) [m/s²]. (It has to return the
/// vector itself, not an Eigen expression that still points at its locals.)
template <class A, int N>
concept PositionAcceleration = requires(const A& a, const Vec<N>& x)
{
    {
        a(x)
        } -> std::same_as<Vec<N>>;
};

/// Any acceleration: a(x), or a(x, u) where there is drag.
template <class A, int N>
concept Acceleration = PositionAcceleration<A, N> ||
    requires(const A& a, const Vec<N>& x)
{
    {
        a(x, x)
        } -> std::same_as<Vec<N>>;
};

/// a(x) or a(x, u), whichever the force offers [m/s²]. This is the call that costs, the one
/// to count.
template <int N, Acceleration<N> A>
Vec<N> acceleration(const A& a, const State<N>& s)
{
    if constexpr (PositionAcceleration<A, N>) return a(s.x);
    else return a(s.x, s.u);
}

//! [explicit]
/// (1.5): explicit Euler. Order 1; one evaluation.
template <int N, Acceleration<N> A>
State<N> explicit_euler(State<N> s, Real h, const A& a)
{
    const Vec<N> now = acceleration(a, s);
    s.x += h * s.u;
    s.u += h * now;
    return s;
}
//! [explicit]

//! [symplectic]
/// (1.10): symplectic Euler, the same two lines in the other order. Order 1; one
/// evaluation.
template <int N, Acceleration<N> A>
State<N> symplectic_euler(State<N> s, Real h, const A& a)
{
    const Vec<N> now = acceleration(a, s);
    s.u += h * now;
    s.x += h * s.u;
    return s;
}
//! [symplectic]

//! [implicit]
/// (1.14): implicit Euler for the linear spring a(x) = −ω² x, solved by hand. Order
/// 1.
/// \param omega  angular frequency ω [rad/s]
template <int N>
State<N> implicit_euler_spring(State<N> s, Real h, Real omega)
{
    s.u = (s.u - h * omega * omega * s.x) / (1 + h * h * omega * omega);
    s.x += h * s.u;
    return s;
}
//! [implicit]

/// (1.24): velocity Verlet \cite verlet1967. Order 2; one evaluation, because the
/// acceleration at the end of a step is the one at the start of the next.
/// \param now  a(x) at the state going in; at the state that comes out on return
///             [m/s²]
template <int N, PositionAcceleration<N> A>
State<N> velocity_verlet(State<N> s, Vec<N>& now, Real h, const A& a)
{
    s.u += h / 2 * now;  // half a kick
    s.x += h * s.u;      // a whole drift
    now = a(s.x);
    s.u += h / 2 * now;  // the other half
    return s;
}

//! [yoshida]
/// (1.34): three steps of drift, kick, drift, the middle one backwards, whose
/// errors of third order cancel; drifts that follow each other are one. Order 4;
/// three evaluations.
/// \cite forest1990 \cite yoshida1990
template <int N, PositionAcceleration<N> A>
State<N> yoshida4(State<N> s, Real h, const A& a)
{
    constexpr Real outer = 1.3512071919596576340;  // w = 1 / (2 − 2^(1/3))
    constexpr Real inner = 1 - 2 * outer;
    constexpr Real kicks[] = {outer, inner, outer};
    constexpr Real drifts[] = {outer / 2, (outer + inner) / 2, (inner + outer) / 2};
    for (int i = 0; i < 3; ++i) {
        s.x += drifts[i] * h * s.u;
        s.u += kicks[i] * h * a(s.x);
    }
    s.x += outer / 2 * h * s.u;
    return s;
}
//! [yoshida]

//! [rk4]
/// (1.29): the classical Runge-Kutta method. Order 4; four evaluations. What the
/// last of them gives is added last: the next step waits for it.
template <int N, Acceleration<N> A>
State<N> rk4(const State<N>& s, Real h, const A& a)
{
    const Vec<N> middle = s.x + h / 2 * s.u;
    const Vec<N> end = s.x + h * s.u;
    const Vec<N> a1 = acceleration(a, s);
    const Vec<N> a2 = acceleration(a, State<N>{middle, s.u + h / 2 * a1});
    const Vec<N> a3 =
        acceleration(a, State<N>{middle + h * h / 4 * a1, s.u + h / 2 * a2});
    const Vec<N> a4 = acceleration(a, State<N>{end + h * h / 2 * a2, s.u + h * a3});
    return {end + h * h / 6 * (a1 + a2) + h * h / 6 * a3,
            s.u + h / 6 * (a1 + 2 * (a2 + a3)) + h / 6 * a4};
}
//! [rk4]

/// Throws std::invalid_argument, naming the coordinate and its value, unless the state is
/// finite.
template <int N>
void require_finite(const State<N>& s)
{
    for (Index i = 0; i < N; ++i) {
        if (!std::isfinite(s.x[i]))
            throw std::invalid_argument("the position x[" + std::to_string(i) +
                                        "] is " + shortest(s.x[i]) +
                                        "; it must be a finite number");
        if (!std::isfinite(s.u[i]))
            throw std::invalid_argument("the velocity u[" + std::to_string(i) +
                                        "] is " + shortest(s.u[i]) +
                                        "; it must be a finite number");
    }
}

/// Throws std::runtime_error: the state has grown beyond all numbers within these steps.
[[noreturn]] inline void throw_not_finite(Index steps, Real h)
{
    throw std::runtime_error("the state is no longer finite after " +
                             std::to_string(steps) + " steps of " + shortest(h) +
                             " s; a smaller step may help");
}

/// Takes a number of steps: the door of the fixed-step methods.
/// \param start  where it starts
/// \param h      time step [s], positive
/// \param steps  how many, zero or more
/// \param step   step(s, h) gives the next state
/// \return       the state after `steps` times h seconds
/// \throws std::invalid_argument  for a state that isn't finite, a step or a count that
/// make no sense \throws std::runtime_error     when the state has grown beyond all numbers
/// on the way
template <int N, class Step>
State<N> march(const State<N>& start, Real h, Index steps, Step step)
{
    require_finite(start);
    require_step(h);
    if (steps < 0)
        throw std::invalid_argument("the number of steps is " +
                                    std::to_string(steps) +
                                    "; it must be zero or more");
    // a copy with no other reference to it can stay in registers
    State<N> s = start;
    for (Index n = 0; n < steps; ++n) s = step(s, h);
    if (!s.x.allFinite() || !s.u.allFinite()) throw_not_finite(steps, h);
    return s;
}

}  // namespace rigid
