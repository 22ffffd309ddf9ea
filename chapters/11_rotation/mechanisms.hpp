/// \file mechanisms.hpp
/// The scenes of this chapter, with the closed forms that they are measured against.
#pragma once

#include "chapters/11_rotation/rigid_method.hpp"
#include "common/elementary.hpp"

#include <span>

namespace rigid {

/// A thin rod of 1 m and 1 kg, its lower left end on the floor, falling at 1 m/s without turning; no gravity.
/// \param angle  to the floor [rad], more than 0 and at most π/2
RigidScene struck_rod(Real angle);

/// λ, v′ and ω′ of that impact by hand, (11.8).
inline Vec<3> struck_rod_by_hand(Real angle, Real e)
{
    const Real arm = -cos(angle) / 2, lambda = (1 + e) / (1 + 12 * arm * arm);
    return {lambda, lambda - 1, 12 * arm * lambda};
}

/// Rods of 1 m and 1 kg in a row, pinned to the origin and to each other, at rest.
/// \param angles  of each from straight down [rad]
RigidScene rod_pendulum(std::span<const Real> angles);

/// The angle of rod k of such a row from straight down [rad].
inline Real rod_angle(const RigidScene& scene, Index k)
{
    return scene.bodies.x[3 * k + 2] + pi / 2;
}

/// A ladder of 2 m and 10 kg between a wall and a floor, both without friction, at rest.
/// \param angle  from the wall [rad]
RigidScene ladder(Real angle);

/// A plank of 4 m and 20 kg pinned in its middle, and two weights on ropes of 0.5 m from its ends.
RigidScene seesaw(Real left, Real right);

/// The angular acceleration of that plank where it lies level, by hand [rad/s²].
inline Real seesaw_by_hand(Real left, Real right)
{
    const Real inertia = 20 * (16 + 0.01) / 12;
    return 9.81 * 2 * (left - right) / (inertia + 4 * (left + right));
}

/// Wheels in a row on pins, each meshing with the next; a motor turns the first. Discs of 10 kg/m².
RigidScene gear_train(std::span<const Real> radii, Real speed, Real torque);

/// What the first wheel feels of all of them, (11.15): Σ I (r₁/r)² [kg m²].
inline Real gear_inertia(std::span<const Real> radii)
{
    Real sum = 0;
    for (const Real r : radii)
        sum += mass_of(disc(r), 10).inertia * (radii[0] / r) * (radii[0] / r);
    return sum;
}

/// A crank of 0.2 m that turns at 10 rad/s whatever happens, a rod of 0.5 m and 1 kg, and a slider on the x axis.
RigidScene slider_crank();

/// x = r cos θ + √(l² − r² sin² θ)
inline Real slider_by_hand(Real theta)
{
    const Real s = 0.2 * sin(theta);
    return 0.2 * cos(theta) + std::sqrt(0.25 - s * s);
}

}  // namespace rigid
