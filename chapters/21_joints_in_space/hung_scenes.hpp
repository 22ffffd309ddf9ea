/// \file hung_scenes.hpp
/// What spins on a point and what hangs: a top, a door, chains of rods, of plates on hinges, and with a heavy end; with what
/// is known of them by hand.
#pragma once

#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "common/elementary.hpp"

namespace rigid {

/// A thin rod between two points, both in the axes of a shape.
inline Hull rod_between(const Vec3& from, const Vec3& to, Real radius)
{
    return {{from, to}, {}, radius};
}

/// A disc of mass 1 kg and radius r on a pin of the length l without mass, its tip on the ground, in steady precession.
struct TopShape {
    Real radius = 0.15, length = 0.2, spin = 60, tilt = pi / 6;
};

/// (21.8): the rate of slow steady precession [rad/s], of the sign of the spin.
/// \param pivot  moment of inertia across the axis, about the tip [kg m²]
/// \param axial  moment about the axis
Real slow_precession(Real pivot, Real axial, Real spin, Real weight_arm, Real tilt);

/// The same of a top.
inline Real precession_of(const TopShape& top)
{
    const Real axial = top.radius * top.radius / 2;
    return slow_precession(axial / 2 + top.length * top.length, axial, top.spin,
                           9.81 * top.length, top.tilt);
}

JointedSolids spinning_top(const TopShape& top);

/// Rods of 1 m, end to end, from a point: ball joints and constant-velocity joints by turns, the first rod level. Of no
/// rod, as of no plate below: std::invalid_argument.
JointedSolids rod_chain(int rods);

/// A door of 0.8 × 2 m and 20 kg on a hinge, with stops at ±`stop`, that a motor
/// drives to and fro.
JointedSolids driven_door(Real speed, Real torque, Real stop);

/// Plates of 1 m, end to end on hinges across their length, from a point: the first level. What moves them across their
/// plane, the hinges hold.
/// \param aside  speed of the last across the plane of the motion [m/s]
JointedSolids plate_chain(int plates, Real aside);

/// Links of 1 kg and 0.2 m on ball joints, and a ball of so much more at the end,
/// released at 30° from the vertical.
JointedSolids heavy_chain(int links, Real end_mass);

}  // namespace rigid
