/// \file world.cpp
/// The step of a world, and what its functions say about bodies, joints and walls. How these get in and out is in
/// world_things.hpp, what outlives the world in world_kept.cpp.
#include "common/eigen_instances.hpp"

#include "chapters/17_engine/world.hpp"

#include "chapters/17_engine/recording.hpp"
#include "chapters/17_engine/saved_world.hpp"
#include "chapters/17_engine/world_cpp.hpp"
#include "chapters/17_engine/world_things.hpp"

namespace rigid {

void require_valid(const WorldSettings& settings)
{
    const auto refuse = [](const char* name, const std::string& value,
                           const char* right) {
        throw std::invalid_argument(std::string("the ") + name +
                                    " of the world is " + value + "; it must be " +
                                    right);
    };
    const auto at_least_zero = [&](const char* name, Real value) {
        if (!(value >= 0) || !std::isfinite(value))
            refuse(name, shortest(value), "zero or positive, and finite");
    };
    if (!settings.gravity.allFinite())
        refuse("gravity",
               "(" + shortest(settings.gravity.x()) + ", " +
                   shortest(settings.gravity.y()) + ") m/s²",
               "finite");
    if (!(settings.length > 0) || !std::isfinite(settings.length))
        refuse("length", shortest(settings.length) + " m", "positive and finite");
    if (settings.substeps < 1)
        refuse("number of sub-steps", std::to_string(settings.substeps),
               "1 or more");
    at_least_zero("margin", settings.margin);
    at_least_zero("slop", settings.slop);
    require_valid(settings.rest);
    if (settings.solving > Solving::sweeps)
        refuse("solving", std::to_string(static_cast<int>(settings.solving)),
               "one of by_island, exact and sweeps");
    if (settings.sweeps < 1)
        refuse("number of sweeps", std::to_string(settings.sweeps), "1 or more");
    if (!(settings.tolerance > 0) || !std::isfinite(settings.tolerance))
        refuse("tolerance", shortest(settings.tolerance), "positive and finite");
    if (settings.most_exact < 0)
        refuse("number of rows that are exact at most",
               std::to_string(settings.most_exact), "zero or positive");
    at_least_zero("speed of hits", settings.hit_speed);
}

World::World(const WorldSettings& settings)
{
    require_valid(settings);
    state_ = std::make_unique<State>();
    state_->settings = settings;
    state_->filter().set_meets(FilterClasses::nothing, FilterClasses::nothing,
                               false);
    for (int g = 0; g < most_groups; ++g)
        state_->filter().set_meets(FilterClasses::nothing, g, false);
    state_->configure();
}
World::World(std::unique_ptr<State> state) : state_(std::move(state)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

//! [step]
void World::step(Real h)
{
    State& s = *state_;
    require_step(h);
    s.begin_events();
    s.work = {};
    s.work.bodies = s.bodies.count;
    AwakeManifolds& sleepers = s.awake();
    // all sleep, and no call has changed anything: no step would change a bit
    s.work.skipped = s.steps > 0 && !s.changed && sleepers.set.awake.empty() &&
                     s.pulled == world;
    if (!s.work.skipped) {
        const StepSettings how{.h = h,
                               .substeps = s.settings.substeps,
                               .margin = s.settings.margin,
                               .pulled = s.pulled,
                               .hand = s.pulled_to};
        sleepers.touching.finder.tested = -1;  // not looked for yet
        s.method.correction.held.clear();
        rigid::step(s.scene, how, s.method, s.now);
        s.changed = false;
        s.report();
    }
    s.time += h;
    ++s.steps;
    if (s.recording) s.note(Call::step, h, hash());
}
//! [step]

Real World::time() const { return state_->time; }
std::int64_t World::steps() const { return state_->steps; }
const WorldSettings& World::settings() const { return state_->settings; }
const StepWork& World::work() const { return state_->work; }
const Events& World::events() const { return state_->events; }

void World::change(const WorldSettings& settings)
{
    require_valid(settings);
    state_->settings = settings;
    state_->configure();
    state_->changed = true;
    state_->note(Call::change, settings);
}

// ---- bodies ---------------------------------------------------------------------------
BodyId World::add_body(const BodyDefinition& definition)
{
    State& s = *state_;
    const Mass mass = require_valid(definition);
    const std::uint8_t group = definition.sensor
                                   ? FilterClasses::nothing
                                   : s.classes.enter(definition.filter, s.filter());
    const Index place = s.bodies.free.empty()
                            ? Index{-1}
                            : static_cast<Index>(s.bodies.free.back());
    const BodyId id = enter_body(s, definition, mass, group, place);
    s.note(Call::add_body, definition);
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
    const std::uint8_t group = s.classes.enter(filter, s.filter());
    const Index first = s.scene.bodies.count();
    for (Index i = 0; i < trial.bodies.count(); ++i) {
        BodyDefinition edge;
        edge.shape = trial.shapes[static_cast<std::size_t>(i)];
        edge.position = trial.bodies.position(i).head<2>();
        edge.density = 0;
        edge.surface = surface;
        edge.filter = filter;
        if (i > 0) s.classes.enter(filter, s.filter());
        const BodyId id = enter_body(s, edge, Mass{}, group, -1);
        s.note(static_cast<Index>(id.place)).chain = static_cast<int>(first);
    }
    s.scene.chains.push_back({first, s.scene.bodies.count() - 1, closed});
    s.awake().watch.chains = s.scene.chains;  // the edges have woken what they must
    s.note(Call::add_chain, corners, closed, surface, filter);
    return s.id(first);
}

void World::remove(BodyId body)
{
    State& s = *state_;
    const Index k = s.number(body);
    Index first = k, last = k;
    if (const int of = s.note(k).chain; of >= 0) {
        const auto chain = std::find_if(
            s.scene.chains.begin(), s.scene.chains.end(),
            [of](const Chain& it) { return it.first == static_cast<Index>(of); });
        first = chain->first, last = chain->last;
        s.scene.chains.erase(chain);
        s.awake().watch.chains = s.scene.chains;
    }
    for (Index i = first; i <= last; ++i) {
        for (std::size_t j = 0; s.note(i).joints > 0 && j < s.joints.size(); ++j)
            if (s.joints.has(j) &&
                (s.scene.placed[j].joint.a == i || s.scene.placed[j].joint.b == i))
                take_out_joint(s, j);
        take_out_body(s, i);
    }
    s.note(Call::remove_body, body);
}

bool World::has(BodyId body) const { return state_->bodies.has(body); }

std::vector<BodyId> World::bodies() const { return state_->bodies.all(); }

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
    return state_->scene.bodies.velocity(state_->number(body)).head<2>();
}
Real World::spin(BodyId body) const
{
    return state_->scene.bodies.velocity(state_->number(body))[2];
}
Real World::mass(BodyId body) const
{
    return 1 / state_->scene.bodies.inverse_mass[3 * state_->number(body)];
}
Real World::inertia(BodyId body) const
{
    return 1 / state_->scene.bodies.inverse_mass[3 * state_->number(body) + 2];
}
const Polygon& World::shape(BodyId body) const
{
    return state_->shape(state_->number(body));
}
const Surface& World::surface(BodyId body) const
{
    return state_->scene.surfaces[static_cast<std::size_t>(state_->number(body))];
}
const Filter& World::filter(BodyId body) const
{
    return state_->note(state_->number(body)).filter;
}
std::uint64_t World::user(BodyId body) const
{
    return state_->note(state_->number(body)).user;
}
bool World::is_awake(BodyId body) const
{
    const auto k = static_cast<std::size_t>(state_->number(body));
    const std::vector<Activity>& activity = state_->awake().set.activity;
    if (k < activity.size()) return activity[k] == Activity::awake;
    return state_->scene.bodies.can_move(static_cast<Index>(k));  // not stepped yet
}
Vec2 World::point_of(BodyId body, const Vec2& own) const
{
    return rigid::point_of(state_->scene.bodies.x, state_->number_or_world(body),
                           own);
}

void World::move(BodyId body, const Vec2& position, Real angle)
{
    State& s = *state_;
    const Index k = s.number(body);
    if (!position.allFinite() || !std::isfinite(angle))
        throw std::invalid_argument("the body is to go to (" +
                                    shortest(position.x()) + ", " +
                                    shortest(position.y()) + ") m at the angle " +
                                    shortest(angle) + " rad; they must be finite");
    s.scene.bodies.position(k) << position, angle;
    s.disturb(k);
    if (!s.scene.bodies.can_move(k) && !s.note(k).sensor) wake_under(s, k);
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
        throw std::invalid_argument(
            "the body is an edge of a chain; it cannot move");
    s.scene.bodies.velocity(k) << velocity, spin;
    s.disturb(k);
    s.note(Call::set_velocity, body, velocity, spin);
}
void World::set_surface(BodyId body, const Surface& surface)
{
    State& s = *state_;
    const Index k = s.number(body);
    require_surface(surface, "the body");
    write_surface(s, k, surface);
    s.disturb(k);
    s.note(Call::set_surface, body, surface);
}
void World::set_filter(BodyId body, const Filter& filter)
{
    State& s = *state_;
    const Index k = s.number(body);
    if (!s.note(k).sensor) {
        std::uint8_t& group = s.filter().group[static_cast<std::size_t>(k)];
        group = s.classes.change(group, filter, s.filter());
    }
    s.note(k).filter = filter;
    s.disturb(k);
    if (!s.scene.bodies.can_move(k) && !s.note(k).sensor) wake_under(s, k);
    s.note(Call::set_filter, body, filter);
}
void World::set_user(BodyId body, std::uint64_t user)
{
    state_->note(state_->number(body)).user = user;
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
    if (!to.allFinite())
        throw std::invalid_argument("the hand pulls to (" + shortest(to.x()) +
                                    ", " + shortest(to.y()) +
                                    ") m; it must be finite");
    if (k != world && !s.scene.bodies.can_move(k))
        throw std::invalid_argument("the hand pulls body " + std::to_string(k) +
                                    ", which cannot move; it must have a density");
    s.pulled = k;
    s.pulled_to = to;
    s.changed = true;
    s.note(Call::pull, body, to);
}

// ---- walls ----------------------------------------------------------------------------
WallId World::add_wall(const HalfSpace& wall, const Surface& surface)
{
    State& s = *state_;
    RigidScene trial;
    trial.walls.push_back(wall);
    require_bodies(trial);  // throws for a wall that makes no sense
    require_surface(surface, "the wall");
    WallId id;
    if (s.walls.free.empty()) {
        id = s.walls.append();
        s.scene.walls.push_back(wall);
        s.scene.wall_surfaces.push_back(surface);
    } else {
        id = s.walls.take(s.walls.free.back());
        s.scene.walls[id.place] = wall;
        s.scene.wall_surfaces[id.place] = surface;
    }
    s.changed = true;
    s.note(Call::add_wall, wall, surface);
    return id;
}
void World::remove(WallId wall)
{
    State& s = *state_;
    const std::size_t w = s.walls.require(wall, "wall");
    s.touching.forget_wall(static_cast<int>(w), s.meanwhile);
    s.scene.walls[w] = {{0, 1}, -std::numeric_limits<Real>::max() / 4};
    s.walls.give_back(w);
    s.changed = true;
    s.note(Call::remove_wall, wall);
}
bool World::has(WallId wall) const { return state_->walls.has(wall); }
std::vector<WallId> World::walls() const { return state_->walls.all(); }
const HalfSpace& World::wall(WallId wall) const
{
    return state_->scene.walls[state_->walls.require(wall, "wall")];
}

// ---- joints ---------------------------------------------------------------------------
JointId World::add_joint(BodyId a, BodyId b, RigidJoint how)
{
    State& s = *state_;
    how.a = s.number_or_world(a);
    how.b = s.number(b);
    require_valid(how, s.joints.size(), s.scene.bodies);
    const JointId id = enter_joint(s, how);
    s.note(Call::add_joint, a, b, how);
    return id;
}
RigidJoint World::joint_at(JointKind kind, BodyId a, BodyId b,
                           const Vec2& place) const
{
    return rigid::joint_at(state_->scene, kind, state_->number_or_world(a),
                           state_->number(b), place);
}
void World::remove(JointId joint)
{
    State& s = *state_;
    take_out_joint(s, s.joints.require(joint, "joint"));
    s.note(Call::remove_joint, joint);
}
bool World::has(JointId joint) const { return state_->joints.has(joint); }
void World::change(JointId joint, RigidJoint how)
{
    State& s = *state_;
    const std::size_t i = s.joints.require(joint, "joint");
    how.a = s.scene.placed[i].joint.a;
    how.b = s.scene.placed[i].joint.b;
    change_joint(s.scene, i, how);
    s.disturb(how.b);
    s.note(Call::change_joint, joint, how);
}
const RigidJoint& World::joint(JointId joint) const
{
    return state_->placed(joint).joint;
}
std::vector<JointId> World::joints() const { return state_->joints.all(); }
BodyId World::body_a(JointId joint) const
{
    return state_->id(state_->placed(joint).joint.a);
}
BodyId World::body_b(JointId joint) const
{
    return state_->id(state_->placed(joint).joint.b);
}
bool World::is_broken(JointId joint) const { return state_->placed(joint).broken; }
Real World::coordinate(JointId joint) const
{
    return rigid::coordinate(state_->scene.bodies.x, state_->placed(joint).joint);
}
Vec2 World::force(JointId joint) const { return state_->reaction(joint).force; }
Real World::torque(JointId joint) const { return state_->reaction(joint).torque; }
Real World::error(JointId joint) const
{
    const PlacedJoint& placed = state_->placed(joint);
    Real largest = 0;
    for (int i = placed.first; i < placed.first + placed.count; ++i) {
        const PointJoint& row = state_->scene.joints[static_cast<std::size_t>(i)];
        const Real C = joint_constraint(state_->scene.bodies.x, row).C;
        if (row.kind == ConstraintKind::bilateral)
            largest = std::max(largest, std::abs(C));
        if (row.kind == ConstraintKind::unilateral) largest = std::max(largest, -C);
    }
    return largest;
}

// ---- questions ------------------------------------------------------------------------
std::optional<Met> World::ray(const Vec2& from, const Vec2& way,
                              const Filter& filter) const
{
    if (!from.allFinite() || !way.allFinite())
        throw std::invalid_argument("the ray goes from (" + shortest(from.x()) +
                                    ", " + shortest(from.y()) + ") m along (" +
                                    shortest(way.x()) + ", " + shortest(way.y()) +
                                    ") m; they must be finite");
    place_moved(*state_);
    return first_on_ray(*state_, {from, way}, filter);
}
std::optional<Met> World::cast(const Polygon& shape, const Vec2& from, Real angle,
                               const Vec2& way, const Filter& filter) const
{
    require_valid(shape);
    const Vec<3> pose(from.x(), from.y(), angle);
    if (!pose.allFinite() || !way.allFinite())
        throw std::invalid_argument("the shape goes from (" + shortest(from.x()) +
                                    ", " + shortest(from.y()) + ") m along (" +
                                    shortest(way.x()) + ", " + shortest(way.y()) +
                                    ") m; they must be finite");
    place_moved(*state_);
    return first_on_way(*state_, shape, pose, way, filter);
}
std::vector<BodyId> World::overlapping(const Polygon& shape, const Vec2& at,
                                       Real angle, const Filter& filter) const
{
    require_valid(shape);
    if (!at.allFinite() || !std::isfinite(angle))
        throw std::invalid_argument("the shape is at (" + shortest(at.x()) + ", " +
                                    shortest(at.y()) + ") m at the angle " +
                                    shortest(angle) + " rad; they must be finite");
    place_moved(*state_);
    const PlacedShape placed(shape, {at.x(), at.y(), angle});
    std::vector<BodyId> found;
    for_each_overlap(*state_, placed.view(), filter,
                     [&](int k) { found.push_back(state_->id(k)); });
    std::sort(found.begin(), found.end());
    return found;
}
std::vector<BodyId> World::at(const Vec2& point, const Filter& filter) const
{
    return overlapping(disc(0), point, 0, filter);
}

void World::contacts(std::vector<ContactView>& list) const
{
    const State& s = *state_;
    list.clear();
    if (s.work.skipped || !s.is_answered()) return;
    for (std::size_t i = 0; i < s.now.sources.size(); ++i) {
        const Source& source = s.now.sources[i];
        if (source.of != Source::Of::contact || source.part != normal_part)
            continue;
        const Contact& c = s.now.contacts[static_cast<std::size_t>(source.index)];
        Touch touch{s.id(c.a), s.id(c.b), {}};
        if (c.a == world) touch.wall = s.walls.id(wall_of(s.scene, c));
        list.push_back({touch, c.point, c.normal, c.gap,
                        s.now.solution.lambda[static_cast<Index>(i)]});
    }
}

}  // namespace rigid
