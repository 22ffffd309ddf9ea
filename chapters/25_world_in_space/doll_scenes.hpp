/// \file doll_scenes.hpp
/// Dolls of eleven parts in space, and stairs for them to fall down.
#pragma once

#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"
#include "chapters/25_world_in_space/space_scene.hpp"

namespace rigid {

inline constexpr Index doll_parts = 11;

/// Adds a doll of about 60 kg that stands at a point, looks along x and holds its arms
/// out. Ball joints bend within a cone and turn within a range; elbows and knees
/// are hinges that bend one way.
void add_doll(SpaceScene& scene, const Vec3& at);

/// Stairs that go down along x, of steps that are 0.3 m deep and 0.18 m high, from a landing of 2 m, and a floor.
void add_stairs(SpaceScene& scene, int steps, Real width, Real mu);

/// Dolls on the landing, five in a row and each row above the one before, which all move at a speed towards the stairs.
SpaceScene dolls_on_stairs(int dolls, Real speed, int steps = 10);

/// How far the limits of joints are overstepped, at most, and not by less than zero [rad, m].
Real largest_limit_error(const SpaceScene& scene);

}  // namespace rigid
