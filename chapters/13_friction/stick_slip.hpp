/// \file stick_slip.hpp
/// A block on a belt, held back by a spring: it sticks and slips by turns, and both can be computed by hand.
///
///     sticks  2 (μ_s − μ_k) m g / (k v),   slips  (2/ω) (π − arctan((μ_s − μ_k) g / (ω v))),   ω² = k/m          (13.18)
///     stretch  μ_k m g / k ± √(((μ_s − μ_k) m g / k)² + (v/ω)²)                                                   (13.19)
#pragma once

#include "chapters/13_friction/friction_solver.hpp"
#include "common/elementary.hpp"

namespace rigid {

//! [stick_slip]
struct StickSlip {
    Real mass = 1;        ///< [kg]
    Real stiffness = 40;  ///< [N/m]
    Real belt = 0.3;      ///< to the right [m/s]
    Real mu_s = 0.6, mu_k = 0.4;
    Real g = 9.81;  ///< [m/s²]
};

/// The cycle by hand, (13.17) to (13.19).
struct StickSlipByHand {
    Real omega;           ///< of the block on its spring [1/s]
    Real balance;         ///< the stretch that sliding friction holds [m]
    Real beyond;          ///< how far beyond it the block begins to slip [m]
    Real sticks, slips;   ///< times [s]
    Real largest, least;  ///< stretch [m]

    explicit StickSlipByHand(const StickSlip& s)
        : omega(std::sqrt(s.stiffness / s.mass)),
          balance(s.mu_k * s.mass * s.g / s.stiffness),
          beyond((s.mu_s - s.mu_k) * s.mass * s.g / s.stiffness),
          sticks(2 * beyond / s.belt),
          slips(2 / omega * (pi - atan(beyond * omega / s.belt))),
          largest(balance + hypot(beyond, s.belt / omega)),
          least(balance - hypot(beyond, s.belt / omega))
    {
    }

    Real period() const { return sticks + slips; }

    /// The stretch at any time, if the block begins at zero with the belt.
    Real stretch(const StickSlip& s, Real t) const
    {
        const Real first = (balance + beyond) / s.belt;
        if (t <= first) return s.belt * t;
        const Real since = std::fmod(t - first, period());
        return since < slips ? balance + beyond * cos(omega * since) +
                                   s.belt / omega * sin(omega * since)
                             : balance - beyond + s.belt * (since - slips);
    }
};
//! [stick_slip]

/// The scene: body 0 is the block, x[0] the stretch of its spring. It begins at zero with the belt.
inline RoughScene block_on_belt(const StickSlip& s)
{
    RoughScene scene;
    scene.gravity = {0, -s.g};
    scene.walls.push_back({{0, 1}, 0});
    const Real width = 0.4, height = 0.2;
    add_body(scene, box(width, height), s.mass / (width * height), {0, height / 2});
    scene.bodies.u[0] = s.belt;
    PointJoint spring;
    spring.measure = PointJoint::Measure::along;
    spring.at_a = {0, height / 2};
    spring.kind = ConstraintKind::spring;
    spring.stiffness = s.stiffness;
    scene.joints.push_back(spring);
    cover(scene, {.friction = s.mu_s, .kinetic = s.mu_k});
    // a positive belt runs to the left over a floor
    scene.wall_surfaces[0].belt = -s.belt;
    return scene;
}

}  // namespace rigid
