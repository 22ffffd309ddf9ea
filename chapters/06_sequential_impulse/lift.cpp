// The functions of lift.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/06_sequential_impulse/lift.hpp"

namespace rigid {

void add_lift(DiscScene& scene, const Lift& lift)
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
