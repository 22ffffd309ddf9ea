/// \file modes.hpp
/// Modes: shapes that only grow and shrink, all places in step.
///
///     K φ = ω² φ,   K = −L, the matrix of (29.2) or of a grid, per mass
///
/// The lowest are found by inverse iteration on a few vectors at once, with one sparse factor of K and Eigen's dense
/// eigen-solver for the small problem that they span. \cite golub2013, §8.2
#pragma once

#include "common/bodies.hpp"

#include <Eigen/SparseCore>

namespace rigid {

using StiffnessMatrix = Eigen::SparseMatrix<Real>;

/// K of a rectangle a × b with a fixed rim, on nx × ny intervals [1/s²].
/// Throws std::invalid_argument for fewer than two intervals or lengths and speeds that are not positive.
StiffnessMatrix rectangle_stiffness(Index nx, Index ny, Real a, Real b, Real c);

/// K of a drum of this radius with a fixed rim, on a square grid through its centre whose interval is radius / intervals. A
/// link that meets the rim ends there: it is shorter, and stiffer in proportion (29.21). \cite gibou2002
StiffnessMatrix drum_stiffness(Index intervals, Real radius, Real c);

struct Modes {
    VecX omega;      ///< ascending [rad/s]
    MatX shapes;     ///< columns of length 1, one to a frequency
    int rounds = 0;  ///< of inverse iteration
    /// the largest ‖K φ − ω² φ‖ / ω² of those that were asked for
    Real residual = 0;
    bool solved = false;  ///< whether the residual met the tolerance
};

/// The lowest modes of a symmetric positive definite K.
/// \param count  how many, at most a third of the rows
/// Throws std::invalid_argument for a count that is not positive or too large, fewer than one round, and for a K that is
/// not positive definite.
Modes lowest_modes(const StiffnessMatrix& K, Index count, Real tolerance = 1e-10,
                   int most_rounds = 500);

}  // namespace rigid
