// The functions of free_solids.hpp, and its step.
#include "common/eigen_instances.hpp"

#include "chapters/20_turning_in_space/free_solids.hpp"

namespace rigid {

void require_valid(const StepSettings& settings, const Vec3& gravity, Index bodies)
{
    if (!gravity.allFinite()) throw std::invalid_argument("gravity is not finite");
    require_valid(settings, Vec2(0, 0), bodies);
    if (settings.pulled != world)
        throw std::invalid_argument(
            "a hand in the plane of the picture pulls no body in space");
}

void require_bodies(const SolidScene& scene)
{
    require_valid(scene.bodies);
    const Index count = scene.bodies.count();
    if (static_cast<Index>(scene.shapes.size()) != count)
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.shapes.size()) +
            " shapes and " + std::to_string(count) + " bodies; each needs its own");
}

//! [forces]
void free_velocities(SolidScene& scene, const StepSettings& settings,
                     StepData<6>& now)
{
    Bodies<6>& bodies = scene.bodies;
    now.u_star = bodies.u;
    for (const int k : now.active) {
        bodies.force(k).setZero();
        const Real inverse_mass = bodies.inverse_mass[6 * k];
        if (!(inverse_mass > 0)) continue;
        bodies.force(k).head<3>() = scene.gravity / inverse_mass;
        now.u_star.segment<6>(6 * k) +=
            settings.part() * bodies.apply_inverse_mass(k, bodies.force(k));
    }
}
//! [forces]

template void step(SolidScene&, const StepSettings&, FreeFlight&, StepData<6>&);

}  // namespace rigid
