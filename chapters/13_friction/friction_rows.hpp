/// \file friction_rows.hpp
/// A contact becomes two rows, and with rolling resistance three: push, drag, twist.
///
///     normal    J = (−n, −r_a × n),  (n, r_b × n)      0 ≤ λ_n ⟂ w_n ≥ 0
///     tangent   J = (−t, −r_a × t),  (t, r_b × t)      |λ_t| ≤ μ λ_n,   t = n turned by a quarter, b = −belt
///     rolling   J = (0, 0, −ℓ),      (0, 0, ℓ)         |λ_r| ≤ c/ℓ λ_n
///     cloth     J = (d, 0), (0, 0, 1), d along u*      |λ| ≤ h μ m g,   |λ| ≤ h c μ m g
///
/// (13.3). Solvers compare the w of all rows, so that of rolling is a speed as well, at the distance ℓ of the scene: in
/// rad/s it would be another one of a hundred in a scene a hundred times as large. The point of a contact is one for both bodies. It goes with
/// the one whose face it is on; else with a: then r_b × t = r_b·n is right however far b slides or rolls in a sub-step.
#pragma once

#include "chapters/06_sequential_impulse/restitution.hpp"
#include "chapters/11_rotation/rigid_constraints.hpp"
#include "chapters/13_friction/surfaces.hpp"

#include <algorithm>

namespace rigid {

/// The rows of a contact, and of a body on a cloth: Source::part.
enum ContactPart : int { normal_part = 0, tangent_part = 1, rolling_part = 2 };
enum ClothPart : int { sliding_part = 0, spinning_part = 1 };

/// What the two that touch make together, and the wall if one of them is a wall.
struct TouchedSurface {
    Surface surface;
    std::size_t wall = 0;  ///< of a contact with the world; else none
};

TouchedSurface touched_surface(const RoughScene& scene, const Contact& contact);

inline Surface surface_of(const RoughScene& scene, const Contact& contact)
{
    return touched_surface(scene, contact).surface;
}

//! [tangent]
/// (13.3): the friction of a contact whose normal constraint is number n of the
/// step.
/// \param normal  that constraint where the bodies are now
/// \param arm_a, arm_b  from the centroids to the point
inline Constraint<3> friction_constraint(const Constraint<3>& normal, int number,
                                         const Vec2& arm_a, const Vec2& arm_b,
                                         const Surface& surface)
{
    const Vec2 t = perpendicular(Vec2(normal.Jb.head<2>().transpose()));
    Constraint<3> c;
    c.a = normal.a, c.b = normal.b;
    if (c.a != world) c.Ja = -point_row(arm_a, t);
    c.Jb = point_row(arm_b, t);
    c.kind = ConstraintKind::friction;
    c.bounded_by = number;
    c.friction = surface.friction;
    c.weakening = surface.friction - surface.while_sliding();
    c.speed = surface.belt;
    return c;
}
//! [tangent]

/// Rolling resistance: a moment between the two bodies, bounded by the same λ_n.
/// \param length  ℓ [m]
Constraint<3> rolling_constraint(const Constraint<3>& normal, int number,
                                 const Surface& surface, Real length);

/// What a cloth does to a body: a force against its velocity u*, or a moment against its spin.
Constraint<3> cloth_constraint(const RoughScene& scene, const StepData<3>& now,
                               Index b, int part);

/// The place of a contact's normal among the rows: the normals are the last ones.
inline std::size_t normal_of(const StepData<3>& now, int contact)
{
    return now.sources.size() - now.contacts.size() +
           static_cast<std::size_t>(contact);
}

/// A row of friction of a contact at the positions x, by its normal there and its surface.
Constraint<3> drag_constraint(const RoughScene& scene, const StepData<3>& now,
                              const Source& source, const Constraint<3>& normal,
                              const TouchedSurface& touched, const VecX& x);

/// Constraint i of the step at any positions x: chapter 11's and chapter 12's, and the rows of this chapter.
inline Constraint<3> constraint_at(const RoughScene& scene, const StepData<3>& now,
                                   std::size_t i, const VecX& x)
{
    const Source& source = now.sources[i];
    if (source.of == Source::Of::body)
        return cloth_constraint(scene, now, source.index, source.part);
    const auto& smooth = static_cast<const RigidScene&>(scene);
    if (source.of == Source::Of::joint || source.part == normal_part)
        return constraint_at(smooth, now, i, x);
    const Contact& contact = now.contacts[static_cast<std::size_t>(source.index)];
    return drag_constraint(
        scene, now, source,
        constraint_at(smooth, now, normal_of(now, source.index), x),
        touched_surface(scene, contact), x);
}

/// All of them where the bodies are. The normals come first, though they are the last rows: the others are made of
/// them. The rows of a contact are neighbours, so its surface is found once.
void evaluate_constraints(const RoughScene& scene, StepData<3>& now);

/// e of the surfaces of a contact, for chapter 6's bounces.
Real own_restitution(const RoughScene& scene, const StepData<3>& now,
                     std::size_t i);

}  // namespace rigid
