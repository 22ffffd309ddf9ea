/// \file gyroscope.hpp
/// A wheel in a gimbal: three hinges, each across the one before, and a weight at the end of the wheel's axis, which does
/// not fall.
#pragma once

#include "chapters/21_joints_in_space/hung_scenes.hpp"

namespace rigid {

/// A ring of rods around an axis of the shape, through the origin.
std::vector<Hull> ring_of_rods(const Vec3& axis, Real radius, Real thick);

struct Gyroscope {
    Real spin = 150;     ///< of the wheel [rad/s]
    Real radius = 0.15;  ///< of the wheel, a disc of 1 kg [m]
    Real weight = 0.2;   ///< [kg]
    Real arm = 0.25;     ///< of the weight from the middle of the wheel [m]
};

/// (21.9): M g l / (I ω) [rad/s].
inline Real precession_of(const Gyroscope& gyroscope, Real g = 9.81)
{
    const Real axial = gyroscope.radius * gyroscope.radius / 2;
    return gyroscope.weight * g * gyroscope.arm / (axial * gyroscope.spin);
}

/// In steady precession. Body 0 is the outer ring, 1 the inner one with the weight, 2 the wheel, whose axis is along x.
JointedSolids gyroscope_in_gimbal(const Gyroscope& gyroscope);

}  // namespace rigid
