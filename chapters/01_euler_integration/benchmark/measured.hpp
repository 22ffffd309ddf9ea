/// \file measured.hpp
/// What is measured of this chapter: three problems with exact answers, and every method under its name.
#pragma once

#include "chapters/01_euler_integration/adaptive.hpp"
#include "chapters/01_euler_integration/exact.hpp"

#include <string>

namespace rigid {

/// What has to be computed: where is the body at time T? The same force twice: for our
/// vectors, and written out in plain numbers for libraries that have their own.
struct KeplerProblem {
    static constexpr int N = 2;
    using A = Kepler;
    A a;
    Real T, e = 0.6;
    State<2> start() const { return kepler_perihelion(a, e); }
    Vec2 exact() const { return exact_kepler(a, e, T).x; }
    static void plain(const double* x, const double*, double* acceleration)
    {
        const double r2 = x[0] * x[0] + x[1] * x[1];
        const double factor = -1 / (r2 * std::sqrt(r2));
        acceleration[0] = factor * x[0];
        acceleration[1] = factor * x[1];
    }
};

struct PendulumProblem {
    static constexpr int N = 1;
    using A = Pendulum;
    A a;
    Real T = 10;
    State<1> start() const { return {Vec<1>(pi / 2), Vec<1>(0)}; }
    Vec<1> exact() const { return exact_pendulum(a, pi / 2, T).x; }
    static void plain(const double* x, const double*, double* acceleration)
    {
        acceleration[0] = -9.81 * std::sin(x[0]);
    }
};

/// A light ball thrown at 30 m/s and 40 degrees, k = 0.02 1/m. No closed form: the
/// reference has 20 digits from a Taylor method in 30-digit arithmetic.
struct ThrowProblem {
    static constexpr int N = 2;
    using A = Projectile;
    A a{0.02};
    Real T = 3;
    State<2> start() const
    {
        return {Vec2(0, 0), 30 * Vec2(std::cos(pi * 2 / 9), std::sin(pi * 2 / 9))};
    }
    Vec2 exact() const { return {41.36367414795186111, 1.2318529699294813}; }
    static void plain(const double*, const double* u, double* acceleration)
    {
        const double drag = 0.02 * std::sqrt(u[0] * u[0] + u[1] * u[1]);
        acceleration[0] = -drag * u[0];
        acceleration[1] = -9.81 - drag * u[1];
    }
};

enum class Method {
    explicit_euler,
    symplectic_euler,
    verlet,
    yoshida4,
    rk4,
    dormand_prince
};
inline constexpr Method all_methods[] = {Method::explicit_euler,
                                         Method::symplectic_euler,
                                         Method::verlet,
                                         Method::yoshida4,
                                         Method::rk4,
                                         Method::dormand_prince};

inline const char* name_of(Method method)
{
    switch (method) {
    case Method::explicit_euler: return "explicit_euler";
    case Method::symplectic_euler: return "symplectic_euler";
    case Method::verlet: return "verlet";
    case Method::yoshida4: return "yoshida4";
    case Method::rk4: return "rk4";
    case Method::dormand_prince: return "dormand_prince";
    }
    return "";
}

inline Index evaluations_per_step(Method method)
{
    switch (method) {
    case Method::yoshida4: return 3;
    case Method::rk4: return 4;
    case Method::dormand_prince: return 6;
    default: return 1;
    }
}

template <class A, int N>
constexpr bool can(Method method)
{
    return PositionAcceleration<A, N> ||
           (method != Method::verlet && method != Method::yoshida4);
}

/// Every measured loop is a function of its own, as it would be in the reader's program.
#if defined(__GNUC__)
#define RIGID_SEPARATE [[gnu::noinline]]
#else
#define RIGID_SEPARATE
#endif

/// `steps` equal steps of h.
template <Method method, int N, class A>
RIGID_SEPARATE State<N> run_method(const State<N>& s, Real h, Index steps,
                                   const A& a)
{
    if constexpr (method == Method::explicit_euler)
        return march(s, h, steps, [a](const State<N>& y, Real step) {
            return explicit_euler(y, step, a);
        });
    if constexpr (method == Method::symplectic_euler)
        return march(s, h, steps, [a](const State<N>& y, Real step) {
            return symplectic_euler(y, step, a);
        });
    if constexpr (method == Method::rk4)
        return march(s, h, steps,
                     [a](const State<N>& y, Real step) { return rk4(y, step, a); });
    if constexpr (method == Method::dormand_prince) {
        Vec<N> now = acceleration(a, s);
        return march(s, h, steps, [a, now](const State<N>& y, Real step) mutable {
            const PairStep<N> next = dormand_prince_step(y, now, step, a);
            now = next.a;
            return next.s;
        });
    }
    if constexpr (PositionAcceleration<A, N> && method == Method::verlet) {
        Vec<N> now = a(s.x);
        return march(s, h, steps, [a, now](const State<N>& y, Real step) mutable {
            return velocity_verlet(y, now, step, a);
        });
    }
    if constexpr (PositionAcceleration<A, N> && method == Method::yoshida4)
        return march(s, h, steps, [a](const State<N>& y, Real step) {
            return yoshida4(y, step, a);
        });
    throw std::invalid_argument(
        std::string(name_of(method)) +
        " does not take forces that depend on the velocity");
}

template <int N, class A>
State<N> run_fixed(Method method, const State<N>& s, Real h, Index steps,
                   const A& a)
{
    switch (method) {
    case Method::explicit_euler:
        return run_method<Method::explicit_euler>(s, h, steps, a);
    case Method::symplectic_euler:
        return run_method<Method::symplectic_euler>(s, h, steps, a);
    case Method::verlet: return run_method<Method::verlet>(s, h, steps, a);
    case Method::yoshida4: return run_method<Method::yoshida4>(s, h, steps, a);
    case Method::rk4: return run_method<Method::rk4>(s, h, steps, a);
    case Method::dormand_prince:
        return run_method<Method::dormand_prince>(s, h, steps, a);
    }
    return s;
}

/// From a prepared start, because the first step is given to odeint, which has none of its
/// own.
template <int N, class A>
RIGID_SEPARATE Adaptive<N> run_adaptive(Adaptive<N> run, Real T, Real tolerance,
                                        const A& a)
{
    const Tolerance allowed{tolerance, tolerance, tolerance};
    if (integrate(run, T, a, allowed) != Outcome::reached)
        throw std::runtime_error("the adaptive run did not arrive");
    return run;
}

template <int N, class A>
Adaptive<N> start_at(const State<N>& s, Real tolerance, const A& a)
{
    Adaptive<N> run = start_adaptive(s, a, {tolerance, tolerance, tolerance});
    run.step_limit = 100'000'000;
    return run;
}

template <int N, class A>
Adaptive<N> run_adaptive(const State<N>& s, Real T, Real tolerance, const A& a)
{
    return run_adaptive(start_at(s, tolerance, a), T, tolerance, a);
}

}  // namespace rigid
