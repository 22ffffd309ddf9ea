/// \file world_things.hpp
/// How bodies, chains and joints get into the scene of a world and out of it again, while everything sleeps that it does
/// not concern.
///
/// Numbers of bodies and joints are names: of impulses, of pairs, of sleepers. So nothing moves up when something is taken
/// out. Its place stays, as a point that meets nothing, or as a joint that is broken, until something new takes it.
#pragma once

#include "chapters/19_engine/body_checks.hpp"
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
    sleepers.touching.finder.tree.overlapping(box, [&](int b) {
        if (b < static_cast<int>(sleepers.set.activity.size()))
            sleepers.set.wake(b);
    });
}

//! [surface]
inline void write_surface(EngineState& state, Index k, const Surface& surface)
{
    state.scene.surfaces.resize(state.scene.shapes.size());
    state.scene.surfaces[static_cast<std::size_t>(k)] = surface;
}
//! [surface]

//! [add]
/// \param place  of a body that was taken out; −1: at the end
inline BodyId enter_body(EngineState& state, const BodyDefinition& body,
                         const Mass& mass, std::uint8_t group, Index place)
{
    JointedScene& scene = state.scene;
    BodyId id;
    Index k = place;
    if (place < 0) {
        k = add_body(scene, body.shape, mass, body.position, body.angle);
        id = state.bodies.append();
        state.notes.emplace_back();
        state.filter().group.push_back(group);
    } else {
        id = state.bodies.take(static_cast<std::size_t>(k));
        const bool moves = mass.mass > 0;
        scene.bodies.position(k) << body.position, body.angle;
        scene.bodies.inverse_mass.segment<3>(3 * k) << (moves ? 1 / mass.mass : 0),
            (moves ? 1 / mass.mass : 0), (moves ? 1 / mass.inertia : 0);
        Polygon& shape = scene.shapes[static_cast<std::size_t>(k)];
        shape = body.shape;
        for (Vec2& vertex : shape.vertices) vertex -= mass.centroid;
        state.filter().group[static_cast<std::size_t>(k)] = group;
    }
    scene.bodies.velocity(k) << body.velocity, body.spin;
    state.forget_motion(k);
    state.note(k) = {body.filter, body.user, body.sensor, body.bullet, -1, 0};
    state.sensors += body.sensor;
    write_surface(state, k, body.surface);
    state.disturb(k);
    state.list_unstopped(k);
    state.list_slop(k);
    if (!(mass.mass > 0) && !body.sensor) wake_under(state, k);
    return id;
}
//! [add]

//! [take_out]
/// A body's place stays, as a point that meets nothing.
inline void take_out_body(EngineState& state, Index k)
{
    state.disturb(k);
    state.touching.forget(static_cast<int>(k), state.meanwhile);
    const BodyId gone = state.id(k);
    std::erase_if(state.seen, [&](const Seen& seen) {
        if (seen.sensor != gone && seen.body != gone) return false;
        state.meanwhile.left.push_back(seen);
        return true;
    });
    Bodies<3>& bodies = state.scene.bodies;
    bodies.inverse_mass.segment<3>(3 * k).setZero();
    bodies.velocity(k).setZero();
    state.forget_motion(k);
    state.scene.shapes[static_cast<std::size_t>(k)] = disc(0);
    std::uint8_t& group = state.filter().group[static_cast<std::size_t>(k)];
    state.classes.leave(group);
    group = FilterClasses::nothing;
    write_surface(state, k, Surface{0, 0, 0, 0});
    state.sensors -= state.note(k).sensor;
    state.note(k) = {};
    state.bodies.give_back(static_cast<std::size_t>(k));
    if (state.pulled == k) state.pulled = world;
}

/// A joint's place stays, as rows that hold nothing.
inline void take_out_joint(EngineState& state, std::size_t number)
{
    PlacedJoint& placed = state.scene.placed[number];
    for (const Index k : {placed.joint.a, placed.joint.b})
        if (k != world) {
            --state.note(k).joints;
            state.list_unstopped(k);
            state.disturb(k);
        }
    for (int i = 0; i < placed.count; ++i) {
        PointJoint nothing;
        nothing.b = placed.joint.b;
        nothing.at_b = {1, 0};
        nothing.collides = true;
        state.scene.joints[static_cast<std::size_t>(placed.first + i)] = nothing;
    }
    placed.broken = true;
    state.joints.give_back(number);
}
//! [take_out]

/// A joint in a free place with as many rows, or at the end.
inline JointId enter_joint(EngineState& state, const RigidJoint& joint)
{
    JointedScene& scene = state.scene;
    std::vector<PointJoint> rows;
    add_frame_rows(joint, rows);
    add_drive_rows(joint, rows);
    const auto fits = [&](std::uint32_t place) {
        return scene.placed[place].count == static_cast<int>(rows.size());
    };
    const auto free =
        std::find_if(state.joints.free.rbegin(), state.joints.free.rend(), fits);
    JointId id;
    if (free == state.joints.free.rend()) {
        add_joint(scene, joint);
        id = state.joints.append();
    } else {
        id = state.joints.take(*free);
        PlacedJoint& placed = scene.placed[id.place];
        placed.joint = joint;
        placed.broken = false;
        std::copy(rows.begin(), rows.end(), scene.joints.begin() + placed.first);
    }
    for (const Index k : {joint.a, joint.b})
        if (k != world) {
            ++state.note(k).joints;
            state.list_unstopped(k);
            state.disturb(k);
        }
    return id;
}

}  // namespace rigid
