/// \file touching_scenes.hpp
/// Scenes of this chapter. y is up.
#pragma once

#include "chapters/27_particles_and_cloth/cloth_builders.hpp"
#include "chapters/28_cloth_that_touches/touching_cloth.hpp"

namespace rigid {

/// A sheet of so many metres above a ball of half a metre that turns with the given spin about the vertical.
TouchingCloth sheet_on_ball(int squares, Real side, Real stiffness, Real friction,
                            Real spin = 0);

/// A sheet of 2 m above a table of 1 m.
TouchingCloth tablecloth(int squares, Real stiffness, Real friction);

/// A sheet of 2 m, pinned all around or free, and above it a ball (or a box) that can move.
/// \param mass  of the solid [kg]
TouchingCloth catching_sheet(int squares, Real stiffness, Real mass, bool box,
                             bool pinned);

/// A sheet of 1 m that falls on its lower edge and folds on itself, which it must not pass through.
/// \param thickness  against itself [m]; 0: it passes
TouchingCloth folding_sheet(int squares, Real stiffness, Real thickness,
                            Real friction = 0.2);

/// A sheet of so many metres above a ground of triangles: a pit and a hill.
TouchingCloth sheet_on_mesh(int squares, Real side, Real stiffness, Real friction);

/// A walk of 0.6 by 4 m between two walls, and a box that falls on it.
TouchingCloth rope_bridge(int squares, Real stiffness, Real mass);

/// A ball of 0.11 m and so much mass [kg] flies into the net of a goal of 3 by 2 m, which bulges by half a metre and has no pull
/// in its threads at first.
/// \param speed   [m/s]
/// \param border  mass of each particle at the border [kg]; zero: they are pinned
TouchingCloth net_in_goal(int squares, Real stiffness, Real mass, Real speed,
                          Real border = 0);

//! [drum]
/// A rope over half of a fixed drum of half a metre, with so much pull at one end; a winch draws at the other end at
/// 0.05 m/s. Its last spring goes to the winch.
TouchingCloth rope_on_drum(int segments, Real stiffness, Real friction, Real pull);
//! [drum]

/// A flag on a pole that is a body of 1.2 m and so much mass [kg]: its foot is tied to a pin, and three ropes of 300
/// N/m hold its top. \param free  no pin, no ropes, no gravity and no air: it tumbles
TouchingCloth flag_on_pole(int squares, Real stiffness, Real mass, Real wind,
                           bool free = false);

}  // namespace rigid
