/// \file rolling_solid.hpp
/// A smooth solid that rolls on a plane without slip: its equation, beside which the step is measured.
///
///     v = r × ω,   (I − m [r]²) ω′ = −ω × Iω + m r × (r′ × ω + ω × (r × ω) + g γ),   γ′ = γ × ω              (24.12)
///
/// All in the body's principal axes: γ is the normal of the plane, r = r(γ) leads to the lowest point (24.11).
#pragma once

#include "chapters/24_friction_is_a_disc/ellipsoid.hpp"

namespace rigid {

/// What rolls: mass, principal moments, surface.
struct RollingSolid {
    Real mass = 1;             ///< [kg]
    Vec3 inertia = {1, 1, 1};  ///< I [kg m²]
    SolidEllipsoid surface;    ///< in the principal axes, its body is not used
    Real gravity = 9.81;       ///< against γ [m/s²]
};

/// (24.12): γ′ and ω′.
/// \param y  γ and ω
Vec<6> rolling_rates(const RollingSolid& solid, const Vec<6>& y);

/// A step of the classical rule of Runge and Kutta.
Vec<6> roll(const RollingSolid& solid, const Vec<6>& y, Real h);

/// Its energy [J], above that of a centroid in the plane.
Real rolling_energy(const RollingSolid& solid, const Vec<6>& y);

}  // namespace rigid
