// The functions of friction_rows.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/13_friction/friction_rows.hpp"

namespace rigid {

TouchedSurface touched_surface(const RoughScene& scene, const Contact& contact)
{
    const auto of_shape = [&scene](Index k) {
        return scene.surfaces.empty() ? Surface{}
                                      : scene.surfaces[static_cast<std::size_t>(k)];
    };
    if (contact.a != world)
        return {combined(of_shape(contact.shape_a()), of_shape(contact.shape_b())),
                scene.walls.size()};
    const std::size_t wall = wall_of(scene, contact.normal, contact.point);
    return {combined(wall < scene.wall_surfaces.size() ? scene.wall_surfaces[wall]
                                                       : Surface{},
                     of_shape(contact.shape_b())),
            wall};
}

Constraint<3> rolling_constraint(const Constraint<3>& normal, int number,
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

Constraint<3> cloth_constraint(const RoughScene& scene, const StepData<3>& now,
                               Index b, int part)
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
        const Vec2 d = direction_of(u, u.norm(), {1, 0});
        c.Jb = {d.x(), d.y(), 0};
    }
    return c;
}

/// Whether one of the bodies of a contact is not where it was found.
static bool has_moved(const Contact& contact, const VecX& x_found, const VecX& x)
{
    const auto stays = [&](Index k) {
        return x.segment<3>(3 * k) == x_found.segment<3>(3 * k);
    };
    return !stays(contact.a) || !stays(contact.b);
}

Constraint<3> drag_constraint(const RoughScene& scene, const StepData<3>& now,
                              const Source& source, const Constraint<3>& normal,
                              const TouchedSurface& touched, const VecX& x)
{
    const Contact& contact = now.contacts[static_cast<std::size_t>(source.index)];
    const int number = static_cast<int>(normal_of(now, source.index));
    if (source.part == rolling_part)
        return rolling_constraint(normal, number, touched.surface, now.length);
    // the point moves with a, or with the body whose face it is on
    Vec2 arm_a(0, 0), point = contact.point;
    if (contact.a != world) {
        const Vec2 at_a = x.segment<2>(3 * contact.a);
        arm_a = point - now.x_found.segment<2>(3 * contact.a);
        point = at_a + arm_a;
        if (contact.normal_of != NormalOf::fixed &&
            has_moved(contact, now.x_found, x)) {
            const bool discs = contact.normal_of == NormalOf::centres;
            const Index k =
                contact.normal_of == NormalOf::b ? contact.b : contact.a;
            const Real core = discs ? contact.core_a : 0;
            const Vec2 r = contact.point - core * contact.normal -
                           now.x_found.segment<2>(3 * k);
            const auto [s, c] =
                sine_and_cosine(x[3 * k + 2] - now.x_found[3 * k + 2]);
            point = x.segment<2>(3 * k) + c * r + s * perpendicular(r) +
                    core * Vec2(normal.Jb.head<2>().transpose());
            arm_a = point - at_a;
        }
    } else if (touched.wall < scene.walls.size())
        // chapter 11 has the centre of a round corner: drag acts on the wall
        point -= (contact.normal.dot(point) - scene.walls[touched.wall].offset) *
                 contact.normal;
    const Vec2 arm_b = point - x.segment<2>(3 * contact.b);
    return friction_constraint(normal, number, arm_a, arm_b, touched.surface);
}

void evaluate_constraints(const RoughScene& scene, StepData<3>& now)
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
Real own_restitution(const RoughScene& scene, const StepData<3>& now, std::size_t i)
{
    const auto& contact =
        now.contacts[static_cast<std::size_t>(now.sources[i].index)];
    const auto bounces = [](const Surface& s) { return s.restitution > 0; };
    const auto shape_bounces = [&](Index k) {
        return k != world && !scene.surfaces.empty() &&
               bounces(scene.surfaces[static_cast<std::size_t>(k)]);
    };
    const auto wall_may = [&] {
        return contact.a == world &&
               std::any_of(scene.wall_surfaces.begin(), scene.wall_surfaces.end(),
                           bounces);
    };
    // which wall it is takes longer to find
    if (!shape_bounces(contact.shape_b()) && !shape_bounces(contact.shape_a()) &&
        !wall_may())
        return 0;
    return surface_of(scene, contact).restitution;
}
//! [own_restitution]

}  // namespace rigid
