/// \file car.hpp
/// A car: a box on four wheels. One joint holds a wheel, up and down on a strut and around its axle: a slider and a
/// hinge at once.
///
///     strut   F = −k C − d Ċ      C the wheel's way up along the strut     (25.10)
#pragma once

#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"
#include "chapters/25_world_in_space/space_scene.hpp"

namespace rigid {

struct Car {
    Real mass = 1000, wheel_mass = 20;  ///< [kg]
    Real radius = 0.32;                 ///< of a wheel [m]
    Real sink = 0.08;    ///< how far its weight presses the struts [m]
    Real damping = 0.3;  ///< of a strut under its quarter; 1 is critical
    Real torque = 120;   ///< of the motor of each wheel, at most [N m]
    Real speed = 5;      ///< that the motors drive at [m/s]

    Real stiffness(Real g = 9.81) const { return mass * g / (4 * sink); }
    Real resistance() const  ///< d [N s/m]
    {
        return damping * std::sqrt(stiffness() * mass);
    }
};

// A car that is none, such as one without mass, gets std::invalid_argument.

/// Body 0 is the box, at the height at which its struts are not pressed; then come the
/// wheels, and joint i holds wheel i + 1.
SpaceScene car_on_floor(const Car& car, Real mu);

/// (25.10) of the four struts, for a step of length h that comes after it. A step longer
/// than 2 m/d of a wheel is unstable: with the values above, 1/42 s.
/// \throws std::invalid_argument  for a scene that does not begin with a car, and a step
///                                that is not positive
void push_struts(SpaceScene& scene, const Car& car, Real h);

/// Sleepers across the way of the car, that cannot move.
inline void add_bumps(SpaceScene& scene, int bumps, Real height, Real mu)
{
    const Index first = scene.bodies.count();
    for (int i = 0; i < bumps; ++i)
        add_body(scene, {solid_box({0.4, 2 * height, 1.6})}, SolidMass{},
                 {4 + 2.0 * i, 0, i % 2 == 0 ? -1.0 : 1.0});
    give_friction(scene, first, mu);
}

}  // namespace rigid
