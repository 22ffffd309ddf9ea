/// \file slopes.hpp
/// The scenes that this chapter can solve by hand, with their closed forms.
#pragma once

#include "chapters/13_friction/friction_solver.hpp"
#include "common/elementary.hpp"

namespace rigid {

/// A body on a slope that falls to the right, its lowest side or rim on it, at rest; its centroid is over the origin.
/// \param shape    in its own axes; `below` is the distance of its centroid to the slope [m]
/// \param degrees  of the slope
RoughScene on_a_slope(const Polygon& shape, Real below, Real degrees, Real mu);

/// How far the centroid of body 0 has moved down the slope [m].
inline Real down_the_slope(const RoughScene& scene)
{
    const Vec2 n = scene.walls[0].normal;
    return -perpendicular(n).dot(scene.bodies.position(0).head<2>());
}

//! [by_hand]
/// (13.1): the acceleration of a block down a slope; zero where it sticks [m/s²].
inline Real block_by_hand(Real degrees, Real mu, Real g = 9.81)
{
    const Real a = degrees * pi / 180;
    return std::max(Real{0}, g * (sin(a) - mu * cos(a)));
}

/// The same for something round, with κ = I/(m r²): ½ of a disc. It rolls where μ
/// is enough for it, and else slides.
inline Real round_by_hand(Real degrees, Real mu, Real kappa, Real g = 9.81)
{
    const Real a = degrees * pi / 180;
    const bool rolls = mu >= tan(a) * kappa / (1 + kappa);
    return rolls ? g * sin(a) / (1 + kappa) : g * (sin(a) - mu * cos(a));
}

/// When and where a disc that starts to slide at v₀ without spin rolls, and how fast.
struct RollingStart {
    Real t, d, v;  ///< [s, m, m/s]
};
inline RollingStart rolling_start(Real v0, Real mu, Real kappa, Real g = 9.81)
{
    const Real v = v0 / (1 + kappa), t = (v0 - v) / (mu * g);
    return {t, v0 * t - mu * g * t * t / 2, v};
}
//! [by_hand]

/// A disc of 0.5 m on a floor, at the speed v₀ without spin.
RoughScene thrown_disc(Real v0, Real mu);

/// A thin rod of 1 m and 1 kg, its lower left end on the floor, without gravity.
/// \param angle  to the floor [rad]
RoughScene rod_on_end(Real angle, const Vec2& velocity, Real spin, Real mu);

}  // namespace rigid
