/// \file tank.hpp
/// Water that is not shallow: below its surface pressure passes through the whole tank at once.
///
///     ∂η/∂t = ∂φ/∂z,   ∂φ/∂t = −g η   on the surface,      Δφ = 0 below, no flow through walls and bottom
///
/// Each step solves Laplace's equation on a grid of cells, with one factor for all steps: here a place does not feel its
/// neighbours alone. In small waves ω² = g k tanh kH; √(gH) k of shallow water is its limit for long ones.
#pragma once

#include "common/bodies.hpp"

#include <Eigen/SparseCholesky>

namespace rigid {

class Tank {
public:
    VecX level;      ///< nx, out of rest [m]
    VecX potential;  ///< nx, φ of the surface, half a step before it [m²/s]

    /// Throws std::invalid_argument for less than two cells either way, or a length, depth or gravity that is not positive.
    Tank(Index nx, Index nz, Real length, Real depth, Real g);

    /// Leapfrog: φ ← φ − h g η, then η ← η + h ∂φ/∂z.
    /// Throws std::invalid_argument for a step that is not positive or longer than stable_step(), and for a level or
    /// potential that is not finite or not nx long.
    void step(Real h);

    /// 2 / √(g 2/Δz): no wave of the grid has more than ω² = g · 2/Δz [s].
    Real stable_step() const;

    /// ∂φ/∂z at the surface [m/s], by a solve below it.
    void vertical_speed(const VecX& surface, VecX& speed);

private:
    Index nx_, nz_;
    Real dz_, g_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<Real>> factor_;
    VecX right_, below_, speed_;
};

}  // namespace rigid
