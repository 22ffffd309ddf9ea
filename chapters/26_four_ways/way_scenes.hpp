/// \file way_scenes.hpp
/// The ten scenes on which the ways are set side by side, each with what is known of its motion.
///
/// Lengths in metres, g = 9.81 m/s². Where a scene has a closed form or an equation of one angle, its error is the distance
/// from that; the chain's end is a number that two ways agree on; the doll has only what is off.
#pragma once

#include "chapters/10_skipping_work/collision_filter.hpp"
#include "chapters/14_joints/joint_scenes.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigid {

//! [scene]
struct WayScene {
    std::string name;
    JointedScene scene;
    CollisionFilter filter;
    Real time = 1;         ///< when the error is measured [s]
    Real stiffness = 1e5;  ///< of springs in place of its constraints [N/m]
    bool keeps_energy = false;
    /// how far it is from the truth after `time` seconds
    std::function<Real(const JointedScene&)> error;
    std::string unit = "m";
};
//! [scene]

/// A bead of 1 kg on a circular wire of 1 m, which is a distance; section 26.1's state.
JointedScene bead_on_a_wire();

/// A rod of 1 m and 1 kg on a pin, from level (A4): its end after 1 s.
WayScene pendulum();
/// Two such rods in a row (R1): the larger error of the two angles, after 1 s.
WayScene double_pendulum();
/// A crank of 0.2 m at 10 rad/s, a rod of 0.5 m, a slider, 1 kg each, no weight (B6): the crank's pin after 1 s.
WayScene slider_crank_loop();
/// Twenty rods of 0.1 m and 0.1 kg and 10 kg at their end, from 20°: the weight after half a second.
WayScene heavy_chain();
/// A block on 30° with μ = 0.3 (G2): the way after 1 s.
WayScene sliding_block();
/// A ball dropped by 1 m with e = 0.8 (D1): its height after 2 s.
WayScene bouncing_ball();
/// Five boxes of 1 m and 1 kg: the largest way of any in 1 s.
WayScene stack_of_five();
/// The rod that jams (13.11), its end sliding to the left at 1 m/s: the speed of the end along the floor after 20 ms [m/s].
WayScene jammed_rod();
/// Five balls in a row, e = 1 (C8): the largest error of a velocity, beside the experiment's, after 0.3 s [m/s].
WayScene newtons_cradle();
/// A doll falls 0.3 m on a floor, turning at 2 rad/s: the largest gap of a joint after 1 s.
WayScene falling_doll();

/// All of them, in this order.
std::vector<WayScene> way_scenes();

/// The end of heavy_chain() at its time: both rows on accelerations and coordinates of joints give these digits.
inline const Vec2 heavy_chain_end{0.339055821089, -2.072334563812};

}  // namespace rigid
