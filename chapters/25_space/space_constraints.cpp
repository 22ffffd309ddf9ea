// The functions of space_constraints.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_space/space_constraints.hpp"

namespace rigid {

//! [forces]
void free_velocities(SpaceScene& scene, const StepSettings& settings,
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

void evaluate_constraints(const SpaceScene& scene, StepData<6>& now)
{
    now.constraints.resize(now.sources.size());
    JointFrames frames;
    ContactPlace place;
    int joint_at = -1, contact_at = -1;
    for (std::size_t i = 0; i < now.sources.size(); ++i) {
        const Source& source = now.sources[i];
        if (source.of == Source::Of::contact) {
            const auto& contact =
                now.contacts[static_cast<std::size_t>(source.index)];
            if (source.index != contact_at)
                find_place(contact, scene.bodies.x, place),
                    contact_at = source.index;
            now.constraints[i] = contact_constraint(now, source, place);
            continue;
        }
        const int number = source.index / joint_slots;
        const SpaceJoint& joint = scene.joints[static_cast<std::size_t>(number)];
        if (number != joint_at)
            frames = frames_of(scene.bodies.x, joint), joint_at = number;
        now.constraints[i] =
            joint_constraint(frames, joint, source.index % joint_slots);
    }
}

}  // namespace rigid
