/// \file water_scenes.hpp
/// Scenes of this chapter: boxes, a boat, a raft on pins and a duck, each afloat on a pond.
#pragma once

#include "chapters/14_joints/placed_joints.hpp"
#include "chapters/29_waves/floating.hpp"

namespace rigid {

/// Bodies, joints and the water that they float on. The water's ends are walls of the scene, too.
struct WaterScene {
    JointedScene scene;
    ShallowWater water;
};

/// A pond between two walls, `depth` deep, over a level ground at the height 0.
WaterScene pond(Index cells, Real length, Real depth);

/// A uniform box of so many times its height in width, upright and in balance, tilted by an angle. \return its number
Index add_floating_box(WaterScene& pond, Real x, Real height, Real ratio, Real part,
                       Real tilt);

/// A hull of 2.4 m with ballast low in it and a mast that is welded on.
/// \return  the number of its hull
Index add_boat(WaterScene& pond, Real x);

/// So many planks of 0.7 m on pins, a chain that lies on the water. Throws std::invalid_argument for fewer than one.
/// \return  the number of the first
Index add_raft(WaterScene& pond, Real x, int planks);

/// A body, a head and a beak.
/// \return  the number of its body
Index add_duck(WaterScene& pond, Real x);

}  // namespace rigid
