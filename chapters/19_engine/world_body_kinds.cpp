/// \file world_body_kinds.cpp
/// What a body is: its shape, its mass, what may move it, whether it is there at all. Each change wakes what it concerns.
#include "common/eigen_instances.hpp"

#include "chapters/19_engine/world.hpp"

#include "chapters/19_engine/world_cpp.hpp"
#include "chapters/19_engine/world_things.hpp"

namespace rigid {

namespace {

/// Throws std::invalid_argument for a body that stays as it is.
void require_no_edge(const EngineState& state, Index k, const char* what)
{
    if (state.note(k).chain >= 0)
        throw std::invalid_argument(
            std::string("the body is an edge of a chain; it keeps its ") + what);
}
void require_pushed(const EngineState& state, Index k)
{
    require_no_edge(state, k, "kind");
    if (state.note(k).sensor)
        throw std::invalid_argument(
            "the body is a sensor; nothing pushes it, so it has no mass");
}

}  // namespace

void World::set_shape(BodyId body, const Polygon& shape)
{
    State& s = *state_;
    const Index k = s.shape_number(body);
    require_no_edge(s, k, "shape");
    require_valid(shape);
    Mass about;
    about.centroid = centroid_of(shape);
    if (!about.centroid.allFinite())
        throw std::invalid_argument(
            "the shape has the centroid (" + shortest(about.centroid.x()) + ", " +
            shortest(about.centroid.y()) + "); it must be finite");
    require_about(about, shape);
    Polygon own = shape;
    if (!s.scene.carried.empty())
        about.centroid -= s.scene.carried[static_cast<std::size_t>(k)].middle;
    for (Vec2& vertex : own.vertices) vertex -= about.centroid;
    require_valid(own);
    s.scene.shapes[static_cast<std::size_t>(k)] = own;
    s.list_slop(s.scene.carrier(k));
    s.disturb(k);
    s.note(Call::set_shape, body, shape);
}
void World::set_mass(BodyId body, Real mass, Real inertia)
{
    State& s = *state_;
    const Index k = s.number(body);
    require_pushed(s, k);
    require_mass(mass, inertia);
    require_weight(mass, s.acts(k).gravity * s.settings.gravity);
    BodyNotes& it = s.note(k);
    it.mass = mass, it.inertia = inertia;
    it.dynamic = true;
    s.write_mass(k);
    s.disturb(k);
    s.note(Call::set_mass, body, mass, inertia);
}
void World::set_density(BodyId body, Real density)
{
    State& s = *state_;
    const Index k = s.number(body);
    require_not_negative(density, "the density of the body", " kg/m²");
    if (density == 0) {
        set_kind(body, BodyKind::kinematic);
        return;
    }
    if (!s.scene.carried.empty() &&
        s.scene.carried[static_cast<std::size_t>(k)].next != k)
        throw std::invalid_argument(
            "the body has several shapes, and each may have a density of its own; "
            "set_mass() gives it another mass");
    const Mass of = mass_of(s.shape(k), density);
    set_mass(body, of.mass, of.inertia + of.mass * of.centroid.squaredNorm());
}
void World::set_kind(BodyId body, BodyKind kind)
{
    State& s = *state_;
    const Index k = s.number(body);
    BodyNotes& it = s.note(k);
    if (kind > BodyKind::dynamic)
        throw std::invalid_argument(
            "the kind of the body is " + std::to_string(static_cast<int>(kind)) +
            "; it must be one of fixed, kinematic and dynamic");
    if (kind == BodyKind::dynamic) {
        require_pushed(s, k);
        if (!(it.mass > 0))
            throw std::invalid_argument(
                "the body has no mass that forces could act on; set_density() or "
                "set_mass() gives it one");
        require_weight(it.mass, s.acts(k).gravity * s.settings.gravity);
    }
    it.dynamic = kind == BodyKind::dynamic;
    it.aims = false;
    if (kind == BodyKind::fixed) {
        s.set_velocity(k, Vec<3>::Zero());
        s.forget_motion(k);  // it does not slow down, it stands
    }
    s.write_mass(k);
    s.disturb(k);
    s.note(Call::set_kind, body, kind);
}
void World::set_fixed_rotation(BodyId body, bool fixed)
{
    State& s = *state_;
    const Index k = s.number(body);
    if (fixed == s.note(k).fixed_rotation) return;
    s.note(k).fixed_rotation = fixed;
    if (Vec<3> u = s.velocity(k); fixed && s.note(k).dynamic) {
        u[2] = 0;
        s.set_velocity(k, u);
    }
    s.write_mass(k);
    s.disturb(k);
    s.note(Call::set_fixed_rotation, body, fixed);
}
void World::set_enabled(BodyId body, bool enabled)
{
    State& s = *state_;
    for (const Index k : whole_of(s, s.number(body))) switch_body(s, k, enabled);
    s.note(Call::set_enabled, body, enabled);
}

}  // namespace rigid
