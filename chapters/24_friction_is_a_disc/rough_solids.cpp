// The functions of rough_solids.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/rough_solids.hpp"

namespace rigid {

// no strings: what is fine asks for no memory
void require_list(const std::vector<Real>& list, std::size_t count,
                  const char* thing, const char* what)
{
    if (!list.empty() && list.size() != count)
        throw std::invalid_argument("the scene has " + std::to_string(list.size()) +
                                    " " + what + "s for " + std::to_string(count) +
                                    " " + thing +
                                    "; each needs its own, or none has one");
    for (std::size_t i = 0; i < list.size(); ++i)
        if (!(list[i] >= 0) || !std::isfinite(list[i]))
            throw std::invalid_argument("number " + std::to_string(i) + " of the " +
                                        thing + " has the " + what + " " +
                                        shortest(list[i]) +
                                        "; it must be zero or positive and finite");
}

void require_touching(const RoughSolids& scene)
{
    require_touching(static_cast<const WalledSolids&>(scene));
    const std::size_t bodies = scene.shapes.size();
    require_list(scene.friction, bodies, "bodies", "friction coefficient");
    require_list(scene.wall_friction, scene.walls.size(), "walls",
                 "friction coefficient");
    require_list(scene.rolling, bodies, "bodies", "rolling arm");
    require_list(scene.spinning, bodies, "bodies", "spinning arm");
    for (std::size_t i = 0; i < scene.ellipsoids.size(); ++i) {
        const SolidEllipsoid& e = scene.ellipsoids[i];
        if (e.body < 0 || e.body >= scene.bodies.count())
            throw std::invalid_argument("ellipsoid " + std::to_string(i) +
                                        " belongs to body " +
                                        std::to_string(e.body) + " among " +
                                        std::to_string(scene.bodies.count()));
        const Real volume = determinant(e.stretch);
        if (!e.at.allFinite() || !(std::abs(volume) > 0) || !std::isfinite(volume))
            throw std::invalid_argument("ellipsoid " + std::to_string(i) +
                                        " is flat, or not finite");
        // from one of its three radii to the plane of the others, at least
        Real thin = infinity;
        for (Index k = 0; k < 3; ++k)
            thin = std::min(thin, std::abs(volume) /
                                      cross(Vec3(e.stretch.col((k + 1) % 3)),
                                            Vec3(e.stretch.col((k + 2) % 3)))
                                          .norm());
        if (!(thin >= 1 / largest_number && e.stretch.norm() <= largest_number))
            throw std::invalid_argument(
                "ellipsoid " + std::to_string(i) + " is " + shortest(thin) +
                " m thin; its semi-axes must be from 1e-75 to 1e75 m");
    }
}

}  // namespace rigid
