/// \file saved_world.hpp
/// All that the next step of a world depends on, as one list of members for writing and for reading.
///
/// What is not in the list is found again by the step itself, to the bit: shapes where their bodies are, boxes, the tree,
/// rows, islands, factors. So a world that was loaded goes on as the one that was saved.
#pragma once

#include "chapters/19_engine/bytes.hpp"
#include "chapters/19_engine/world_state.hpp"

namespace rigid {

// ---- scene ------------------------------------------------------------------------------
template <class Archive>
void members(Archive& io, Polygon& it)
{
    io(it.vertices, it.radius);
}
template <class Archive>
void members(Archive& io, Surface& it)
{
    io(it.friction, it.restitution, it.belt, it.rolling, it.kinetic);
}
template <class Archive>
void members(Archive& io, HalfSpace& it)
{
    io(it.normal, it.offset);
}
template <class Archive>
void members(Archive& io, Chain& it)
{
    io(it.first, it.last, it.closed);
}
template <class Archive>
void members(Archive& io, PointJoint& it)
{
    io(it.measure, it.a, it.b, it.at_a, it.at_b, it.direction, it.gear_a, it.gear_b,
       it.length, it.sense, it.kind, it.speed, it.force, it.stiffness, it.damping,
       it.over_a, it.over_b, it.collides);
}
template <class Archive>
void members(Archive& io, Drive& it)
{
    io(it.speed, it.force, it.stiffness, it.damping, it.target);
}
template <class Archive>
void members(Archive& io, RigidJoint& it)
{
    io(it.kind, it.a, it.b, it.at_a, it.at_b, it.axis, it.angle, it.length,
       it.ratio, it.over_a, it.over_b, it.lower, it.upper, it.motor, it.spring,
       it.torque, it.breaking_force, it.breaking_torque, it.collide_connected);
}
template <class Archive>
void members(Archive& io, PlacedJoint& it)
{
    io(it.joint, it.first, it.count, it.broken);
}
template <class Archive>
void members(Archive& io, Bodies<3>& it)
{
    io(it.x, it.u, it.f, it.inverse_mass);
}
template <class Archive>
void members(Archive& io, CarriedShape& it)
{
    io(it.carrier, it.next, it.middle, it.pushes);
}
template <class Archive>
void members(Archive& io, JointedScene& it)
{
    io(it.bodies, it.shapes, it.joints, it.walls, it.chains, it.gravity, it.length,
       it.surfaces, it.wall_surfaces, it.placed, it.owner, it.carried);
}
template <class Archive>
void members(Archive& io, BodyForces& it)
{
    io(it.gravity, it.force, it.torque, it.damping, it.turning_damping);
}

// ---- the engine's own -------------------------------------------------------------------
template <class Archive>
void members(Archive& io, RestSettings& it)
{
    io(it.speed, it.acceleration, it.time);
}
template <class Archive>
void members(Archive& io, WorldSettings& it)
{
    io(it.gravity, it.length, it.substeps, it.margin, it.slop, it.sleep, it.rest,
       it.solving, it.sweeps, it.tolerance, it.most_exact, it.stop_fast,
       it.hit_speed);
}
template <class Archive, class Thing>
void members(Archive& io, Id<Thing>& it)
{
    io(it.place, it.generation);
}
template <class Archive, class Thing>
void members(Archive& io, Places<Thing>& it)
{
    io(it.generation, it.taken, it.free, it.count);
}
template <class Archive>
void members(Archive& io, Filter& it)
{
    io(it.category, it.meets, it.group);
}
template <class Archive>
void members(Archive& io, Mass& it)
{
    io(it.mass, it.centroid, it.inertia);
}
template <class Archive>
void members(Archive& io, BodyDefinition& it)
{
    io(it.mass, it.shape, it.position, it.angle, it.velocity, it.spin, it.density,
       it.fixed_rotation, it.gravity_scale, it.linear_damping, it.angular_damping,
       it.surface, it.filter, it.sensor, it.bullet, it.user);
}
template <class Archive>
void members(Archive& io, ShapeDefinition& it)
{
    io(it.shape, it.density, it.surface, it.filter, it.sensor, it.user);
}
template <class Archive>
void members(Archive& io, BodyNotes& it)
{
    io(it.filter, it.user, it.sensor, it.bullet, it.chain, it.joints, it.mass,
       it.inertia, it.dynamic, it.fixed_rotation, it.disabled, it.aims);
}
template <class Archive>
void members(Archive& io, JointNotes& it)
{
    io(it.user, it.off, it.was_broken);
}
template <class Archive>
void members(Archive& io, DisabledBody& it)
{
    io(it.body, it.u);
}
template <class Archive>
void members(Archive& io, TouchKey& it)
{
    io(it.a, it.b, it.wall);
}
template <class Archive>
void members(Archive& io, Touch& it)
{
    io(it.a, it.b, it.wall);
}
template <class Archive>
void members(Archive& io, HeldTouch& it)
{
    io(it.key, it.touch);
}
template <class Archive>
void members(Archive& io, Seen& it)
{
    io(it.sensor, it.body);
}
template <class Archive>
void members(Archive& io, Events& it)
{
    io(it.ended, it.left);
}

// ---- what the stages keep ---------------------------------------------------------------
template <class Archive>
void members(Archive& io, ImpulseKey& it)
{
    io(it.first, it.second, it.feature, it.part);
}
template <class Archive>
void members(Archive& io, ImpulseCache::Entry& it)
{
    io(it.key, it.unseen, it.lambda);
}
template <class Archive>
void members(Archive& io, AwakeSet& it)
{
    io(it.activity, it.awake, it.ring, it.woken);
}
template <class Archive>
void members(Archive& io, Rest& it)
{
    io(it.time, it.top_speed, it.undisturbed);
}
template <class Archive>
void members(Archive& io, SleepingForces::Entry& it)
{
    io(it.key, it.force, it.next);
}
template <class Archive>
void members(Archive& io, SleepingForces& it)
{
    io(it.entries, it.head, it.free);
}
template <class Archive>
void members(Archive& io, RestConditions& it)
{
    io(it.gravity, it.stiffness, it.damping, it.rest, it.correction.beta,
       it.correction.slop, it.sleep);
}
template <class Archive>
void members(Archive& io, ToldChanges& it)
{
    io(it.told, it.known, it.around.walls, it.around.chains, it.around.gravity);
}
template <class Archive>
void members(Archive& io, Manifold& it)
{
    io(it.normal, it.count, it.face, it.normal_of);
    for (ManifoldPoint& p : it.points) io(p.point, p.gap, p.feature);
}
template <class Archive>
void members(Archive& io, TouchingPair& it)
{
    io(it.a, it.b, it.manifold);
}

//! [members]
template <class Archive>
void members(Archive& io, EngineState& it)
{
    members(io, static_cast<JointedScene&>(it.scene));
    io(it.settings, it.scene.acting, it.bodies, it.joints, it.walls, it.notes,
       it.disabled, it.joint_notes);
    io(it.sensors, it.more_shapes, it.touching.held, it.touching.asleep, it.seen,
       it.meanwhile, it.time, it.steps, it.pulled, it.pulled_to, it.changed);
    // what begins the next step's answer
    io(it.method.start.cache.entries, it.method.start.cache.h);
    // which bodies are awake, and with what the sleepers will wake
    ToldManifolds& sleepers = it.awake();
    io(sleepers.set, sleepers.rests, sleepers.forces, sleepers.u_before,
       sleepers.changed, sleepers.length, sleepers.margin, sleepers.conditions,
       sleepers.watch);
    // the names of contacts
    Manifolds& stage = sleepers.touching;
    io(stage.touching, stage.resting);
    // a change of these would wake bodies
    io(it.method.contacts.was_broken, it.method.contacts.walls);
}
//! [members]

}  // namespace rigid
