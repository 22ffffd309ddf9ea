/// \file world_walls_joints.cpp
/// Walls and joints: in, out, and what a world says of them.
#include "common/eigen_instances.hpp"

#include "chapters/19_engine/world.hpp"

#include "chapters/19_engine/world_cpp.hpp"
#include "chapters/19_engine/world_things.hpp"

namespace rigid {

WallId World::add_wall(const HalfSpace& wall, const Surface& surface)
{
    State& s = *state_;
    RigidScene trial;
    trial.walls.push_back(wall);
    require_bodies(trial);  // throws for a wall that makes no sense
    if (!(std::abs(wall.offset) <= largest_number))
        throw std::invalid_argument("the wall has the offset " +
                                    shortest(wall.offset) +
                                    " m; it must not be beyond 1e75");
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
const Surface& World::surface(WallId wall) const
{
    return state_->scene.wall_surfaces[state_->walls.require(wall, "wall")];
}
void World::set_surface(WallId wall, const Surface& surface)
{
    State& s = *state_;
    const std::size_t w = s.walls.require(wall, "wall");
    require_surface(surface, "the wall");
    s.scene.wall_surfaces[w] = surface;
    for (const auto* const list : {&s.touching.held, &s.touching.asleep})
        for (const HeldTouch& it : *list)
            if (it.key.wall == static_cast<int>(w)) s.disturb(it.key.b);
    s.note(Call::set_wall_surface, wall, surface);
}
const HalfSpace& World::wall(WallId wall) const
{
    return state_->scene.walls[state_->walls.require(wall, "wall")];
}

JointId World::add_joint(BodyId a, BodyId b, RigidJoint how)
{
    State& s = *state_;
    how.a = s.number_or_world(a);
    how.b = s.number(b);
    require_joint(s, s.joints.size(), how);
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
    const std::vector<PointJoint> before = rows_of(s.scene.placed[i].joint);
    replace_joint(s, i, how);
    if (rows_of(how) != before && how.a != world) s.awake().watch.tell(how.a);
    s.disturb(how.b);
    s.note(Call::change_joint, joint, how);
}
const RigidJoint& World::joint(JointId joint) const
{
    return state_->placed(joint).joint;
}
std::vector<JointId> World::joints() const { return state_->joints.all(); }
std::vector<JointId> World::joints(BodyId body) const
{
    const State& s = *state_;
    std::vector<JointId> found;
    for_each_joint_of(s, s.number(body),
                      [&](std::size_t j) { found.push_back(s.joints.id(j)); });
    return found;
}
std::uint64_t World::user(JointId joint) const
{
    return state_->joint_notes[state_->joints.require(joint, "joint")].user;
}
void World::set_user(JointId joint, std::uint64_t user)
{
    state_->joint_notes[state_->joints.require(joint, "joint")].user = user;
    state_->note(Call::set_joint_user, joint, user);
}
BodyId World::body_a(JointId joint) const
{
    return state_->id(state_->placed(joint).joint.a);
}
BodyId World::body_b(JointId joint) const
{
    return state_->id(state_->placed(joint).joint.b);
}
bool World::is_broken(JointId joint) const
{
    const std::size_t i = state_->joints.require(joint, "joint");
    const JointNotes& note = state_->joint_notes[i];
    return note.off ? note.was_broken : state_->scene.placed[i].broken;
}
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

}  // namespace rigid
