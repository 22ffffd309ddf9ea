/// \file shallow_water.hpp
/// Water that is shallow beside its waves: columns that stand side by side, each pushed by the slope to its neighbours.
///
///     ∂r/∂t + ∂(r u)/∂x = 0,      ∂u/∂t + u ∂u/∂x = −g ∂η/∂x,      η = bed + r
///
/// Depths r belong to cells, velocities u to the faces between them. A step is again the two lines of chapter 1: slopes
/// change velocities, velocities carry water (and its momentum) from cell to cell.
///
///     u_f ← u_f − h g (η_{i+1} − η_i) / Δx                       (29.11)
///     r_i ← r_i − (h / Δx) (q_{i+1} − q_i),   q_f = u_f r_upwind   (29.12)
///
/// What leaves a cell enters its neighbour, so mass is kept to rounding, and momentum where the bed is level; no depth
/// becomes negative, and water at rest stays at rest over any bed. \cite stelling2003
#pragma once

#include "common/bodies.hpp"

#include <vector>

namespace rigid {

struct ShallowWater {
    Real dx = 1;          ///< width of a cell [m]
    Real origin = 0;      ///< x of the left wall [m]
    Real g = 9.81;        ///< [m/s²]
    Real density = 1000;  ///< of a plane of water one metre thick [kg/m²]
    VecX bed;             ///< N, height of the ground [m]
    VecX depth;  ///< N, r: thickness of the water alone, without bodies [m]
    VecX
        level;  ///< N, η: height of the surface; where bodies float above bed + depth [m]
    VecX
        u;  ///< N + 1, of the faces [m/s]; the first and the last are the walls' own
    VecX damping;  ///< of a sponge: N + 1 [1/s], or empty
    /// N + 1: the part of the water's depth at a face that is pushed by the slope there; less than 1 under a hull that
    /// presses on the ground (floating.hpp)
    VecX part;
    VecX carried;  ///< N + 1, memory: r u of a face after the last step [m²/s]
    VecX flux;     ///< N + 1, memory: q of the last step [m²/s]
    VecX giving;   ///< N, memory: how deep the water is that may leave a cell [m]
    std::vector<ShallowWater> window;  ///< memory of step(): one, of a few columns
    bool looked_at = false;  ///< memory of step(): it was valid as a whole

    /// Level water of this depth over a level bed, between two walls.
    /// Throws std::invalid_argument for fewer than two cells, a length that is not positive, a depth that is negative.
    ShallowWater(Index cells, Real length, Real still_depth);

    Index cells() const { return depth.size(); }
    /// The middle of cell i [m].
    Real x_of(Index i) const { return origin + dx * (static_cast<Real>(i) + 0.5); }
    /// The cell at x; the first or the last one beyond the walls.
    Index cell_at(Real x) const;
};

/// Throws std::invalid_argument, naming entry and value, unless all is finite, sizes fit and no depth is negative.
void require_valid(const ShallowWater& water);

/// The volume of the water, for a tank one metre wide: Σ r Δx [m²].
Real volume(const ShallowWater& water);

/// The momentum of the water between the walls, ρ Σ r̄ u Δx, r̄ the mean depth at a face [N s].
Real momentum(const ShallowWater& water);

/// Kinetic and potential energy, the latter above level water of no depth over the ground zero [J].
Real energy(const ShallowWater& water);

/// The longest time in which no wave passes a whole cell, Δx / max(|u| + √(g r)) [s]; infinite where all is dry.
Real stable_step(const ShallowWater& water);

/// (29.11): slopes change velocities. A face beyond which the bed is dry and higher than the water is a wall.
/// \param h  [s]
void push_water(ShallowWater& water, Real h);

/// (29.12), (29.13): velocities carry water and its momentum. No cell gives more than it has, whatever h is.
void carry_water(ShallowWater& water, Real h);

/// η = bed + r, where no body floats.
void level_water(ShallowWater& water);

/// One whole step of water without bodies (`part` becomes 1). Throws std::invalid_argument, before anything changes, for a step
/// that is not positive or beyond stable_step(), and for water that is not valid: the first step looks at all of it, those
/// after it at sizes, depths and speeds.
void step(ShallowWater& water, Real h);

/// Depth and velocity of an exact solution.
struct DamBreak {
    Real depth = 0, u = 0;  ///< [m], [m/s]
};

/// A dam at x = 0 breaks at t = 0; at rest the water is `left` deep behind it and `right` < `left` before it. On a dry bed
/// (right = 0) it is Ritter's solution of 1892, (29.22), else Stoker's of 1957, with a bore.
/// Throws std::invalid_argument unless 0 ≤ right < left, g > 0 and t > 0, and x is a number.
DamBreak dam_break(Real left, Real right, Real g, Real x, Real t);

}  // namespace rigid
