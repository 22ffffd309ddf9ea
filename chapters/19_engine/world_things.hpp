/// \file world_things.hpp
/// How bodies and chains get into the scene of a world and out of it again, and are switched off and on, while everything
/// sleeps that it does not concern.
///
/// Numbers of bodies are names: of impulses, of pairs, of sleepers. So nothing moves up when something is taken out. Its place
/// stays, as a point that meets nothing, until something new takes it.
#pragma once

#include "chapters/19_engine/body_checks.hpp"
#include "chapters/19_engine/joint_places.hpp"
#include "chapters/19_engine/shape_queries.hpp"

namespace rigid {

/// What sleeps where a new body is that cannot move wakes. (One that can move is
/// awake itself, and looks.)
inline void wake_under(EngineState& state, Index k)
{
    place_moved(state);
    ToldManifolds& sleepers = state.awake();
    const Box box =
        grown(sleepers.touching.placed.boxes[static_cast<std::size_t>(k)],
              state.metres(state.settings.margin));
    // boxes in the tree are as large as earlier steps have left them, and are not saved
    const std::vector<Box>& boxes = sleepers.touching.placed.boxes;
    sleepers.touching.finder.tree.overlapping(box, [&](int b) {
        if (b < static_cast<int>(sleepers.set.activity.size()) &&
            overlap(box, boxes[static_cast<std::size_t>(b)]))
            sleepers.set.wake(state.scene.carrier(b));
    });
}

//! [surface]
inline void write_surface(EngineState& state, Index k, const Surface& surface)
{
    state.scene.surfaces.resize(state.scene.shapes.size());
    state.scene.surfaces[static_cast<std::size_t>(k)] = surface;
}
//! [surface]

//! [shapes]
/// Shape k is of this body from now on, as its last one. The list begins with the
/// first body that has several.
/// \param middle  the centroid of the shape, in the body's axes [m]
inline void list_shape(RigidScene& scene, Index k, Index carrier,
                       const Vec2& middle = {0, 0}, bool pushes = true)
{
    std::vector<CarriedShape>& carried = scene.carried;
    const auto at = [&](Index i) -> CarriedShape& {
        return carried[static_cast<std::size_t>(i)];
    };
    for (auto i = static_cast<Index>(carried.size()); i < scene.bodies.count(); ++i)
        carried.push_back({i, i});
    at(k) = {carrier, k, middle, pushes};
    if (k == carrier) return;
    Index last = carrier;
    while (at(last).next != carrier) last = at(last).next;
    at(last).next = k;
    at(k).next = carrier;
}
//! [shapes]

//! [add]
/// \param place    of a body that was taken out; −1: at the end
/// \param carrier  the body whose shape it is; the world: it is a body of its own
/// \param middle   its centroid in the axes of that [m]
inline BodyId enter_body(EngineState& state, const BodyDefinition& body,
                         const Mass& mass, Index place, Index carrier = world,
                         const Vec2& middle = {0, 0})
{
    JointedScene& scene = state.scene;
    BodyId id;
    Index k = place;
    if (place < 0) {
        k = add_body(scene, body.shape, mass, body.position, body.angle);
        id = state.bodies.append();
        state.notes.emplace_back();
    } else {
        id = state.bodies.take(static_cast<std::size_t>(k));
        scene.bodies.position(k) << body.position, body.angle;
        Polygon& shape = scene.shapes[static_cast<std::size_t>(k)];
        shape = body.shape;
        for (Vec2& vertex : shape.vertices) vertex -= mass.centroid;
    }
    if (carrier != world) list_shape(scene, k, carrier, middle, !body.sensor);
    else if (!scene.carried.empty()) list_shape(scene, k, k);
    scene.bodies.velocity(k) << body.velocity, body.spin;
    BodyNotes& notes = state.note(k);
    notes = {body.filter, body.user, body.sensor, body.bullet};
    notes.mass = mass.mass, notes.inertia = mass.inertia;
    notes.dynamic = mass.mass > 0;
    notes.fixed_rotation = body.fixed_rotation;
    state.write_mass(k);
    state.write_filter(k);
    state.act(
        k,
        {body.gravity_scale, {0, 0}, 0, body.linear_damping, body.angular_damping});
    state.sensors += body.sensor;
    state.more_shapes += carrier != world;
    write_surface(state, k, body.surface);
    state.disturb(k);
    state.forget_motion(k);
    state.list_unstopped(scene.carrier(k));
    if (state.is_ground(k)) wake_under(state, k);
    return id;
}
//! [add]

/// All that comes and goes with body k: the edges of its chain, or its shapes.
inline std::vector<Index> whole_of(const EngineState& state, Index k)
{
    std::vector<Index> all;
    if (state.note(k).chain < 0)
        state.scene.for_each_shape(k, [&](Index shape) { all.push_back(shape); });
    for (const Chain& chain : state.scene.chains)
        if (state.note(k).chain == chain.first)
            for (Index i = chain.first; i <= chain.last; ++i) all.push_back(i);
    return all;
}

/// What body k touched and saw ends, and it stands.
inline void stop_and_forget(EngineState& state, Index k)
{
    state.disturb(k);
    state.touching.forget(static_cast<int>(k), state.meanwhile);
    const BodyId gone = state.id(k);
    std::erase_if(state.seen, [&](const Seen& seen) {
        if (seen.sensor != gone && seen.body != gone) return false;
        state.meanwhile.left.push_back(seen);
        return true;
    });
    state.scene.bodies.velocity(k).setZero();
    state.forget_motion(k);
}

//! [take_out]
/// A body's place stays, as a point that meets nothing.
inline void take_out_body(EngineState& state, Index k)
{
    stop_and_forget(state, k);
    std::erase_if(state.disabled, [k](const auto& it) { return it.body == k; });
    state.scene.shapes[static_cast<std::size_t>(k)] = disc(0);
    write_surface(state, k, Surface{0, 0, 0, 0});
    state.sensors -= state.note(k).sensor;
    state.note(k) = {};
    state.act(k, {});
    state.bodies.give_back(static_cast<std::size_t>(k));
    state.taken_out.push_back(static_cast<int>(k));
    state.write_mass(k);
    state.write_filter(k);
}

//! [take_out]

//! [switch]
/// Body k is off: it is where it is, moves and meets nothing and is found by nobody.
/// On again, it goes on with the velocity that it had.
inline void switch_body(EngineState& state, Index k, bool on)
{
    if (state.note(k).disabled != on) return;
    if (!on) {
        state.disabled.push_back({static_cast<int>(k), state.velocity(k)});
        stop_and_forget(state, k);
        state.note(k).disabled = true;
    } else {
        const Vec<3> u = state.velocity(k);
        std::erase_if(state.disabled, [k](const auto& it) { return it.body == k; });
        state.note(k).disabled = false;
        state.set_velocity(k, u);
        state.forget_motion(k);
        state.disturb(k);
    }
    state.write_mass(k);
    state.write_filter(k);
    for_each_joint_of(state, k, [&](std::size_t j) { switch_joint(state, j); });
}
//! [switch]

}  // namespace rigid
