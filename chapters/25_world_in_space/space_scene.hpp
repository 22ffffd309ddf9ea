/// \file space_scene.hpp
/// A scene in space with all that this part of the book knows: bodies, joints, walls, surfaces, and grounds of triangles.
#pragma once

#include "chapters/24_friction_is_a_disc/rough_solids.hpp"
#include "chapters/25_world_in_space/triangle_mesh.hpp"

#include <memory>

namespace rigid {

//! [scene]
struct SpaceScene : RoughSolids {
    std::vector<std::shared_ptr<const TriangleMesh>> meshes;
    std::vector<Real> mesh_friction;  ///< μ of each; empty: none has any

    using RoughSolids::RoughSolids;
    SpaceScene() = default;
    SpaceScene(RoughSolids scene) : RoughSolids(std::move(scene)) {}
};
//! [scene]

/// Throws std::invalid_argument, with a sentence that names the thing, unless walls, meshes, surfaces and ellipsoids make
/// sense, and no ellipsoid could fall through a mesh.
void require_touching(const SpaceScene& scene);

}  // namespace rigid
