// The functions of touching_rows.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/23_faces_that_touch/touching_rows.hpp"

namespace rigid {

void evaluate_constraints(const WalledSolids& scene, StepData<6>& now)
{
    evaluate_touching(
        scene,
        [&now](const Source& source, const ContactPlace& place) {
            return push_constraint(
                now.contacts[static_cast<std::size_t>(source.index)], place);
        },
        now);
}

Constraint<6> constraint_at(const WalledSolids& scene, const StepData<6>& now,
                            std::size_t i, const VecX& x)
{
    const Source& source = now.sources[i];
    if (source.of != Source::Of::contact)
        return constraint_at(static_cast<const JointedSolids&>(scene), now, i, x);
    const auto& contact = now.contacts[static_cast<std::size_t>(source.index)];
    return push_constraint(contact, place_of(contact, x));
}

}  // namespace rigid
