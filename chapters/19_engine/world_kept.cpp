/// \file world_kept.cpp
/// What outlives a world: its bytes, a number of all of it, and the calls that it was given.
#include "common/eigen_instances.hpp"

#include "chapters/19_engine/world_cpp.hpp"

namespace rigid {

namespace {

constexpr std::string_view of_a_world = "rigid world 6\n",
                           of_a_recording = "rigid recording 4\n";

/// Payload with its heading and its hash, so that no other bytes are taken for it.
std::string sealed(std::string_view heading, const std::string& payload)
{
    Writer end;
    end(hash_of(payload));
    return std::string(heading) + payload + end.bytes;
}

std::string_view unsealed(std::string_view heading, std::string_view bytes)
{
    if (bytes.size() < heading.size() + 8 || !bytes.starts_with(heading))
        throw std::invalid_argument(
            "the " + std::to_string(bytes.size()) + " bytes do not begin with \"" +
            std::string(heading.substr(0, heading.size() - 1)) +
            "\"; they must be what save() returned");
    const std::string_view payload =
        bytes.substr(heading.size(), bytes.size() - heading.size() - 8);
    std::uint64_t hash = 0;
    Reader(bytes.substr(bytes.size() - 8))(hash);
    if (hash != hash_of(payload))
        throw std::invalid_argument("the bytes were changed since save() returned "
                                    "them: their sum is another");
    return payload;
}

}  // namespace

//! [save]
std::string World::save() const
{
    Writer io;
    members(io, static_cast<EngineState&>(*state_));
    return sealed(of_a_world, io.bytes);
}

World World::load(std::string_view bytes)
{
    auto state = std::make_unique<State>();
    Reader io(unsealed(of_a_world, bytes));
    members(io, static_cast<EngineState&>(*state));
    if (!io.at_end()) Reader::refuse();
    require_valid(state->settings);
    require_valid(static_cast<const RigidScene&>(state->scene));
    state->configure();
    for (Index k = 0; k < state->scene.bodies.count(); ++k) {
        state->displace(state->scene.carrier(k));
        state->write_filter(k);
    }
    return World(std::move(state));
}
//! [save]

std::uint64_t World::hash() const
{
    Writer io;
    io(state_->scene.bodies.x, state_->scene.bodies.u);
    return hash_of(io.bytes);
}

void World::record(Recording* recording)
{
    if (recording) {
        recording->start_ = save();
        recording->calls_ = {};
    }
    state_->recording = recording;
}

namespace {

/// Reads the arguments of a call and makes it.
template <class... Arguments, class Make>
void again(Reader& io, const Make& make)
{
    std::tuple<Arguments...> arguments;
    std::apply([&](Arguments&... each) { (io(each), ...); }, arguments);
    std::apply(make, arguments);
}

void call_again(World& here, Call call, Reader& io)
{
    switch (call) {
    case Call::step:
        break;
    case Call::change:
        return again<WorldSettings>(io, [&](auto& s) { here.change(s); });
    case Call::add_body:
        return again<BodyDefinition>(io, [&](auto& b) { here.add_body(b); });
    case Call::add_shapes:
        return again<BodyDefinition, std::vector<ShapeDefinition>>(
            io, [&](auto& b, auto& more) { here.add_body(b, more); });
    case Call::add_chain:
        return again<std::vector<Vec2>, bool, Surface, Filter>(
            io, [&](auto& p, bool closed, auto& s, auto& f) {
                here.add_chain(p, closed, s, f);
            });
    case Call::remove_body:
        return again<BodyId>(io, [&](auto b) { here.remove(b); });
    case Call::move:
        return again<BodyId, Vec2, Real>(
            io, [&](auto b, auto& p, Real angle) { here.move(b, p, angle); });
    case Call::set_velocity:
        return again<BodyId, Vec2, Real>(
            io, [&](auto b, auto& v, Real spin) { here.set_velocity(b, v, spin); });
    case Call::set_surface:
        return again<BodyId, Surface>(
            io, [&](auto b, auto& s) { here.set_surface(b, s); });
    case Call::set_filter:
        return again<BodyId, Filter>(
            io, [&](auto b, auto& f) { here.set_filter(b, f); });
    case Call::set_user:
        return again<BodyId, std::uint64_t>(
            io, [&](auto b, auto u) { here.set_user(b, u); });
    case Call::wake:
        return again<BodyId>(io, [&](auto b) { here.wake(b); });
    case Call::push:
        return again<BodyId, Vec2, Vec2>(
            io, [&](auto b, auto& p, auto& at) { here.push(b, p, at); });
    case Call::pull:
        return again<BodyId, Vec2>(io, [&](auto b, auto& to) { here.pull(b, to); });
    case Call::add_wall:
        return again<HalfSpace, Surface>(
            io, [&](auto& w, auto& s) { here.add_wall(w, s); });
    case Call::remove_wall:
        return again<WallId>(io, [&](auto w) { here.remove(w); });
    case Call::add_joint:
        return again<BodyId, BodyId, RigidJoint>(
            io, [&](auto a, auto b, auto& how) { here.add_joint(a, b, how); });
    case Call::remove_joint:
        return again<JointId>(io, [&](auto j) { here.remove(j); });
    case Call::change_joint:
        return again<JointId, RigidJoint>(
            io, [&](auto j, auto& how) { here.change(j, how); });
    case Call::set_target:
        return again<BodyId, Vec2, Real, Real>(
            io, [&](auto b, auto& p, Real angle, Real h) {
                here.set_target(b, p, angle, h);
            });
    case Call::set_force:
        return again<BodyId, Vec2, Real>(io, [&](auto b, auto& f, Real torque) {
            here.set_force(b, f, torque);
        });
    case Call::set_gravity_scale:
        return again<BodyId, Real>(
            io, [&](auto b, Real s) { here.set_gravity_scale(b, s); });
    case Call::set_damping:
        return again<BodyId, Real, Real>(io, [&](auto b, Real d, Real turning) {
            here.set_damping(b, d, turning);
        });
    case Call::set_fixed_rotation:
        return again<BodyId, bool>(
            io, [&](auto b, bool yes) { here.set_fixed_rotation(b, yes); });
    case Call::set_enabled:
        return again<BodyId, bool>(
            io, [&](auto b, bool yes) { here.set_enabled(b, yes); });
    case Call::set_kind:
        return again<BodyId, BodyKind>(
            io, [&](auto b, auto kind) { here.set_kind(b, kind); });
    case Call::set_mass:
        return again<BodyId, Real, Real>(io, [&](auto b, Real m, Real inertia) {
            here.set_mass(b, m, inertia);
        });
    case Call::set_shape:
        return again<BodyId, Polygon>(
            io, [&](auto b, auto& shape) { here.set_shape(b, shape); });
    case Call::set_bullet:
        return again<BodyId, bool>(
            io, [&](auto b, bool yes) { here.set_bullet(b, yes); });
    case Call::set_joint_user:
        return again<JointId, std::uint64_t>(
            io, [&](auto j, auto u) { here.set_user(j, u); });
    case Call::set_wall_surface:
        return again<WallId, Surface>(
            io, [&](auto w, auto& s) { here.set_surface(w, s); });
    }
    Reader::refuse();
}

}  // namespace

//! [replay]
Replay Recording::replay(const std::function<void(const World&)>& after,
                         const std::function<void(World&)>& before) const
{
    Replay result{start(), 0, -1};
    if (before) before(result.world);
    Reader io(calls_.bytes);
    while (!io.at_end()) {
        Call call{};
        io(call);
        if (call != Call::step) {
            call_again(result.world, call, io);
            continue;
        }
        Real h = 0;
        std::uint64_t hash = 0;
        io(h, hash);
        result.world.step(h);
        if (result.differs_at < 0 && result.world.hash() != hash)
            result.differs_at = result.steps;
        ++result.steps;
        if (after) after(result.world);
    }
    return result;
}
//! [replay]

std::string Recording::save() const
{
    Writer io;
    io(start_, calls_.bytes);
    return sealed(of_a_recording, io.bytes);
}

Recording Recording::load(std::string_view bytes)
{
    Recording recording;
    Reader io(unsealed(of_a_recording, bytes));
    io(recording.start_, recording.calls_.bytes);
    if (!io.at_end()) Reader::refuse();
    return recording;
}

}  // namespace rigid
