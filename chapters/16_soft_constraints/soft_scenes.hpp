/// \file soft_scenes.hpp
/// Scenes of this chapter: masses on springs, nets of springs, a wheel on a spring, and loads that are hard to hold.
#pragma once

#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/13_friction/surfaces.hpp"
#include "chapters/14_joints/placed_joints.hpp"
#include "chapters/16_soft_constraints/softness.hpp"

namespace rigid {

/// Adds a spring along a direction that stays: C = n·(p_b − p_a) − length, linear in the positions.
void add_linear_spring(RigidScene& scene, Index a, Index b, const Vec2& n,
                       Real length, const SpringConstants& spring);

/// Masses under each other on springs from the origin, each at the rest of its spring, 1 m apart.
JointedScene hanging_masses(const std::vector<Real>& masses,
                            const SpringConstants& spring);

/// A net of discs on springs between neighbours, along both sides and both diagonals.
struct Net {
    int columns = 12, rows = 8;
    Real spacing = 0.25;  ///< [m]
    Real mass = 0.1;      ///< of a disc [kg]
    SpringConstants spring{2000, 2};
    Vec2 corner = {0, 0};  ///< of the disc at the lower left [m]
};

/// \return  the number of its first body; row by row from the corner up
Index add_net(JointedScene& scene, const Net& net);

/// A body of springs above a floor.
JointedScene soft_body(const Net& net);

/// A net that hangs on its two upper corners.
JointedScene hung_net(const Net& net);

/// A quarter of a car: a body of 400 kg over a wheel of 40 kg on a floor, which is a spring too.
/// \param how  of the body on its spring
JointedScene quarter_car(const Softness& how, Real lift);

/// Boxes of 1 m and 1 kg, and on top of them one of the same size and so many times the mass.
JointedScene heavy_top(int boxes, Real ratio);

/// Boxes of 1 m by 0.5 m and 0.5 kg on pins in a row from the origin, level, and a weight at the end.
JointedScene box_chain(int boxes, Real weight);

}  // namespace rigid
