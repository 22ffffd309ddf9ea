/// \file world_changes.cpp
/// What a caller changes on a body: where it is, how it moves, what it is like. Each change wakes what it concerns.
#include "common/eigen_instances.hpp"

#include "chapters/19_engine/world.hpp"

#include "chapters/19_engine/world_cpp.hpp"
#include "chapters/19_engine/world_things.hpp"

namespace rigid {
namespace {
constexpr const char* edge_stays = "the body is an edge of a chain; it cannot move";
}

void World::move(BodyId body, const Vec2& position, Real angle)
{
    State& s = *state_;
    const Index k = s.number(body);
    if (!is_place(position, angle))
        throw std::invalid_argument(
            "the body is to go to (" + shortest(position.x()) + ", " +
            shortest(position.y()) + ") m at the angle " + shortest(angle) +
            " rad; they must be finite, none beyond 1e75");
    if (s.note(k).chain >= 0) throw std::invalid_argument(edge_stays);
    s.scene.bodies.position(k) << position, angle;
    s.disturb(k);
    if (s.is_ground(k)) wake_under(s, k);
    s.note(Call::move, body, position, angle);
}
void World::set_velocity(BodyId body, const Vec2& velocity, Real spin)
{
    State& s = *state_;
    const Index k = s.number(body);
    if (!velocity.allFinite() || !std::isfinite(spin))
        throw std::invalid_argument("the body is to have the velocity (" +
                                    shortest(velocity.x()) + ", " +
                                    shortest(velocity.y()) + ") m/s and the spin " +
                                    shortest(spin) + " rad/s; they must be finite");
    if (s.note(k).chain >= 0 && !(velocity.isZero(0) && spin == 0))
        throw std::invalid_argument(edge_stays);
    s.set_velocity(k, {velocity.x(), velocity.y(), spin});
    s.note(k).aims = false;
    s.disturb(k);
    s.note(Call::set_velocity, body, velocity, spin);
}
void World::set_target(BodyId body, const Vec2& position, Real angle, Real h)
{
    State& s = *state_;
    const Index k = s.number(body);
    require_step(h);
    if (!is_place(position, angle))
        throw std::invalid_argument(
            "the body is to be at (" + shortest(position.x()) + ", " +
            shortest(position.y()) + ") m at the angle " + shortest(angle) +
            " rad after the step; they must be finite, none beyond 1e75");
    if (s.note(k).dynamic || s.note(k).chain >= 0)
        throw std::invalid_argument(
            "the body has a target and is " +
            std::string(s.note(k).dynamic ? "pushed by forces"
                                          : "an edge of a chain") +
            "; only what nothing pushes can be brought to a place");
    const Vec<3> way =
        Vec<3>(position.x(), position.y(), angle) - s.scene.bodies.position(k);
    if (!(way / h).allFinite())
        throw std::invalid_argument("the body would need a velocity that is not "
                                    "finite to reach its target in " +
                                    shortest(h) +
                                    " s; one of both must be smaller");
    s.set_velocity(k, way / h);
    s.note(k).aims = true;
    s.disturb(k);
    s.note(Call::set_target, body, position, angle, h);
}
void World::set_force(BodyId body, const Vec2& force, Real torque)
{
    State& s = *state_;
    const Index k = s.number(body);
    if (!(force.norm() <= largest_number) || !(std::abs(torque) <= largest_number))
        throw std::invalid_argument(
            "the lasting force is (" + shortest(force.x()) + ", " +
            shortest(force.y()) + ") N with the torque " + shortest(torque) +
            " N m; they must be finite, and not beyond 1e75");
    BodyForces own = s.acts(k);
    own.force = force, own.torque = torque;
    s.act(k, own);
    s.disturb(k);
    s.note(Call::set_force, body, force, torque);
}
void World::set_gravity_scale(BodyId body, Real scale)
{
    State& s = *state_;
    const Index k = s.number(body);
    require_gravity_scale(scale);
    require_weight(mass(body), scale * s.settings.gravity);
    BodyForces own = s.acts(k);
    own.gravity = scale;
    s.act(k, own);
    s.disturb(k);
    s.note(Call::set_gravity_scale, body, scale);
}
void World::set_damping(BodyId body, Real linear, Real angular)
{
    State& s = *state_;
    const Index k = s.number(body);
    require_damping(linear, angular);
    BodyForces own = s.acts(k);
    own.damping = linear, own.turning_damping = angular;
    s.act(k, own);
    s.disturb(k);
    s.note(Call::set_damping, body, linear, angular);
}
void World::set_surface(BodyId body, const Surface& surface)
{
    State& s = *state_;
    const Index k = s.shape_number(body);
    require_surface(surface, "the body");
    write_surface(s, k, surface);
    s.disturb(k);
    s.note(Call::set_surface, body, surface);
}
void World::set_filter(BodyId body, const Filter& filter)
{
    State& s = *state_;
    const Index k = s.shape_number(body);
    s.note(k).filter = filter;
    s.write_filter(k);
    s.disturb(k);
    if (s.is_ground(k)) wake_under(s, k);
    s.note(Call::set_filter, body, filter);
}
void World::set_bullet(BodyId body, bool bullet)
{
    State& s = *state_;
    const Index k = s.number(body);
    s.note(k).bullet = bullet;
    s.list_unstopped(k);
    s.note(Call::set_bullet, body, bullet);
}
void World::set_user(BodyId body, std::uint64_t user)
{
    state_->note(state_->shape_number(body)).user = user;
    state_->note(Call::set_user, body, user);
}
void World::wake(BodyId body)
{
    state_->disturb(state_->number(body));
    state_->note(Call::wake, body);
}
void World::push(BodyId body, const Vec2& impulse, const Vec2& at)
{
    State& s = *state_;
    const Index k = s.number(body);
    if (!impulse.allFinite() || !at.allFinite())
        throw std::invalid_argument("the impulse is (" + shortest(impulse.x()) +
                                    ", " + shortest(impulse.y()) + ") N s at (" +
                                    shortest(at.x()) + ", " + shortest(at.y()) +
                                    ") m; it must be finite");
    Bodies<3>& bodies = s.scene.bodies;
    const Vec2 arm = at - bodies.position(k).head<2>();
    const Vec<3> whole(impulse.x(), impulse.y(), cross2(arm, impulse));
    const Vec<3> u = bodies.velocity(k) + bodies.apply_inverse_mass(k, whole);
    if (!u.allFinite())
        throw std::invalid_argument(
            "the impulse (" + shortest(impulse.x()) + ", " + shortest(impulse.y()) +
            ") N s would give the body a velocity that is not "
            "finite; it must be smaller");
    bodies.velocity(k) = u;
    s.disturb(k);
    s.note(Call::push, body, impulse, at);
}
void World::pull(BodyId body, const Vec2& to)
{
    State& s = *state_;
    const Index k = s.number_or_world(body);
    if (!is_place(to, 0))
        throw std::invalid_argument("the hand pulls to (" + shortest(to.x()) +
                                    ", " + shortest(to.y()) +
                                    ") m; it must be finite, and not beyond 1e75");
    if (k != world && !s.scene.bodies.can_move(k))
        throw std::invalid_argument("the hand pulls body " + std::to_string(k) +
                                    ", which cannot move; it must have a density");
    s.pulled = k;
    s.pulled_to = to;
    s.changed = true;
    s.note(Call::pull, body, to);
}

}  // namespace rigid
