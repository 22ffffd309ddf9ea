/// \file scenes.hpp
/// Scenes made of discs that do not turn: what is where, without any method.
///
/// Coordinates: metres, x to the right, y up, the origin in the middle of the picture.
#pragma once

#include "common/bodies.hpp"
#include "common/pair_set.hpp"
#include "common/shapes.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace rigid {

struct DiscScene {
    static constexpr int dof = 2;

    Bodies<2> bodies;
    VecX radius;  ///< [m], one for each disc
    std::vector<HalfSpace> walls;
    std::vector<Segment> segments;  ///< walls with two ends
    std::vector<Link> links;
    std::vector<Bend> bends;
    std::vector<Joint> joints;
    PairSet linked;             ///< these pairs do not collide; made by link_neighbours()
    Vec2 gravity = {0, -9.81};  ///< [m/s²]
    Vec2 half_size = {1, 1};    ///< what a picture should show: the origin ± this [m]
    Real length = 0;            ///< the length that settings are measured in [m]; 0 = typical_length()
};

//! [typical_length]
/// The length that a scene's settings are measured in [m]: `scene.length`, and
/// where that is zero the power of ten that is nearest to ten times the mean
/// radius of the discs that can move (of all, where none can): 1 m for radii
/// around 0.1 m, and where there are no radii. A margin or a slop is chosen by
/// its order of magnitude, so nothing finer is derived. To scale a scene by 2,
/// set the length.
Real typical_length(const DiscScene& scene);
//! [typical_length]

/// Fills `linked` from `links`: discs that a rod joins do not collide with each other.
void link_neighbours(DiscScene& scene);

/// Throws std::invalid_argument, naming the thing and the value, unless the scene makes sense:
/// finite numbers, masses not negative, radii positive, unit normals, body indices that exist,
/// no link of a body to itself, no bend that names one twice, no rest length of zero or less.
void require_valid(const DiscScene& scene);

/// Throws std::invalid_argument, naming the thing, unless each link, bend and joint names bodies of the scene, and there
/// are as many radii as bodies. A few comparisons for each of them: cheap enough for every step.
void require_bodies(const DiscScene& scene);

/// Adds a disc at rest to a scene, also to one that is running; a world that skips has a door of its own,
/// scene_edits.hpp of chapter 10.
/// \param mass    [kg], positive; infinity = cannot move
/// \param radius  [m]
/// \return        its number
/// \throws std::invalid_argument  for a mass or a radius that makes no sense
Index add_disc(DiscScene& scene, const Vec2& position, Real mass, Real radius);

/// Throws std::invalid_argument, "the number of discs in a column is 0; …", unless there is one at least. For functions
/// that build scenes by number.
void require_count(const std::string& what, Index count);

/// The scene that this book grew from, \cite yamanishi2023, in our units: a chain of seven discs of 0.1 kg and three
/// free discs in a box of 1.5 m × 1.0 m. Links and torsional springs join the seven.
DiscScene ten_discs();

/// N equal discs of mass 1 kg and radius 0.1 m, one above the other and touching, on a floor.
/// \param top_mass  mass of the uppermost [kg]
DiscScene column(Index count, Real top_mass = 1);

/// The same column between two walls that leave `clearance` on either side of it [m].
DiscScene column_between_walls(Index count, Real top_mass = 1, Real clearance = 0);

/// Discs of mass 1 kg and radius 0.1 m packed as a triangle: `base` of them on the floor, wall to wall and
/// touching, each row above one disc shorter, each disc on two. K = base (base + 1) / 2, the lowest row first.
DiscScene triangle(Index base);

/// N discs of mass 1 kg on N links of 0.1 m, the first linked to a disc that cannot move
/// (body 0, at the origin), hanging straight down. K = N + 1 bodies.
/// \param end_mass  mass of the lowest [kg]
DiscScene hanging_chain(Index count, Real end_mass = 1);

/// The same chain, straight to the right of its anchor and at rest: it swings.
DiscScene swinging_chain(Index count, Real end_mass = 1);

/// A puck of 10 kg with two discs of 1 kg on links of 0.5 m behind it, on a table without gravity or walls.
/// Body 0 is the puck; a program gives it a push.
DiscScene towed_discs();

/// The scene with each disc that can move set off by `amount` [m], each in a direction of its own. A scene that is at
/// rest to the last bit hides what a breath would topple: a chain that hangs exactly straight has no sideways motion to
/// grow. The same seed gives the same directions with every compiler.
/// \param amount  [m]; far below any error that is measured, far above the rounding of a position
/// \throws std::invalid_argument  unless the amount is finite and not negative
DiscScene perturbed(DiscScene scene, std::uint64_t seed, Real amount = 1e-9);

}  // namespace rigid
