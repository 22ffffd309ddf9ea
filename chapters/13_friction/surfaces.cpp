// The functions of surfaces.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/13_friction/surfaces.hpp"

namespace rigid {

void require_valid(const Surface& surface, std::string_view name, Index number)
{
    const auto refuse = [=](const char* thing, Real value, const char* right) {
        throw std::invalid_argument(
            "the " + std::string(thing) + " of " + std::string(name) +
            (number < 0 ? "" : " " + std::to_string(number)) + " is " +
            shortest(value) + right);
    };
    if (!(surface.friction >= 0) || !std::isfinite(surface.friction))
        refuse("friction coefficient", surface.friction,
               "; it must be zero or positive and finite");
    if (!(surface.restitution >= 0 && surface.restitution <= 1))
        refuse("restitution", surface.restitution, "; it must be from 0 to 1");
    if (!std::isfinite(surface.belt))
        refuse("belt speed", surface.belt, " m/s; it must be finite");
    if (!(surface.rolling >= 0) || !std::isfinite(surface.rolling))
        refuse("rolling arm", surface.rolling,
               " m; it must be zero or positive and finite");
    const auto not_beyond = [&](const char* thing, Real value) {
        if (std::abs(value) > largest_number)
            refuse(thing, value, "; it must not be beyond 1e75");
    };
    not_beyond("friction coefficient", surface.friction);
    not_beyond("belt speed", surface.belt);
    not_beyond("rolling arm", surface.rolling);
    if (!(surface.while_sliding() >= 0 &&
          surface.while_sliding() <= surface.friction))
        refuse("kinetic friction coefficient", surface.while_sliding(),
               ("; it must be from zero to the static one, " +
                shortest(surface.friction))
                   .c_str());
}

void require_valid_surfaces(const RoughScene& scene)
{
    const auto check = [](const std::vector<Surface>& list, std::size_t count,
                          std::string_view thing) {
        if (!list.empty() && list.size() != count)
            throw std::invalid_argument(
                "the scene has " + std::to_string(list.size()) + " surfaces for " +
                std::to_string(count) + (thing == "body" ? " bodies" : " walls") +
                "; each needs its own, or none of them has one");
        for (std::size_t i = 0; i < list.size(); ++i)
            require_valid(list[i], thing, static_cast<Index>(i));
    };
    check(scene.surfaces, scene.shapes.size(), "body");
    check(scene.wall_surfaces, scene.walls.size(), "wall");
    const Cloth& cloth = scene.cloth;
    const auto no_size = [](Real value) {
        return !(value >= 0 && value <= largest_number);
    };
    if (no_size(cloth.friction) || no_size(cloth.arm) || no_size(cloth.gravity))
        throw std::invalid_argument(
            "the cloth has the friction coefficient " + shortest(cloth.friction) +
            ", the arm " + shortest(cloth.arm) + " m and the gravity " +
            shortest(cloth.gravity) + " m/s²; they must be from zero to 1e75");
}

bool has_kinetic_friction(const RoughScene& scene)
{
    const auto weaker = [](const Surface& surface) {
        return surface.while_sliding() < surface.friction;
    };
    return std::any_of(scene.surfaces.begin(), scene.surfaces.end(), weaker) ||
           std::any_of(scene.wall_surfaces.begin(), scene.wall_surfaces.end(),
                       weaker);
}

std::size_t wall_of(const RigidScene& scene, const Vec2& normal, const Vec2& point)
{
    std::size_t nearest = scene.walls.size();
    Real least = infinity;
    for (std::size_t i = 0; i < scene.walls.size(); ++i) {
        const HalfSpace& wall = scene.walls[i];
        // the same to six digits, as lengths of normals are: walls may be nearly
        // parallel
        if (!((wall.normal - normal).squaredNorm() < 1e-11)) continue;
        const Real off = std::abs(wall.normal.dot(point) - wall.offset);
        if (off < least) least = off, nearest = i;
    }
    return nearest;
}

}  // namespace rigid
