/// \file walled_solids.hpp
/// A scene in space with walls to stand on.
#pragma once

#include "chapters/21_joints_in_space/space_joint.hpp"

namespace rigid {

/// The points p with normal·p ≥ offset are free, the others are wall.
struct SolidWall {
    Vec3 normal = {0, 1, 0};  ///< unit vector, out of the wall
    Real offset = 0;          ///< [m]
};

//! [scene]
struct WalledSolids : JointedSolids {
    std::vector<SolidWall> walls;

    using JointedSolids::JointedSolids;
    WalledSolids() = default;
    WalledSolids(JointedSolids scene) : JointedSolids(std::move(scene)) {}
};
//! [scene]

/// Throws std::invalid_argument, with a sentence that names the wall, unless each is one.
void require_touching(const WalledSolids& scene);

}  // namespace rigid
