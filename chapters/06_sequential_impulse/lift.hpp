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
void add_lift(DiscScene& scene, const Lift& lift);

}  // namespace rigid
