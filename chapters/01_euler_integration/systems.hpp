/// \file systems.hpp
/// The four things that move in this chapter: acceleration and energy, for one kilogram.
///
/// Each is a callable that the integrators take, with its energy beside it. What is known
/// exactly of their motion is in exact.hpp.
#pragma once

#include "chapters/01_euler_integration/integrators.hpp"
#include "common/elementary.hpp"

#include <cmath>

namespace rigid {

//! [spring]
/// A mass on a linear spring: a(x) = −ω² x.
struct Spring {
    Real omega = 1;  ///< angular frequency ω = √(stiffness / mass) [rad/s]

    Vec<1> operator()(const Vec<1>& x) const { return -omega * omega * x; }

    /// ½u² + ½ω²x² [J/kg]
    Real energy(const State<1>& s) const
    {
        return (s.u.squaredNorm() + omega * omega * s.x.squaredNorm()) / 2;
    }
};
//! [spring]

/// A pendulum, its angle counted from straight down: a(θ) = −(g/L) sin θ. A uniform rod of
/// length l that turns about its end is the pendulum with L = 2l/3.
struct Pendulum {
    Real g = 9.81;    ///< [m/s²]
    Real length = 1;  ///< L [m]

    Vec<1> operator()(const Vec<1>& x) const
    {
        return Vec<1>(-g / length * sin(x[0]));
    }

    /// ½L²u² − gL cos θ [J/kg], zero for a pendulum at rest on the level of its pivot
    Real energy(const State<1>& s) const
    {
        return length * length * s.u.squaredNorm() / 2 - g * length * cos(s.x[0]);
    }
};

/// A planet around a sun at rest in the origin: a(x) = −GM x / |x|³.
struct Kepler {
    Real GM = 1;  ///< gravitational constant times the sun's mass [m³/s²]

    Vec2 operator()(const Vec2& x) const
    {
        const Real r2 = x.squaredNorm();
        return -GM / (r2 * std::sqrt(r2)) * x;
    }

    /// ½u² − GM/|x| [J/kg]
    Real energy(const State<2>& s) const
    {
        return s.u.squaredNorm() / 2 - GM / s.x.norm();
    }

    /// x × u [m²/s], constant because the force points at the sun
    Real angular_momentum(const State<2>& s) const { return cross2(s.x, s.u); }
};

/// A throw with quadratic drag: a(u) = g − k |u| u.
struct Projectile {
    /// k = ½ · density of air · drag coefficient · area / mass [1/m]
    Real drag = 0;
    Vec2 gravity = {0, -9.81};  ///< g [m/s²]

    Vec2 operator()(const Vec2&, const Vec2& u) const
    {
        return gravity - drag * u.norm() * u;
    }

    /// ½u² − g·x [J/kg]; drag takes from it
    Real energy(const State<2>& s) const
    {
        return s.u.squaredNorm() / 2 - gravity.dot(s.x);
    }
};

/// An acceleration that counts its evaluations: the work of a method, the same on
/// every machine.
template <class A>
struct Counted {
    A a;
    mutable Index evaluations = 0;

    template <int N>
    requires PositionAcceleration<A, N> Vec<N>
    operator()(const Vec<N>& x) const
    {
        ++evaluations;
        return a(x);
    }
    template <int N>
    requires(!PositionAcceleration<A, N>) Vec<N>
    operator()(const Vec<N>& x, const Vec<N>& u) const
    {
        ++evaluations;
        return a(x, u);
    }
};
template <class A>
Counted(A) -> Counted<A>;

}  // namespace rigid
