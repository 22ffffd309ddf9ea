/// \file sea_scenes.hpp
/// Scenes on water of two directions: boxes, a boat, a raft on ball joints, a duck.
#pragma once

#include "chapters/28_waves/solid_floating.hpp"

namespace rigid {

/// Solids, joints and the water that they float on. The water's walls are walls of the scene, too.
struct SeaScene {
    SpaceScene scene;
    ShallowGrid water;
};

/// Water between four walls, its middle at the origin, over a level ground at the height 0.
SeaScene sea(Index cells, Real side, Real depth);

/// A uniform box in balance, upright, then turned about z by an angle.
/// \return  its number
Index add_floating_box(SeaScene& sea, const Vec3& at, const Vec3& size, Real part,
                       Real tilt);

/// A hull of 2.4 m along x with ballast, a deckhouse and a mast; its bow is at +x.
/// \return  its number
Index add_boat(SeaScene& sea, Real x, Real z);

/// Planks of 0.7 m, so many along x and along z, joined corner to corner by ball joints.
/// \return  the number of the first
Index add_raft(SeaScene& sea, Real x, Real z, int along, int across);

/// A body with a head and a beak, in one piece.
/// \return  its number
Index add_duck(SeaScene& sea, Real x, Real z);

}  // namespace rigid
