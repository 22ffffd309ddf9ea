/// \file touching_rows.hpp
/// The rows of a step whose bodies touch: those of its joints, then those of its contacts.
#pragma once

#include "chapters/21_joints_in_space/all_solids.hpp"
#include "chapters/23_faces_that_touch/space_contact.hpp"
#include "chapters/23_faces_that_touch/walled_solids.hpp"

namespace rigid {

/// The constraints of a step where the bodies are. The frames of a joint and the points of a contact are found once for
/// rows that are neighbours, and rotations once for contacts that are.
/// \param row_of  Constraint<6>(source, place): a row of a contact whose points are found
template <class RowOf>
void evaluate_touching(const JointedSolids& scene, const RowOf& row_of,
                       StepData<6>& now)
{
    now.constraints.resize(now.sources.size());
    JointPlace joint;
    ContactPlace place;
    int contact_at = -1;
    for (std::size_t i = 0; i < now.sources.size(); ++i) {
        const Source& source = now.sources[i];
        if (source.of != Source::Of::contact) {
            now.constraints[i] = joint.row(scene, source);
            continue;
        }
        if (source.index != contact_at) {
            contact_at = source.index;
            find_place(now.contacts[static_cast<std::size_t>(contact_at)],
                       scene.bodies.x, place);
        }
        now.constraints[i] = row_of(source, place);
    }
}

/// Without friction a contact has one row.
void evaluate_constraints(const WalledSolids& scene, StepData<6>& now);

/// Constraint i of the step at any positions x.
Constraint<6> constraint_at(const WalledSolids& scene, const StepData<6>& now,
                            std::size_t i, const VecX& x);

}  // namespace rigid
