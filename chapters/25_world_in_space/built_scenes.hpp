/// \file built_scenes.hpp
/// What is built of boxes and stands until something knocks it over: a brick wall with a wrecking ball, a tower of cards.
#pragma once

#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"
#include "chapters/25_world_in_space/cradle.hpp"
#include "chapters/25_world_in_space/space_scene.hpp"

namespace rigid {

// What a scene cannot be made of gets std::invalid_argument: no row, a mass of zero.

/// Bricks of 45 kg in rows, each row half a brick beside the one below.
SpaceScene brick_wall(int rows, int columns, Real mu);

/// A ball of 1000 kg on a chain of links of 5 kg. It hangs at the wall's face.
struct WreckingBall {
    int links = 8;
    Real lift = 1;           ///< from the vertical [rad]
    Real height = 0.8;       ///< of the ball at its lowest [m]
    Real face = -0.125;      ///< z of the wall's face
    Real radius = 0.35;      ///< [m]
    Real mass = 1000;        ///< [kg]
    Real link_length = 0.4;  ///< [m]
};

/// Adds the chain and the ball, which is the last body.
void add_wrecking_ball(SpaceScene& scene, const WreckingBall& ball, Real mu);

/// Cards of 1 m × 2 cm × 0.7 m, two and two leaning at each other, with cards across
/// their tops, storey on storey.
/// \param lean  of a card from upright [rad]
SpaceScene card_tower(int storeys, Real lean, Real mu);

}  // namespace rigid
