// The functions of walled_solids.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/23_faces_that_touch/walled_solids.hpp"

namespace rigid {

void require_touching(const WalledSolids& scene)
{
    for (std::size_t w = 0; w < scene.walls.size(); ++w)
        if (!(std::abs(scene.walls[w].normal.norm() - 1) <= 1e-9) ||
            !std::isfinite(scene.walls[w].offset))
            throw std::invalid_argument(
                "wall " + std::to_string(w) + " has a normal of the length " +
                shortest(scene.walls[w].normal.norm()) + " and the offset " +
                shortest(scene.walls[w].offset) +
                " m; the length must be 1, the offset finite");
}

}  // namespace rigid
