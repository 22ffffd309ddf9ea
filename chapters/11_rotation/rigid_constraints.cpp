// The functions of rigid_constraints.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/11_rotation/rigid_constraints.hpp"

namespace rigid {

//! [forces]
void free_velocities(RigidScene& scene, const StepSettings& settings,
                     StepData<3>& now)
{
    Bodies<3>& bodies = scene.bodies;
    // what the step does not look at has the velocity that it has
    if (now.u_star.size() != bodies.u.size()) now.u_star = bodies.u;
    for (const int k : now.active) {
        now.u_star.segment<3>(3 * k) = bodies.velocity(k);
        const Real inverse_mass = bodies.inverse_mass[3 * k];
        bodies.force(k).setZero();
        if (!(inverse_mass > 0)) continue;
        Vec2 acceleration = scene.gravity;
        if (settings.pulled == k)
            acceleration += 400 * (settings.hand - bodies.position(k).head<2>()) -
                            40 * bodies.velocity(k).head<2>();
        bodies.force(k).head<2>() = acceleration / inverse_mass;
        now.u_star.segment<3>(3 * k) +=
            settings.part() * bodies.apply_inverse_mass(k, bodies.force(k));
    }
}
//! [forces]

void require_bodies(const RigidScene& scene)
{
    require_valid(scene.bodies);
    if (static_cast<Index>(scene.shapes.size()) != scene.bodies.count())
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.shapes.size()) +
            " shapes and " + std::to_string(scene.bodies.count()) +
            " bodies; each needs its own");
    for (std::size_t i = 0; i < scene.joints.size(); ++i)
        require_valid(scene.joints[i], i, scene.bodies.count());
    for (std::size_t i = 0; i < scene.walls.size(); ++i) {
        const HalfSpace& wall = scene.walls[i];
        const auto refuse = [i](const char* what, Real value, const char* right) {
            throw std::invalid_argument("the " + std::string(what) + " of wall " +
                                        std::to_string(i) + " is " +
                                        shortest(value) + "; it must be " + right);
        };
        // six digits: enough that a gap of a metre is right to a micrometre
        if (!(std::abs(wall.normal.norm() - 1) < 1e-6))
            refuse("length of the normal", wall.normal.norm(), "1");
        if (!std::isfinite(wall.offset)) refuse("offset", wall.offset, "finite");
    }
}

void require_valid(const RigidScene& scene)
{
    require_bodies(scene);
    for (std::size_t k = 0; k < scene.shapes.size(); ++k) try {
            require_valid(scene.shapes[k]);
        } catch (const std::invalid_argument& fault) {
            throw std::invalid_argument("the shape of body " + std::to_string(k) +
                                        ": " + fault.what());
        }
    (void)typical_length(scene);
}

}  // namespace rigid
