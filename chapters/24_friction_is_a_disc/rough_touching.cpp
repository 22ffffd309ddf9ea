// The functions of rough_touching.hpp, and its steps.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/rough_touching.hpp"

namespace rigid {

Constraint<6> constraint_at(const RoughSolids& scene, const StepData<6>& now,
                            std::size_t i, const VecX& x)
{
    const Source& source = now.sources[i];
    if (source.of != Source::Of::contact)
        return constraint_at(static_cast<const JointedSolids&>(scene), now, i, x);
    const auto& contact = now.contacts[static_cast<std::size_t>(source.index)];
    return contact_constraint(now, source, place_of(contact, x));
}

void evaluate_constraints(const RoughSolids& scene, StepData<6>& now)
{
    evaluate_touching(
        scene,
        [&now](const Source& source, const ContactPlace& place) {
            return contact_constraint(now, source, place);
        },
        now);
}

template void step(RoughSolids&, const StepSettings&, RoughBoxes&, StepData<6>&);
template void step(RoughSolids&, const StepSettings&, RoughCones&, StepData<6>&);

}  // namespace rigid
