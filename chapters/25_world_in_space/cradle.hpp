/// \file cradle.hpp
/// Newton's cradle, with what is known of it by hand.
#pragma once

#include "chapters/21_joints_in_space/hung_scenes.hpp"

namespace rigid {

/// Balls of 1 kg that hang side by side, each on a rod of 1 m without mass, which a
/// hinge holds.
struct Cradle {
    int balls = 5;
    int lifted = 1;      ///< so many of them to the left
    Real lift = 0.5;     ///< [rad]
    Real gap = 0.002;    ///< between two that hang at rest [m]
    Real radius = 0.06;  ///< [m]
    Real length = 1;     ///< of a rod [m]
};

/// \throws std::invalid_argument  for no ball, more lifted than there are, a length or a
///                                radius that is not positive, a gap below zero
JointedSolids newtons_cradle(const Cradle& cradle);

/// The speed at which a lifted ball meets the next, from ½ (m l² + I) ω² = m g l (1 − cos α) [m/s].
inline Real meeting_speed(const Cradle& cradle, Real g = 9.81)
{
    const Real l = cradle.length,
               about_hook = l * l + 0.4 * cradle.radius * cradle.radius;
    return l * std::sqrt(2 * g * l * (1 - cos(cradle.lift)) / about_hook);
}

}  // namespace rigid
