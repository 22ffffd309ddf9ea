// The functions of disc_constraints.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/disc_constraints.hpp"

namespace rigid {

//! [forces]
void free_velocities(DiscScene& scene, const StepSettings& settings,
                     StepData<2>& now)
{
    Bodies<2>& bodies = scene.bodies;
    const Real h = settings.part();
    for (const int k : now.active) {
        const Real inverse_mass = bodies.inverse_mass[2 * k];
        bodies.force(k) =
            inverse_mass > 0 ? Vec2(scene.gravity / inverse_mass) : Vec2(0, 0);
    }
    add_bend_springs(bodies, now.bends, settings.stiffness, settings.damping,
                     9.81 * now.length);
    if (settings.pulled != world) add_pull(bodies, settings.pulled, settings.hand);
    // What the step doesn't look at has the velocity that it has: rows may join it
    // to what moves.
    if (now.u_star.size() != bodies.u.size()) now.u_star = bodies.u;
    for (const int k : now.active)
        now.u_star.segment<2>(2 * k) =
            bodies.velocity(k) + h * bodies.apply_inverse_mass(k, bodies.force(k));
}
//! [forces]

//! [constraint_at]
Constraint<2> constraint_at(const DiscScene& scene, const StepData<2>& now,
                            std::size_t i, const VecX& x)
{
    const auto index = static_cast<std::size_t>(now.sources[i].index);
    if (now.sources[i].of == Source::Of::link)
        return distance_constraint(x, scene.links[index]);
    if (now.sources[i].of == Source::Of::joint)
        return joint_constraint(x, scene.joints[index]);
    const Contact& contact = now.contacts[index];
    return contact_constraint(
        contact.a == world ? wall_contact(scene, x, contact.feature, contact.b)
                           : disc_contact(scene, x, contact.a, contact.b));
}
//! [constraint_at]

void evaluate_constraints(const DiscScene& scene, StepData<2>& now)
{
    now.constraints.resize(now.sources.size());
    for (std::size_t i = 0; i < now.sources.size(); ++i) {
        const Source source = now.sources[i];
        now.constraints[i] =
            source.of == Source::Of::contact && now.substep == 0
                ? contact_constraint(
                      now.contacts[static_cast<std::size_t>(source.index)])
                : constraint_at(scene, now, i, scene.bodies.x);
    }
}

}  // namespace rigid
