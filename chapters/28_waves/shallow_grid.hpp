/// \file shallow_grid.hpp
/// Shallow water in two directions: the two lines of shallow_water.hpp with two faces more to a cell.
///
///     ∂r/∂t + ∂(r u)/∂x + ∂(r w)/∂z = 0,      ∂u/∂t + u ∂u/∂x + w ∂u/∂z = −g ∂η/∂x,   and likewise w
///
/// Depths belong to cells, u to the faces across x, w to those across z. Mass is kept to rounding, momentum where the bed is
/// level, water at rest stays at rest over any bed with any shores, and no depth becomes negative. \cite stelling2003
///
/// A step passes through memory once: a row of cells is carried as soon as the rows beside it are pushed, while all of them
/// are in the cache. It reads four numbers a cell and writes three.
#pragma once

#include "chapters/28_waves/shallow_water.hpp"

#include <array>
#include <vector>

namespace rigid {

struct ShallowGrid {
    Index nx = 0, nz = 0;             ///< cells
    Real dx = 1;                      ///< side of a cell [m]
    Real origin_x = 0, origin_z = 0;  ///< of the corner of the first cell [m]
    Real g = 9.81;                    ///< [m/s²]
    Real density = 1000;              ///< [kg/m³]
    VecX bed, depth;  ///< nx · nz, row after row; height of the ground, r [m]
    VecX u;           ///< (nx + 1) nz, of the faces across x [m/s]
    VecX w;           ///< nx (nz + 1), of the faces across z [m/s]

    /// Level water of this depth over a level bed between four walls.
    /// Throws std::invalid_argument for fewer than two cells a way, a side that is not positive, a negative depth.
    ShallowGrid(Index nx, Index nz, Real side, Real still_depth);

    Index at(Index i, Index j) const { return j * nx + i; }
    Index face_x(Index i, Index j) const { return j * (nx + 1) + i; }
    Index face_z(Index i, Index j) const { return j * nx + i; }
    Real level(Index cell) const { return bed[cell] + depth[cell]; }
    Real x_of(Index i) const
    {
        return origin_x + dx * (static_cast<Real>(i) + 0.5);
    }
    Real z_of(Index j) const
    {
        return origin_z + dx * (static_cast<Real>(j) + 0.5);
    }

    /// Memory of the pass through the rows.
    struct Rows {
        std::vector<Real> level_low, level, depth_before;
        std::array<std::vector<Real>, 2> giving, along, across, corner;
        std::vector<Real> carried, centre, middle, through, next;
    } rows;
};

/// Throws std::invalid_argument, naming entry and value, unless all is finite, sizes fit and no depth is negative.
void require_valid(const ShallowGrid& water);

/// Σ r Δx² [m³].
Real volume(const ShallowGrid& water);

/// ρ Σ r̄ (u, w) Δx² [N s].
Vec2 momentum(const ShallowGrid& water);

/// Kinetic and potential energy, the latter above no water over the ground zero [J].
Real energy(const ShallowGrid& water);

/// Δx / max(|u| + |w| + √(2 g r)), with the larger of a cell's two u and of its two w: the length that a wave and the water go
/// in it is within the limit of a grid [s]; infinite where all is dry and at rest.
Real stable_step(const ShallowGrid& water);

/// (28.15) along both directions.
void push_water(ShallowGrid& water, Real h);

/// (28.16), (28.17) along both. No cell gives more than it has, whatever h is.
void carry_water(ShallowGrid& water, Real h);

/// Both in one pass through memory, to the same bits. Throws std::invalid_argument for a step that is not positive or beyond
/// stable_step().
void step(ShallowGrid& water, Real h);

/// The smooth mound ½ height (1 + cos πs/R) for s < R around (x, z) is added to the depth, or taken from it as far as there is
/// water.
void add_mound(ShallowGrid& water, Real x, Real z, Real radius, Real height);

/// A wave that is the same in all directions, in rings of width dr: the reference for radial flow in two directions.
///
///     ∂r/∂t + (1/s) ∂(s r u)/∂s = 0,     ∂u/∂t + u ∂u/∂s = −g ∂η/∂s
///
/// The same flux as along a line, through faces whose length grows with s.
struct RadialWater {
    Real dr = 1, g = 9.81;
    VecX depth, u;  ///< of rings, and of the circles between them, from the middle
    VecX flux, carried;

    RadialWater(Index rings, Real radius, Real still_depth);
    Real radius_of(Index i) const { return dr * (static_cast<Real>(i) + 0.5); }
};

/// A step of the rings, over a level bed; the outermost circle is a wall.
void step(RadialWater& water, Real h);

}  // namespace rigid
