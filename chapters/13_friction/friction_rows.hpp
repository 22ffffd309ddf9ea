/// \file friction_rows.hpp
/// A contact becomes two rows, and with rolling resistance three: push, drag, twist.
///
///     normal    J = (−n, −r_a × n),  (n, r_b × n)      0 ≤ λ_n ⟂ w_n ≥ 0
///     tangent   J = (−t, −r_a × t),  (t, r_b × t)      |λ_t| ≤ μ λ_n,   t = n turned by a quarter, b = −belt
///     rolling   J = (0, 0, −ℓ),      (0, 0, ℓ)         |λ_r| ≤ c/ℓ λ_n
///     cloth     J = (d, 0), (0, 0, 1), d along u*      |λ| ≤ h μ m g,   |λ| ≤ h c μ m g
///
/// (13.3). Solvers compare the w of all rows, so that of rolling is a speed as well, at the distance ℓ of the scene: in
/// rad/s it would be another one of a hundred in a scene a hundred times as large. The point of a contact moves with a: then r_b × t = r_b·n is right however far b slides or rolls in a sub-step.
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

inline TouchedSurface touched_surface(const RoughScene& scene,
                                      const Contact& contact)
{
    const auto of_body = [&scene](Index k) {
        return scene.surfaces.empty() ? Surface{}
                                      : scene.surfaces[static_cast<std::size_t>(k)];
    };
    if (contact.a != world)
        return {combined(of_body(contact.a), of_body(contact.b)),
                scene.walls.size()};
    const std::size_t wall = wall_of(scene, contact.normal, contact.point);
    return {combined(wall < scene.wall_surfaces.size() ? scene.wall_surfaces[wall]
                                                       : Surface{},
                     of_body(contact.b)),
            wall};
}

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
inline Constraint<3> rolling_constraint(const Constraint<3>& normal, int number,
                                        const Surface& surface, Real length)
{
    Constraint<3> c;
    c.a = normal.a, c.b = normal.b;
    if (c.a != world) c.Ja = {0, 0, -length};
    c.Jb = {0, 0, length};
    c.kind = ConstraintKind::friction;
    c.bounded_by = number;
    c.friction = surface.rolling / length;
    return c;
}

/// What a cloth does to a body: a force against its velocity u*, or a moment against its spin.
inline Constraint<3> cloth_constraint(const RoughScene& scene,
                                      const StepData<3>& now, Index b, int part)
{
    Constraint<3> c;
    c.b = b;
    c.kind = ConstraintKind::motor;  // at the speed zero
    c.force = scene.cloth.friction * scene.cloth.gravity /
              scene.bodies.inverse_mass[3 * b];
    if (part == spinning_part) {
        c.Jb = {0, 0, 1};
        c.force *= scene.cloth.arm;
    } else {
        const Vec2 u = now.u_star.segment<2>(3 * b);
        const Real speed = u.norm();
        const Vec2 d = speed > 0 ? Vec2(u / speed) : Vec2(1, 0);
        c.Jb = {d.x(), d.y(), 0};
    }
    return c;
}

/// The place of a contact's normal among the rows: the normals are the last ones.
inline std::size_t normal_of(const StepData<3>& now, int contact)
{
    return now.sources.size() - now.contacts.size() +
           static_cast<std::size_t>(contact);
}

/// A row of friction of a contact at the positions x, by its normal there and its surface.
inline Constraint<3> drag_constraint(const RoughScene& scene,
                                     const StepData<3>& now, const Source& source,
                                     const Constraint<3>& normal,
                                     const TouchedSurface& touched, const VecX& x)
{
    const Contact& contact = now.contacts[static_cast<std::size_t>(source.index)];
    const int number = static_cast<int>(normal_of(now, source.index));
    if (source.part == rolling_part)
        return rolling_constraint(normal, number, touched.surface, now.length);
    // the point moves with a
    Vec2 arm_a(0, 0), point = contact.point;
    if (contact.a != world) {
        const auto moved = x.segment<2>(3 * contact.a);
        arm_a = point - now.x_found.segment<2>(3 * contact.a);
        point = moved + arm_a;
    } else if (touched.wall < scene.walls.size())
        // chapter 11 has the centre of a round corner: drag acts on the wall
        point -= (contact.normal.dot(point) - scene.walls[touched.wall].offset) *
                 contact.normal;
    const Vec2 arm_b = point - x.segment<2>(3 * contact.b);
    return friction_constraint(normal, number, arm_a, arm_b, touched.surface);
}

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
inline void evaluate_constraints(const RoughScene& scene, StepData<3>& now)
{
    const std::size_t rows = now.sources.size(), others = normal_of(now, 0);
    const VecX& x = scene.bodies.x;
    now.constraints.resize(rows);
    for (std::size_t i = others; i < rows; ++i)
        now.constraints[i] =
            constraint_at(static_cast<const RigidScene&>(scene), now, i, x);
    TouchedSurface touched;
    int of = -1;
    for (std::size_t i = 0; i < others; ++i) {
        const Source& source = now.sources[i];
        if (source.of != Source::Of::contact) {
            now.constraints[i] = constraint_at(scene, now, i, x);
            continue;
        }
        if (source.index != of)
            touched = touched_surface(
                scene, now.contacts[static_cast<std::size_t>(source.index)]);
        of = source.index;
        now.constraints[i] = drag_constraint(
            scene, now, source, now.constraints[normal_of(now, source.index)],
            touched, x);
    }
}

//! [own_restitution]
/// e of the surfaces of a contact, for chapter 6's bounces.
inline Real own_restitution(const RoughScene& scene, const StepData<3>& now,
                            std::size_t i)
{
    const auto& contact =
        now.contacts[static_cast<std::size_t>(now.sources[i].index)];
    const auto bounces = [](const Surface& s) { return s.restitution > 0; };
    const auto body_bounces = [&](Index k) {
        return k != world && !scene.surfaces.empty() &&
               bounces(scene.surfaces[static_cast<std::size_t>(k)]);
    };
    const auto wall_may = [&] {
        return contact.a == world &&
               std::any_of(scene.wall_surfaces.begin(), scene.wall_surfaces.end(),
                           bounces);
    };
    // which wall it is takes longer to find
    if (!body_bounces(contact.b) && !body_bounces(contact.a) && !wall_may())
        return 0;
    return surface_of(scene, contact).restitution;
}
//! [own_restitution]

}  // namespace rigid
