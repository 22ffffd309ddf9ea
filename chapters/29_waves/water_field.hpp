/// \file water_field.hpp
/// Shallow water seen from above: the columns of shallow_water.hpp on a square grid, each with four neighbours.
///
///     ∂r/∂t + ∂(r u)/∂x + ∂(r v)/∂y = 0,   ∂u/∂t + u ∂u/∂x + v ∂u/∂y = −g ∂η/∂x,   η = bed + r, and the same for v
///
/// Slopes change the velocities of the faces in both directions by (29.11); then all faces carry water and momentum at
/// once, (29.23), (29.24). A plane on which nothing differs along y moves as the row of columns does, to the bit.
///
/// A step goes over the memory once: a row goes on when those above it have been pushed, while all of them are in the
/// cache. It reads bed, depth, u and v and writes the last three: 56 bytes a cell. \cite stelling2003
#pragma once

#include "common/bodies.hpp"

namespace rigid {

struct WaterField {
    Index nx = 0, ny = 0;  ///< cells
    Real dx = 1;           ///< of a cell, both ways [m]
    Real g = 9.81;         ///< [m/s²]
    Real density = 1000;   ///< [kg/m³]
    VecX bed, depth;       ///< nx · ny, row after row [m]
    VecX
        u;  ///< (nx + 1) ny, of the faces to the left and right of cells; the outermost are the walls' own [m/s]
    VecX v;                  ///< nx (ny + 1), of those below and above
    VecX rows;               ///< memory of a step: some rows
    bool looked_at = false;  ///< memory of step(): it was valid as a whole

    /// Level water of this depth over a level bed, between four walls.
    /// Throws std::invalid_argument for no cells, a width that is not positive, a depth that is negative.
    WaterField(Index nx, Index ny, Real width_of_cell, Real still_depth);

    /// The place of a cell in bed and depth.
    Index at(Index i, Index j) const { return j * nx + i; }
    /// The middle of a cell; the corner of the plane is at (0, 0) [m].
    Vec2 middle_of(Index i, Index j) const
    {
        return dx * Vec2(static_cast<Real>(i) + 0.5, static_cast<Real>(j) + 0.5);
    }
};

/// Throws std::invalid_argument, naming entry and value, unless all is finite, sizes fit and no depth is negative.
void require_valid(const WaterField& water);

/// Σ r Δx² [m³].
Real volume(const WaterField& water);

/// ρ Σ r̄ (u, v) Δx² between the walls, r̄ the mean depth at a face [N s].
Vec2 momentum(const WaterField& water);

/// Kinetic and potential energy, the latter above level water of no depth over the ground zero [J].
Real energy(const WaterField& water);

/// The longest time in which no wave passes a whole cell, Δx / max(|u| + |v| + √(2 g r)) [s]; infinite where all is dry.
Real stable_step(const WaterField& water);

/// One step. Throws std::invalid_argument, before anything changes, for a step that is not positive or beyond
/// stable_step(), and for water that is not valid, as step() of a row.
void step(WaterField& water, Real h);

/// For the time h something presses the surface around a place: at its middle as a column of water `head` high, and less
/// outwards, to nothing at `radius`. Water is moved, none is lost.
/// Throws std::invalid_argument for numbers that are not finite, a radius that is not positive.
void press(WaterField& water, const Vec2& place, Real radius, Real head, Real h);

}  // namespace rigid
