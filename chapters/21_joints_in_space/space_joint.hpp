/// \file space_joint.hpp
/// A joint in space as data, two frames and bounds; and a scene that has some.
#pragma once

#include "chapters/20_turning_in_space/solid_scene.hpp"

#include <array>
#include <initializer_list>
#include <utility>
#include <vector>

namespace rigid {

/// What a joint measures, in the axes of its frame in body a: the way from its point in a to its point in b, and the
/// rotation q from a's frame to b's.
enum Coordinate : int {
    along_x,  ///< [m]
    along_y,
    along_z,
    twist,    ///< about x, 2 atan2(q_x, q_w) [rad]
    swing_y,  ///< 2 q_y, for small angles the angle about y
    swing_z,  ///< 2 q_z
    cone,     ///< the angle between both x axes [rad]
    pins,     ///< z_A · y_B, the sine of 90° less the angle between them
    coordinates
};

/// The least and the greatest value that a coordinate can have.
inline std::pair<Real, Real> range_of(Coordinate which)
{
    if (which == twist) return {-pi, pi};
    if (which == swing_y || which == swing_z) return {-2, 2};
    if (which == cone) return {0, pi};
    if (which == pins) return {-1, 1};
    return {-infinity, infinity};
}

//! [joint]
/// A joint in its own coordinates: a frame in either body, and of each coordinate
/// the least and the greatest value. Both the same: it is locked. Infinite: free.
struct SpaceJoint {
    Index a = world, b = 0;
    /// the joint's point in either body's axes; of the world: in its
    Vec3 at_a = {0, 0, 0}, at_b = {0, 0, 0};
    /// rotation vectors: from the joint's axes to those of the body
    Vec3 frame_a = {0, 0, 0}, frame_b = {0, 0, 0};
    std::array<Real, coordinates> lo, hi;
    int motor = -1;             ///< the coordinate that a motor drives; −1: none
    Real speed = 0, force = 0;  ///< of the motor [m/s, N], or [rad/s, N m]

    SpaceJoint() { lo.fill(-infinity), hi.fill(infinity); }
    void lock(std::initializer_list<Coordinate> which)
    {
        for (const Coordinate c : which) {
            const auto i = static_cast<std::size_t>(c);
            lo[i] = hi[i] = 0;
        }
    }
    bool locked(int c) const
    {
        return lo[static_cast<std::size_t>(c)] == hi[static_cast<std::size_t>(c)];
    }
};
//! [joint]

//! [scene]
struct JointedSolids : SolidScene {
    std::vector<SpaceJoint> joints;

    JointedSolids() = default;
    JointedSolids(SolidScene scene) : SolidScene(std::move(scene)) {}
};
//! [scene]

}  // namespace rigid
