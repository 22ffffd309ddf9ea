/// \file space_constraints.hpp
/// What the step of chapter 3 needs of a scene in space. The step itself, its solvers, starts and corrections are those
/// of Part I, with 6 in place of 2.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"
#include "chapters/18_space/joint_coordinates.hpp"
#include "chapters/18_space/space_contact.hpp"

namespace rigid {

/// e of a contact, besides that of the method (chapter 6): surfaces in space have none of their own.
inline Real own_restitution(const SpaceScene&, const StepData<6>&, std::size_t)
{
    return 0;
}

/// Throws std::invalid_argument, naming the setting, unless the settings of a step make sense in space.
inline void require_valid(const StepSettings& settings, const Vec3& gravity,
                          Index bodies)
{
    if (!gravity.allFinite()) throw std::invalid_argument("gravity is not finite");
    require_valid(settings, Vec2(0, 0), bodies);
    if (settings.pulled != world)
        throw std::invalid_argument(
            "a hand in the plane of the picture pulls no body in space");
}

//! [forces]
/// Weight acts at the centroid: it turns nothing. What a spin does to itself is in
/// integrate().
inline void free_velocities(SpaceScene& scene, const StepSettings& settings,
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
inline void evaluate_constraints(const SpaceScene& scene, StepData<6>& now)
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

/// What a step looks at each time. Throws std::invalid_argument, with a sentence that names the thing, unless it makes
/// sense.
inline void require_bodies(const SpaceScene& scene)
{
    require_valid(scene.bodies);
    const Index count = scene.bodies.count();
    if (static_cast<Index>(scene.shapes.size()) != count)
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.shapes.size()) +
            " shapes and " + std::to_string(count) + " bodies; each needs its own");
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        const SpaceJoint& joint = scene.joints[i];
        const auto refuse = [i](const std::string& what) {
            throw std::invalid_argument("joint " + std::to_string(i) + " " + what);
        };
        if (joint.a < world || joint.a >= count || joint.b < 0 ||
            joint.b >= count || joint.a == joint.b)
            refuse("joins bodies " + std::to_string(joint.a) + " and " +
                   std::to_string(joint.b) + " among " + std::to_string(count));
        for (std::size_t c = 0; c < coordinates; ++c)
            if (!(joint.lo[c] <= joint.hi[c]) || joint.lo[c] == infinity ||
                joint.hi[c] == -infinity)
                refuse("has the limits " + shortest(joint.lo[c]) + " and " +
                       shortest(joint.hi[c]) + " of coordinate " +
                       std::to_string(c) +
                       "; a finite value must lie between them");
        for (const Vec3& v : {joint.at_a, joint.at_b, joint.frame_a, joint.frame_b})
            if (!v.allFinite()) refuse("has a point or a frame that is not finite");
        if (joint.motor >= coordinates ||
            !(joint.force >= 0 && std::isfinite(joint.speed)))
            refuse("has a motor on coordinate " + std::to_string(joint.motor) +
                   " of the force " + shortest(joint.force) + " and the speed " +
                   shortest(joint.speed));
    }
}

/// The same for what touches: walls and coefficients of friction.
inline void require_touching(const SpaceScene& scene)
{
    require_meshes(scene);
    for (std::size_t w = 0; w < scene.walls.size(); ++w)
        if (!(std::abs(scene.walls[w].normal.norm() - 1) <= 1e-9) ||
            !std::isfinite(scene.walls[w].offset))
            throw std::invalid_argument(
                "wall " + std::to_string(w) + " has a normal of the length " +
                shortest(scene.walls[w].normal.norm()) + " and the offset " +
                shortest(scene.walls[w].offset) +
                " m; the length must be 1, the offset finite");
    // no strings: what is fine asks for no memory
    const auto check = [](const std::vector<Real>& list, std::size_t count,
                          const char* thing, const char* what) {
        if (!list.empty() && list.size() != count)
            throw std::invalid_argument(
                "the scene has " + std::to_string(list.size()) + " " + what +
                "s for " + std::to_string(count) + " " + thing +
                "; each needs its own, or none has one");
        for (std::size_t i = 0; i < list.size(); ++i)
            if (!(list[i] >= 0) || !std::isfinite(list[i]))
                throw std::invalid_argument(
                    "number " + std::to_string(i) + " of the " + thing +
                    " has the " + what + " " + shortest(list[i]) +
                    "; it must be zero or positive and finite");
    };
    check(scene.friction, scene.shapes.size(), "bodies", "friction coefficient");
    check(scene.wall_friction, scene.walls.size(), "walls", "friction coefficient");
    check(scene.mesh_friction, scene.meshes.size(), "meshes",
          "friction coefficient");
    check(scene.rolling, scene.shapes.size(), "bodies", "rolling arm");
    check(scene.spinning, scene.shapes.size(), "bodies", "spinning arm");
    for (std::size_t i = 0; i < scene.ellipsoids.size(); ++i) {
        const SolidEllipsoid& e = scene.ellipsoids[i];
        if (e.body < 0 || e.body >= scene.bodies.count())
            throw std::invalid_argument("ellipsoid " + std::to_string(i) +
                                        " belongs to body " +
                                        std::to_string(e.body) + " among " +
                                        std::to_string(scene.bodies.count()));
        const Real volume = determinant(e.stretch);
        if (!e.at.allFinite() || !(std::abs(volume) > 0) || !std::isfinite(volume))
            throw std::invalid_argument("ellipsoid " + std::to_string(i) +
                                        " is flat, or not finite");
    }
}

//! [all_solids]
/// The contacts stage without contacts: every body is looked at, and every joint.
struct AllSolids {
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
    template <class Method>
    void end(const SpaceScene&, const StepSettings&, Method&,
             const StepData<6>&) const
    {
    }
    /// Projection adds to x as if angles were numbers, and relaxation writes ω in
    /// axes that have turned since: neither is made for space.
    template <class Correction>
    static void refuse_unfit(const Correction& correction)
    {
        if constexpr (requires { correction.method; })
            if (correction.method == Stabilizer::projection ||
                correction.method == Stabilizer::relaxation)
                throw std::invalid_argument(
                    "bodies in space have no projection and no relaxation; choose "
                    "none, baumgarte or split_impulse");
    }
};
//! [all_solids]

}  // namespace rigid
