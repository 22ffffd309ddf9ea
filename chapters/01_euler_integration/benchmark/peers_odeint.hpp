/// \file peers_odeint.hpp
/// The same methods from Boost.odeint on the same problems, where it is installed.
#pragma once

#include "chapters/01_euler_integration/benchmark/measured.hpp"

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace rigid {

namespace odeint = boost::numeric::odeint;

/// Yoshida's composition in odeint's own frame for such methods, which drifts first and
/// kicks then; the drift that is left over after the third kick is done by hand, because a
/// fourth stage would evaluate a force that is not used. Its mirror image is ours: the same
/// order, cost and size of error.
template <class P>
struct OdeintYoshida {
    static constexpr double outer = 1.3512071919596576340, inner = 1 - 2 * outer;
    odeint::symplectic_nystroem_stepper_base<
        3, 4, P, P, double, P, P, double,
        typename odeint::algebra_dispatcher<P>::algebra_type,
        typename odeint::operations_dispatcher<P>::operations_type,
        odeint::initially_resizer>
        stages{{{outer / 2, (outer + inner) / 2, (outer + inner) / 2}},
               {{outer, inner, outer}}};

    template <class Kick>
    void do_step(const Kick& kick, P& q, P& p, double t, double h)
    {
        stages.do_step(kick, q, p, t, h);
        for (std::size_t i = 0; i < q.size(); ++i) q[i] += outer / 2 * h * p[i];
    }
};

template <class Problem>
struct Odeint {
    static constexpr int N = Problem::N;
    // positions or velocities
    using P = std::array<double, static_cast<std::size_t>(N)>;
    using Y = std::array<double, static_cast<std::size_t>(2 * N)>;  // both

    static Y whole(const State<N>& s)
    {
        Y y;
        for (std::size_t i = 0; i < N; ++i) {
            y[i] = s.x[static_cast<Index>(i)];
            y[i + N] = s.u[static_cast<Index>(i)];
        }
        return y;
    }
    static Vec<N> place(const double* x)
    {
        Vec<N> result;
        for (Index i = 0; i < N; ++i) result[i] = x[i];
        return result;
    }
    static void slope(const Y& y, Y& dydt, double)
    {
        for (std::size_t i = 0; i < N; ++i) dydt[i] = y[i + N];
        Problem::plain(y.data(), y.data() + N, dydt.data() + N);
    }

    template <Method method>
    RIGID_SEPARATE static Vec<N> run_method(const State<N>& s, double h,
                                            Index steps)
    {
        Y y = whole(s);
        P q, p;
        std::copy(y.begin(), y.begin() + N, q.begin());
        std::copy(y.begin() + N, y.end(), p.begin());
        const auto kick = [](const P& x, P& a) {
            Problem::plain(x.data(), x.data(), a.data());
        };
        const auto march_y = [&](auto stepper) {
            for (Index n = 0; n < steps; ++n)
                stepper.do_step(slope, y, static_cast<double>(n) * h, h);
            return place(y.data());
        };
        const auto march_pq = [&](auto stepper) {
            for (Index n = 0; n < steps; ++n)
                stepper.do_step(kick, q, p, static_cast<double>(n) * h, h);
            return place(q.data());
        };
        if constexpr (method == Method::explicit_euler)
            return march_y(odeint::euler<Y>());
        if constexpr (method == Method::rk4)
            return march_y(odeint::runge_kutta4<Y>());
        if constexpr (method == Method::dormand_prince)
            return march_y(odeint::runge_kutta_dopri5<Y>());
        if constexpr (method == Method::symplectic_euler)
            return march_pq(odeint::symplectic_euler<P>());
        if constexpr (method == Method::yoshida4)
            return march_pq(OdeintYoshida<P>());
        if constexpr (method == Method::verlet) {
            odeint::velocity_verlet<P> stepper;
            const auto force = [](const P& x, const P& u, P& a, double) {
                Problem::plain(x.data(), u.data(), a.data());
            };
            for (Index n = 0; n < steps; ++n)
                stepper.do_step(force, std::make_pair(std::ref(q), std::ref(p)),
                                static_cast<double>(n) * h, h);
            return place(q.data());
        }
    }

    static Vec<N> run_fixed(Method method, const State<N>& s, double h, Index steps)
    {
        switch (method) {
        case Method::explicit_euler:
            return run_method<Method::explicit_euler>(s, h, steps);
        case Method::symplectic_euler:
            return run_method<Method::symplectic_euler>(s, h, steps);
        case Method::verlet: return run_method<Method::verlet>(s, h, steps);
        case Method::yoshida4: return run_method<Method::yoshida4>(s, h, steps);
        case Method::rk4: return run_method<Method::rk4>(s, h, steps);
        case Method::dormand_prince:
            return run_method<Method::dormand_prince>(s, h, steps);
        }
        return {};
    }

    RIGID_SEPARATE static Vec<N> run_adaptive(const State<N>& s, double T,
                                              double tolerance, double first)
    {
        Y y = whole(s);
        odeint::integrate_adaptive(
            odeint::make_controlled(tolerance, tolerance,
                                    odeint::runge_kutta_dopri5<Y>()),
            slope, y, 0., T, first);
        return place(y.data());
    }
};

}  // namespace rigid
