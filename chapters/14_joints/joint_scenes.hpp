/// \file joint_scenes.hpp
/// Scenes of this chapter: chains, a bridge, a crane, an Atwood machine, with what is known of them in closed form.
#pragma once

#include "chapters/11_rotation/mechanisms.hpp"
#include "chapters/14_joints/placed_joints.hpp"
#include "common/elementary.hpp"

#include <cmath>

namespace rigid {

/// A row of thin rods on pins from the origin, and a weight at its end. No shape touches another.
struct ChainShape {
    int links = 50;
    Real length = 0.1;  ///< of a link [m]
    Real mass = 0.1;    ///< of a link [kg]
    Real ratio = 1000;  ///< mass of the weight over that of a link
    Real angle = 0;     ///< of the chain from straight down [rad]
};

JointedScene chain_scene(const ChainShape& shape);

/// Rods of equal length that hang between two points at one height: a catenary. Total length 1.25 m, span 1 m, 1 kg.
/// They start on two sides of a triangle, whose tip the middle one of an odd number cuts off.
JointedScene catenary_scene(int rods);

/// Two weights on a rope over a disc of 1 kg that turns with it: racks on a pinion, (14.4).
JointedScene atwood_scene(Real left = 1, Real right = 2);

/// The acceleration of its heavier weight by hand [m/s²].
inline Real atwood_by_hand(Real left = 1, Real right = 2)
{
    return 9.81 * std::abs(right - left) / (left + right + 0.5);
}

/// Planks of 8.4 m together between two banks 8 m apart, on pins: a loop through the world. They start on two sides of a
/// triangle, or three of a trapezium, as above. (Planks of 8 m would lie in line, and no finite pull holds a weight on a straight rope.)
/// \param whole  length of all planks together [m]
JointedScene bridge_scene(int planks, Real mass = 5, Real whole = 8.4);

/// A trolley of 1000 kg on a rail, a rope of thin rods below it, and a load of so many times the mass of a rod.
JointedScene crane_scene(int links, Real ratio, Real speed);

}  // namespace rigid
