/// \file tossed.hpp
/// The scenes of this chapter: what is tossed, what spins on a point, what hangs on joints.
#pragma once

#include "chapters/25_space/joint_makers.hpp"
#include "common/elementary.hpp"

namespace rigid {

/// A book of 0.7 kg, 16 × 24 × 4 cm, that turns about its middle axis, and a hair
/// about the others. No gravity: we fly with it.
/// \param tilt  spin about the other two axes, as a part of ω
SpaceScene tossed_book(Real omega, Real tilt);

/// A handle with a bar across its end, of steel, that spins about the handle: its middle axis.
SpaceScene t_handle(Real omega, Real tilt);

/// A disc of mass 1 kg and radius r on a pin of the length l without mass, its tip on the ground, in steady precession.
struct TopShape {
    Real radius = 0.15, length = 0.2, spin = 60, tilt = pi / 6;
};

/// (25.28): the rate of slow steady precession [rad/s].
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

/// A thin plate with the moments 1, 2 and 3 kg m², which starts with ω = (½, 0, 1): beside it there is (25.16).
SpaceScene spinning_plate();

SpaceScene spinning_top(const TopShape& top);

/// Rods of 1 m, end to end, from a point: ball joints and constant-velocity joints by turns, the first rod level.
SpaceScene rod_chain(int rods);

/// A door of 0.8 × 2 m and 20 kg on a hinge, with stops at ±`stop`, that a motor
/// drives to and fro.
SpaceScene driven_door(Real speed, Real torque, Real stop);

}  // namespace rigid
