// The functions of space_scene.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/space_scene.hpp"

namespace rigid {

void require_touching(const SpaceScene& scene)
{
    for (std::size_t i = 0; i < scene.meshes.size(); ++i)
        if (!scene.meshes[i] || scene.meshes[i]->count() == 0)
            throw std::invalid_argument("mesh " + std::to_string(i) +
                                        " of the scene is none; make it by "
                                        "triangle_mesh()");
    if (!scene.meshes.empty() && !scene.ellipsoids.empty())
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.ellipsoids.size()) +
            " ellipsoids and " + std::to_string(scene.meshes.size()) +
            " meshes; an ellipsoid touches walls alone");
    require_touching(static_cast<const RoughSolids&>(scene));
    require_list(scene.mesh_friction, scene.meshes.size(), "meshes",
                 "friction coefficient");
}

}  // namespace rigid
