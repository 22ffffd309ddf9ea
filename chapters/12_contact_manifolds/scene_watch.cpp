// The functions of scene_watch.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/12_contact_manifolds/scene_watch.hpp"

namespace rigid {

bool Surroundings::differ(const RigidScene& scene) const
{
    const auto same = [](const HalfSpace& a, const HalfSpace& b) {
        return a.normal == b.normal && a.offset == b.offset;
    };
    return scene.gravity != gravity || scene.chains != chains ||
           !std::equal(walls.begin(), walls.end(), scene.walls.begin(),
                       scene.walls.end(), same);
}

void SceneWatch::remember(const RigidScene& scene)
{
    x = scene.bodies.x;
    u = scene.bodies.u;
    if (!std::exchange(stale, false)) return;
    inverse_mass = scene.bodies.inverse_mass;
    around.remember(scene);
    joints = scene.joints;
    shapes = scene.shapes;
}

}  // namespace rigid
