/// \file cloth_scenes.hpp
/// Scenes of this chapter. y is up.
#pragma once

#include "chapters/27_particles_and_cloth/cloth_builders.hpp"

namespace rigid {

/// The example by hand: masses of 1 kg under each other on springs from a pin at the
/// origin, 1 m each, all at rest. Gravity is 10 m/s².
ClothScene hung_masses(int masses, Real stiffness);

/// A level sheet of 1 m, pinned at two corners. \param squares  of a side
ClothScene hung_sheet(int squares, Real stiffness, Real bending = 1e-4);

/// A net of 1 m, threads that do not stretch and no diagonals, pinned at two corners 0.83 m apart: between them it hangs
/// through, in an arc of 120°, all at rest.
ClothScene hung_net(int squares);

//! [strip]
/// A strip of unit length, clamped level at the origin, of EI = 1, along x: a rope with bends, or `rows` rows of squares.
/// The hinge at the wall has half a segment beside it, and twice the stiffness.
ClothScene clamped_strip(int segments);
/// The rope without bends, and springs to each second particle in their place [N/m].
ClothScene clamped_strip_across(int segments, Real stiffness);
/// \param diagonals  stiffness of hinges about diagonals, in those of the others
ClothScene clamped_strip(int segments, int rows, Bending how, bool alternate,
                         Real diagonals = 1);
//! [strip]

/// 1.2 by 0.8 m on a pole, in a wind of so many metres a second.
ClothScene flag(int squares, Real stiffness, Real wind);

/// 1 m wide, 1.4 m long, pinned along its upper edge at every second particle.
ClothScene curtain(int squares, Real stiffness);

/// 1 by 1.6 m, its lower edge ten times as heavy, on two pins that a crane moves.
ClothScene banner(int squares, Real stiffness);

/// A sheet of 1 m that is pinned at two sides, of which one moves away.
ClothScene torn_sheet(int squares, Real stiffness, Real speed);

/// Pull in a spring [N].
Real tension(const ClothScene& cloth, std::size_t spring);

}  // namespace rigid
