/// \file linkages.hpp
/// Scenes of rods alone whose exact energy never changes: what a step gains or loses is its own doing.
#pragma once

#include "common/measure.hpp"
#include "common/scenes.hpp"

#include <cmath>

namespace rigid {

/// Discs of 1 kg on rods of 1 m, the first rod level to the right of a disc that cannot move, the others straight down
/// from its end: one is a pendulum, two are the double pendulum. Nothing collides.
DiscScene linked_discs(Index count);

/// Two cranks of 1 m on pivots 0.5 m apart, a rod of 1 m between their ends, which are discs of 1 kg. The ground is the
/// shortest side, and 0.5 + 1 < 1 + 1: both cranks turn all the way round (Grashof), and the rods are never in line.
/// \param energy  of the start, by its speed; potential energy is zero at the pivots [J]
DiscScene four_bar(Real energy = 30.9);

/// The chain of ten links that swings from level, but for collisions of its discs.
inline DiscScene free_swinging_chain(Index count = 10)
{
    DiscScene scene = swinging_chain(count);
    scene.linked = PairSet::all();
    return scene;
}

}  // namespace rigid
