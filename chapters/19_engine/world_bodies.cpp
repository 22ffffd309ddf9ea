/// \file world_bodies.cpp
/// How bodies get into a world and out of it, and what it says of them.
#include "common/eigen_instances.hpp"

#include "chapters/19_engine/world.hpp"

#include "chapters/19_engine/world_cpp.hpp"
#include "chapters/19_engine/world_things.hpp"

namespace rigid {

BodyId World::add_body(const BodyDefinition& definition,
                       std::span<const ShapeDefinition> more)
{
    State& s = *state_;
    const Mass mass = require_valid(definition, more);
    require_weight(mass.mass, definition.gravity_scale * s.settings.gravity);
    const auto place = [&s] {
        return s.bodies.free.empty() ? Index{-1}
                                     : static_cast<Index>(s.bodies.free.back());
    };
    const BodyId id = enter_body(s, definition, mass, place());
    const auto k = static_cast<Index>(id.place);
    const auto middle = [&](const Polygon& shape) -> Vec2 {
        return centroid_of(shape) - mass.centroid;
    };
    if (!more.empty()) list_shape(s.scene, k, k, middle(definition.shape));
    for (const ShapeDefinition& it : more) {
        BodyDefinition shape{.shape = it.shape,
                             .position = definition.position,
                             .angle = definition.angle,
                             .density = 0,
                             .surface = it.surface,
                             .filter = it.filter,
                             .sensor = it.sensor,
                             .user = it.user};
        enter_body(s, shape, {0, mass.centroid, 0}, place(), k, middle(it.shape));
    }
    if (more.empty()) s.note(Call::add_body, definition);
    else
        s.note(Call::add_shapes, definition,
               std::vector<ShapeDefinition>(more.begin(), more.end()));
    return id;
}

BodyId World::add_chain(std::span<const Vec2> points, bool closed,
                        const Surface& surface, const Filter& filter)
{
    State& s = *state_;
    const std::vector<Vec2> corners(points.begin(), points.end());
    require_surface(surface, "the chain");
    RigidScene trial;  // throws for points that make no chain
    rigid::add_chain(trial, corners, closed);
    for (const Vec2& corner : corners)
        if (!is_place(corner, 0))
            throw std::invalid_argument(
                "the chain has a point at (" + shortest(corner.x()) + ", " +
                shortest(corner.y()) + ") m; none may be beyond 1e75");
    const Index first = s.scene.bodies.count();
    for (Index i = 0; i < trial.bodies.count(); ++i) {
        BodyDefinition edge;
        edge.shape = trial.shapes[static_cast<std::size_t>(i)];
        edge.position = trial.bodies.position(i).head<2>();
        edge.density = 0;
        edge.surface = surface;
        edge.filter = filter;
        const BodyId id = enter_body(s, edge, Mass{}, -1);
        s.note(static_cast<Index>(id.place)).chain = static_cast<int>(first);
    }
    s.scene.chains.push_back({first, s.scene.bodies.count() - 1, closed});
    // the edges have woken what they must
    s.awake().watch.around.chains = s.scene.chains;
    s.note(Call::add_chain, corners, closed, surface, filter);
    return s.id(first);
}

void World::remove(BodyId body)
{
    State& s = *state_;
    const Index k = s.number(body);
    const std::vector<Index> whole = whole_of(s, k);
    if (s.note(k).chain >= 0) {
        std::erase_if(s.scene.chains, [at = whole.front()](const Chain& it) {
            return it.first == at;
        });
        s.awake().watch.around.chains = s.scene.chains;
    }
    if (!s.scene.carried.empty())  // from here on each is a body of its own
        for (const Index i : whole) {
            s.more_shapes -= s.scene.carrier(i) != i;
            list_shape(s.scene, i, i);
        }
    for (const Index i : whole) {
        for_each_joint_of(s, i, [&](std::size_t j) { take_out_joint(s, j); });
        take_out_body(s, i);
    }
    s.note(Call::remove_body, body);
}

bool World::has(BodyId body) const { return state_->bodies.has(body); }

std::vector<BodyId> World::bodies() const
{
    std::vector<BodyId> all = state_->bodies.all();
    std::erase_if(all, [this](BodyId it) { return body_of(it) != it; });
    return all;
}
std::vector<BodyId> World::shapes(BodyId body) const
{
    std::vector<BodyId> names;
    state_->scene.for_each_shape(state_->number(body),
                                 [&](Index k) { names.push_back(state_->id(k)); });
    return names;
}
BodyId World::body_of(BodyId shape) const
{
    return state_->id(state_->number(shape));
}

Vec2 World::position(BodyId body) const
{
    return state_->scene.bodies.position(state_->number(body)).head<2>();
}
Real World::angle(BodyId body) const
{
    return state_->scene.bodies.position(state_->number(body))[2];
}
Vec2 World::velocity(BodyId body) const
{
    return state_->velocity(state_->number(body)).head<2>();
}
Real World::spin(BodyId body) const
{
    return state_->velocity(state_->number(body))[2];
}
Real World::mass(BodyId body) const
{
    const BodyNotes& it = state_->note(state_->number(body));
    return it.dynamic ? it.mass : infinity;
}
Real World::inertia(BodyId body) const
{
    const BodyNotes& it = state_->note(state_->number(body));
    return it.dynamic && !it.fixed_rotation ? it.inertia : infinity;
}
const Polygon& World::shape(BodyId body) const
{
    return state_->shape(state_->shape_number(body));
}
const Surface& World::surface(BodyId body) const
{
    return state_->scene
        .surfaces[static_cast<std::size_t>(state_->shape_number(body))];
}
const Filter& World::filter(BodyId body) const
{
    return state_->note(state_->shape_number(body)).filter;
}
std::uint64_t World::user(BodyId body) const
{
    return state_->note(state_->shape_number(body)).user;
}
BodyKind World::kind(BodyId body) const
{
    const Index k = state_->number(body);
    if (state_->note(k).dynamic) return BodyKind::dynamic;
    return state_->velocity(k).isZero(0) ? BodyKind::fixed : BodyKind::kinematic;
}
bool World::is_enabled(BodyId body) const
{
    return !state_->note(state_->number(body)).disabled;
}
bool World::has_fixed_rotation(BodyId body) const
{
    return state_->note(state_->number(body)).fixed_rotation;
}
Real World::gravity_scale(BodyId body) const
{
    return state_->acts(state_->number(body)).gravity;
}
Real World::linear_damping(BodyId body) const
{
    return state_->acts(state_->number(body)).damping;
}
Real World::angular_damping(BodyId body) const
{
    return state_->acts(state_->number(body)).turning_damping;
}
Vec2 World::force(BodyId body) const
{
    return state_->acts(state_->number(body)).force;
}
Real World::torque(BodyId body) const
{
    return state_->acts(state_->number(body)).torque;
}
bool World::is_awake(BodyId body) const
{
    const auto k = static_cast<std::size_t>(state_->number(body));
    const std::vector<Activity>& activity = state_->awake().set.activity;
    if (k < activity.size() && state_->was_there(static_cast<Index>(k)))
        return activity[k] == Activity::awake;
    return state_->scene.bodies.can_move(static_cast<Index>(k));  // not stepped yet
}
Vec2 World::point_of(BodyId body, const Vec2& own) const
{
    return rigid::point_of(state_->scene.bodies.x, state_->number_or_world(body),
                           own);
}

}  // namespace rigid
