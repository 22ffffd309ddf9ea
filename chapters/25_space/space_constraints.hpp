/// \file space_constraints.hpp
/// What the step of chapter 3 needs of a scene in space. The step itself, its solvers, starts and corrections are those
/// of Part I, with 6 in place of 2.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"
#include "chapters/25_space/joint_coordinates.hpp"
#include "chapters/25_space/space_checks.hpp"
#include "chapters/25_space/space_contact.hpp"

namespace rigid {

/// e of a contact, besides that of the method (chapter 6): surfaces in space have none of their own.
inline Real own_restitution(const SpaceScene&, const StepData<6>&, std::size_t)
{
    return 0;
}

/// Weight acts at the centroid: it turns nothing. What a spin does to itself is in
/// integrate().
void free_velocities(SpaceScene& scene, const StepSettings& settings,
                     StepData<6>& now);

/// The place of a contact's normal among the rows: the normals are the last ones.
inline std::size_t normal_of(const StepData<6>& now, int contact)
{
    return now.sources.size() - now.contacts.size() +
           static_cast<std::size_t>(contact);
}

/// A row of a contact whose points are found.
inline Constraint<6> contact_constraint(const StepData<6>& now,
                                        const Source& source,
                                        const ContactPlace& place)
{
    const auto& contact = now.contacts[static_cast<std::size_t>(source.index)];
    if (source.part == push_part) return push_constraint(contact, place);
    const auto part = static_cast<SpacePart>(source.part);
    const auto number = static_cast<int>(normal_of(now, source.index));
    return part <= second_tangent
               ? drag_constraint(contact, place, part, number)
               : turn_constraint(contact, place, part, number, now.length);
}

/// Constraint i of the step at any positions x.
inline Constraint<6> constraint_at(const SpaceScene& scene, const StepData<6>& now,
                                   std::size_t i, const VecX& x)
{
    const Source& source = now.sources[i];
    if (source.of == Source::Of::contact)
        return contact_constraint(
            now, source,
            place_of(now.contacts[static_cast<std::size_t>(source.index)], x));
    const SpaceJoint& joint =
        scene.joints[static_cast<std::size_t>(source.index / joint_slots)];
    return joint_constraint(frames_of(x, joint), joint, source.index % joint_slots);
}

/// All of them where the bodies are; the frames of a joint and the points of a contact are found once for rows that are
/// neighbours, and rotations once for contacts that are.
void evaluate_constraints(const SpaceScene& scene, StepData<6>& now);

//! [all_solids]
/// The contacts stage without contacts: every body is looked at, and every joint.
struct AllSolids : PlainContacts {
    template <class Method>
    void begin(const SpaceScene& scene, const StepSettings&, Method& method,
               StepData<6>& now) const
    {
        require_bodies(scene);
        refuse_unfit(method.correction);
        now.length = typical_length(scene);
        const Bodies<6>& bodies = scene.bodies;
        now.active.resize(static_cast<std::size_t>(bodies.count()));
        std::iota(now.active.begin(), now.active.end(), 0);
        list_joints(
            scene, [](Index) { return true; }, now);
        now.x_found = bodies.x;
    }
    /// The rows of the joints of some bodies, and no contact yet.
    /// \param looks  bool(Index): whether the step looks at a body
    template <class Looks>
    static void list_joints(const SpaceScene& scene, const Looks& looks,
                            StepData<6>& now)
    {
        const Bodies<6>& bodies = scene.bodies;
        now.contacts.clear();
        now.sources.clear();
        for (std::size_t i = 0; i < scene.joints.size(); ++i) {
            const SpaceJoint& joint = scene.joints[i];
            if (!bodies.can_move(joint.a) && !bodies.can_move(joint.b)) continue;
            if (!(joint.a != world && looks(joint.a)) && !looks(joint.b)) continue;
            for_each_slot(frames_of(bodies.x, joint), joint, [&](int slot) {
                now.sources.push_back(
                    {Source::Of::joint, static_cast<int>(i) * joint_slots + slot});
            });
        }
    }
    /// Projection adds to x as if angles were numbers, and relaxation writes ω in
    /// axes that have turned since: neither is made for space.
    template <class Correction>
    static void refuse_unfit(const Correction& correction)
    {
        StabilizerSettings how;
        correction.describe(how);
        if (how.method == Stabilizer::projection ||
            how.method == Stabilizer::relaxation)
            throw std::invalid_argument(
                "bodies in space have no projection and no relaxation; choose "
                "none, baumgarte or split_impulse");
    }
};
//! [all_solids]

}  // namespace rigid
