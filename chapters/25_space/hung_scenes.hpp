/// \file hung_scenes.hpp
/// What hangs: Newton's cradle, and chains of plates on hinges or with a heavy end; with what is known of them by hand.
#pragma once

#include "chapters/25_space/joint_makers.hpp"
#include "common/elementary.hpp"

namespace rigid {

/// A thin rod between two points, both in the axes of a shape.
inline Hull rod_between(const Vec3& from, const Vec3& to, Real radius)
{
    return {{from, to}, {}, radius};
}

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

SpaceScene newtons_cradle(const Cradle& cradle);

/// The speed at which a lifted ball meets the next, from ½ (m l² + I) ω² = m g l (1 − cos α) [m/s].
inline Real meeting_speed(const Cradle& cradle, Real g = 9.81)
{
    const Real l = cradle.length,
               about_hook = l * l + 0.4 * cradle.radius * cradle.radius;
    return l * std::sqrt(2 * g * l * (1 - cos(cradle.lift)) / about_hook);
}

/// Plates of 1 m, end to end on hinges across their length, from a point: the first level. What moves them across their
/// plane, the hinges hold.
/// \param aside  speed of the last across the plane of the motion [m/s]
SpaceScene plate_chain(int plates, Real aside);

/// Links of 1 kg and 0.2 m on ball joints, and a ball of so much more at the end,
/// released at 30° from the vertical.
SpaceScene heavy_chain(int links, Real end_mass);

}  // namespace rigid
