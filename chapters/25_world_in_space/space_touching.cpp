// The functions of space_touching.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/space_touching.hpp"

namespace rigid {

void TouchingSolids::require_valid() const
{
    RoughSearch::require_valid();
    if (!(ahead >= 0) || !std::isfinite(ahead))
        throw std::invalid_argument(
            "solids look " + shortest(ahead) +
            " inner radii ahead; it must be zero or positive and finite");
}

/// Of a mesh and a body.
static Grip mesh_grip(const SpaceScene& scene, std::size_t mesh, std::size_t body)
{
    return {both_rough(scene.mesh_friction, mesh, scene.friction, body),
            longer_arm(scene.rolling, body, body),
            longer_arm(scene.spinning, body, body)};
}

void TouchingSolids::touch_meshes(const SpaceScene& scene,
                                  const TouchSettings& near, StepData<6>& now)
{
    ground.boxes = ground.triangles = 0;
    for (Index b = 0; b < scene.bodies.count(); ++b)
        if (looks(b) && scene.bodies.can_move(b)) touch_meshes(scene, b, near, now);
}

void TouchingSolids::touch_meshes(const SpaceScene& scene, Index b,
                                  const TouchSettings& near, StepData<6>& now)
{
    const auto k = static_cast<std::size_t>(b);
    const TouchSettings how{near.margin + ahead_of[k], near.slack};
    Index first = 0;  // below zero: hulls on walls have the others
    for (std::size_t m = 0; m < scene.meshes.size(); ++m)
        for (const PlacedSolid& solid : solids[k]) {
            const TriangleMesh& mesh = *scene.meshes[m];
            const int names = take_names(mesh, *solid.form, ground, first);
            collide(mesh, solid, names, how, room, touch, ground);
            for (std::size_t i = 0; i < ground.count; ++i) {
                touch.normal = ground.manifolds[i].normal;
                keep_four(ground.manifolds[i].points, how.slack, touch);
                std::size_t c = now.contacts.size();
                add(scene, world, b, 0, solid.radius(), first, now);
                for (; c < now.contacts.size(); ++c)
                    now.contacts[c].grip = mesh_grip(scene, m, k);
            }
        }
}

}  // namespace rigid
