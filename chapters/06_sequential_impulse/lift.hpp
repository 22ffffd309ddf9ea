/// \file lift.hpp
/// A lift, made of joints that are rows with other bounds and biases: a rail, a motor, two stops.
#pragma once

#include "common/scenes.hpp"

#include <vector>

namespace rigid {

struct Lift {
    Index body = 0;
    Real shaft = 0;          ///< x of the shaft [m]
    Real low = 0, high = 1;  ///< y of the stops [m]
    Real speed = 1;          ///< that the motor is set to [m/s], upwards
    Real force = 0;          ///< that it has [N]
};

/// A body in a vertical shaft with a motor between two stops: four joints that chapter 2 has all the geometry for.
inline void add_lift(DiscScene& scene, const Lift& lift)
{
    //! [lift]
    using enum Joint::Kind;
    const Vec2 across(1, 0), up(0, 1);
    scene.joints.push_back({rail, world, lift.body, across, lift.shaft, 0, 0});
    scene.joints.push_back(
        {motor, world, lift.body, up, 0, lift.speed, lift.force});
    // below: y ≥ low
    scene.joints.push_back({stop, world, lift.body, up, lift.low, 0, 0});
    // above: −y ≥ −high
    scene.joints.push_back({stop, world, lift.body, -up, -lift.high, 0, 0});
    //! [lift]
}

}  // namespace rigid
