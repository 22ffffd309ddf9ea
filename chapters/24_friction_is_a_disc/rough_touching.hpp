/// \file rough_touching.hpp
/// The contacts stage in space with friction, and its methods: the grip of each contact, and the rows of that.
///
///     joints · friction, up to five rows to a contact · normals, one to a contact
#pragma once

#include "chapters/23_faces_that_touch/smooth_touching.hpp"
#include "chapters/24_friction_is_a_disc/cone_solver.hpp"
#include "chapters/24_friction_is_a_disc/ellipsoid.hpp"
#include "chapters/24_friction_is_a_disc/space_friction.hpp"

namespace rigid {

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
Constraint<6> constraint_at(const RoughSolids& scene, const StepData<6>& now,
                            std::size_t i, const VecX& x);

void evaluate_constraints(const RoughSolids& scene, StepData<6>& now);

/// Chapter 23's search, and what the surfaces that it finds hold each other with.
struct RoughSearch : ContactSearch {
    void touch_walls(const RoughSolids& scene, const TouchSettings& near,
                     StepData<6>& now)
    {
        for (std::size_t w = 0; w < scene.walls.size(); ++w) {
            std::size_t i = now.contacts.size();
            touch_wall(scene, w, near, now);
            for (; i < now.contacts.size(); ++i) {
                SpaceContact& c = now.contacts[i];
                c.grip = wall_grip(scene, w, static_cast<std::size_t>(c.b));
            }
        }
    }
    void touch_pairs(const RoughSolids& scene, const TouchSettings& near,
                     StepData<6>& now)
    {
        std::size_t i = now.contacts.size();
        for (const auto& [a, b] : pairs) touch_pair(scene, a, b, near, now);
        for (; i < now.contacts.size(); ++i) {
            SpaceContact& c = now.contacts[i];
            c.grip = grip_of(scene, static_cast<std::size_t>(c.a),
                             static_cast<std::size_t>(c.b));
        }
    }

    //! [rows]
    /// Friction first: what is visited last is right (section 13.5).
    static void list_rows(StepData<6>& now)
    {
        const auto add = [&now](std::size_t i,
                                std::initializer_list<SpacePart> parts) {
            for (const SpacePart part : parts)
                now.sources.push_back(
                    {Source::Of::contact, static_cast<int>(i), part});
        };
        for (std::size_t i = 0; i < now.contacts.size(); ++i) {
            const Grip& grip = now.contacts[i].grip;
            if (grip.friction > 0) add(i, {first_tangent, second_tangent});
            if (grip.rolling > 0) add(i, {first_roll, second_roll});
            if (grip.spinning > 0) add(i, {spin_part});
        }
        list_normals(now);
    }
    //! [rows]
};

//! [stage]
struct RoughTouching : RoughSearch {
    AllSolids others;

    template <class Method>
    void begin(const RoughSolids& scene, const StepSettings& settings,
               Method& method, StepData<6>& now)
    {
        others.begin(scene, settings, method, now);
        require_touching(scene);
        mark(scene, now.active);
        place(scene);
        const Real margin = settings.margin * now.length;
        find_pairs(scene, margin);
        const TouchSettings how{margin, slack * margin};
        touch_walls(scene, how, now);
        touch_pairs(scene, how, now);
        touch_ellipsoids(
            scene, margin, [](Index) { return true; }, now);
        list_rows(now);
    }
};
//! [stage]

//! [method]
/// With chapter 6's sweeps the rows of friction are a box, with ConeSolver a disc.
using RoughBoxes = TouchingMethod<ImpulseSolver<6>, RoughTouching>;
using RoughCones = TouchingMethod<ConeSolver, RoughTouching>;

/// Islands of up to so many rows solved by Algorithm 24.2, larger ones swept: a factor
/// of bodies that all hang together grows faster than their number.
template <class Method = RoughCones>
Method solved_exactly(int rows = 1000)
{
    Method method;
    method.solver.exact_rows = rows;
    method.solver.sweeps = {50, 1e-9};
    return method;
}
//! [method]

// Compiled once, in rough_touching.cpp.
extern template void step(RoughSolids&, const StepSettings&, RoughBoxes&,
                          StepData<6>&);
extern template void step(RoughSolids&, const StepSettings&, RoughCones&,
                          StepData<6>&);

}  // namespace rigid
