/// \file island_scenes.hpp
/// Scenes of this chapter: what stands, what is poured, what hangs together, one beside the other.
#pragma once

#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/14_joints/placed_joints.hpp"

namespace rigid {

/// A scene of chapter 12 with one surface for all.
inline JointedScene rough_scene(const RigidScene& smooth, Real mu = 0.6)
{
    JointedScene scene;
    static_cast<RigidScene&>(scene) = smooth;
    scene.length = 1;
    cover(scene, {mu, 0, 0, 0});
    return scene;
}

/// Boxes of 1 m on a floor, and one of so many times their mass on top.
inline RigidScene loaded_column(int boxes, Real ratio)
{
    RigidScene scene = box_stack(boxes + 1);
    scene.bodies.inverse_mass.tail<3>() /= ratio;
    return scene;
}

/// How many bodies of a pour begin beside each other.
inline int width_of_pour(int bodies)
{
    return std::max(4, static_cast<int>(std::sqrt(bodies)));
}

/// Body i of a pour: a box of 0.5 m by 0.4 m, or, every third, a disc of 0.25 m.
struct PouredBody {
    PouredBody(int i, int wide)
        : rolls(i % 3 == 2), shape(rolls ? disc(0.25) : box(0.5, 0.4)),
          at((i % wide - 0.5 * (wide - 1)) * 0.75 + 0.02 * (i / wide % 3),
             0.5 + 0.75 * (i / wide)),
          angle(0.2 * i)
    {
    }
    bool rolls;
    Polygon shape;
    Vec2 at;
    Real angle;
};

/// The trough of a pour: a floor and two walls.
inline std::vector<HalfSpace> trough_of_pour(int wide)
{
    return {{{0, 1}, 0}, {{1, 0}, -0.4 * wide}, {{-1, 0}, -0.4 * wide}};
}

/// Boxes and discs that are poured into a trough.
/// \param rolling  resistance of the discs [m]
JointedScene poured_scene(int bodies, Real rolling = 0);

/// Discs of 0.2 m on a square net of pins that hangs by its two upper corners: loops of joints.
JointedScene net_scene(int side);

/// Section 18.1: a ball, 100 kg on two boxes of 1 kg, a tower of twenty; a disc flies at the tower and is there after
/// about 1.3 s.
/// \param speed  of the disc [m/s]; 0: there is none
JointedScene struck_tower_scene(Real speed = 15);

/// A heap that is poured, a net on pins, and a pile of five boxes on one floor: joints beside contacts.
/// \param side  bodies of a side of the net
JointedScene mixed_scene(int bodies, int side);

}  // namespace rigid
