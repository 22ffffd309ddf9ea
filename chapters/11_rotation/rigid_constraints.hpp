/// \file rigid_constraints.hpp
/// What the step of chapter 3 needs of a scene of bodies that turn. The step itself, its solvers, starts and
/// corrections are those of Part I.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/11_rotation/point_constraints.hpp"

namespace rigid {

/// Weight acts at the centroid: it turns nothing. So does the hand.
void free_velocities(RigidScene& scene, const StepSettings& settings,
                     StepData<3>& now);

/// Constraint i of the step at any positions x.
inline Constraint<3> constraint_at(const RigidScene& scene, const StepData<3>& now,
                                   std::size_t i, const VecX& x)
{
    const auto index = static_cast<std::size_t>(now.sources[i].index);
    if (now.sources[i].of == Source::Of::joint)
        return now.sources[i].part == 0
                   ? joint_constraint(x, scene.joints[index], &scene.turns)
                   : across_line(x, scene.joints[index], now.sources[i].part);
    return contact_constraint(now.contacts[index], now.x_found, x);
}

inline void evaluate_constraints(const RigidScene& scene, StepData<3>& now)
{
    now.constraints.resize(now.sources.size());
    for (std::size_t i = 0; i < now.sources.size(); ++i)
        now.constraints[i] = constraint_at(scene, now, i, scene.bodies.x);
}

/// What a step looks at each time: bodies, joints and walls. Throws std::invalid_argument, with a sentence that names the
/// thing, unless they make sense.
void require_bodies(const RigidScene& scene);

/// The whole scene, shapes as well: for code that makes a scene or changes it in the middle of a run. Throws
/// std::invalid_argument, with a sentence that names the thing, unless it makes sense.
void require_valid(const RigidScene& scene);

/// e of a contact, besides that of the method (chapter 6): a smooth scene has none of its own.
inline Real own_restitution(const RigidScene&, const StepData<3>&, std::size_t)
{
    return 0;
}

//! [all_bodies]
/// The contacts stage: every body is looked at, every joint, and every corner over
/// every wall. (Where two bodies touch each other is chapter 12's subject.)
struct AllBodies : PlainContacts {
    template <class Method>
    void begin(const RigidScene& scene, const StepSettings& settings, Method&,
               StepData<3>& now) const
    {
        require_bodies(scene);
        now.length = typical_length(scene);
        const Bodies<3>& bodies = scene.bodies;
        now.active.resize(static_cast<std::size_t>(bodies.count()));
        std::iota(now.active.begin(), now.active.end(), 0);
        now.contacts.clear();
        now.sources.clear();
        for (std::size_t i = 0; i < scene.joints.size(); ++i)
            if (bodies.can_move(scene.joints[i].a) ||
                bodies.can_move(scene.joints[i].b))
                now.sources.push_back({Source::Of::joint, static_cast<int>(i)});
        for (Index b = 0; b < bodies.count(); ++b) {
            if (!bodies.can_move(b)) continue;
            const std::size_t corners =
                scene.shapes[static_cast<std::size_t>(b)].vertices.size();
            for (std::size_t k = 0; k < corners * scene.walls.size(); ++k) {
                const Constraint<3> c =
                    corner_constraint(scene, bodies.x, k / corners, b, k % corners);
                if (!(c.C < settings.margin * now.length)) continue;
                now.sources.push_back(
                    {Source::Of::contact, static_cast<int>(now.contacts.size())});
                const Vec2 n = scene.walls[k / corners].normal;
                const Vec2 p = point_of(bodies.x, b,
                                        scene.shapes[static_cast<std::size_t>(b)]
                                            .vertices[k % corners]);
                now.contacts.push_back(
                    {world, b, n, c.C, static_cast<Index>(k), p});
            }
        }
        now.x_found = bodies.x;
    }
};
//! [all_bodies]

}  // namespace rigid
