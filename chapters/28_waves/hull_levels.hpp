/// \file hull_levels.hpp
/// Levels of the water under hulls: a hull is a lid, and what presses on it is a multiplier like any other of this book.
///
///     r_i = η_i − z_i − b_i,      b_i ≥ 0                 the water's thickness is what the hull b_i leaves of it
///     r_i' = r_i − (h/Δx) Σ q_f',   u_f' = u_f − h g (η_b' − η_a') / Δx
///     M V' = M V* + h ρ g Σ J b_i' a                      Archimedes, slice by slice
///
/// Where a hull covers its cell, b rises with η, and r says nothing of η: the level is the pressure that makes the water go out of
/// the hull's way. Levels and the hulls' velocities are found together, so that a hull that is light beside the water which it
/// has to move stays stable. The matrix is symmetric positive definite; conjugate gradients solve it.
/// \cite godlewski2018
#pragma once

#include "chapters/20_turning_in_space/rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rigid {

/// The water around hulls as their levels see it. Cells under hulls are numbered from 0.
class HullLevels {
public:
    /// A cell under hulls.
    struct Cell {
        Real level = 0;  ///< η, in and out [m]
        Real error = 0;  ///< r − (η − z − b) [m]
        /// in this step, by what flows already, and by hulls that come in from the side [m]
        Real inflow = 0;
        Real width = 0;  ///< the part of the cell that waterlines cover, 0 … 1
    };
    /// Between two cells under hulls, or one of them and open water.
    struct Face {
        int a = -1, b = -1;  ///< −1: open water, whose level is known
        Real passing = 0;    ///< h² g (own thickness) / Δx² of the water
        Real rise = 0;       ///< η_b − η_a now [m]
    };
    /// What of a body is in a cell.
    struct Slice {
        int cell = 0, body = 0;
        Real volume = 0;  ///< under water [m²] or [m³], in and out
        Real width = 0;   ///< of its waterline, over that of the cell
        /// how fast it rises for a heave of 1 m/s and for turns of 1 rad/s
        std::array<Real, 3> rising = {0, 0, 0};
    };
    /// What of a body's motion changes levels: heave, and a turn or two.
    struct Body {
        Mat3 mass = Mat3::Identity();
        Vec3 velocity = {0, 0, 0};  ///< without the water, in; with it, out
        bool moves = true;
    };

    std::vector<Cell> cells;
    std::vector<Face> faces;
    std::vector<Slice> slices;
    std::vector<Body> bodies;
    int rounds = 0;     ///< of conjugate gradients in the last solve()
    int releases = 0;   ///< how often some hull was let go in the last solve()
    Real residual = 0;  ///< the largest thickness that is still missing [m]

    void clear() { cells.clear(), faces.clear(), slices.clear(), bodies.clear(); }

    /// Levels, volumes and velocities at the end of a step.
    /// Hulls cannot hold on to water: where one would have to pull, it is let go, and the rest is solved again.
    /// \param weight  ρ g
    /// \param area    of a cell [m] or [m²]
    /// Returns whether the tolerance of 1e-13 of the largest right-hand side was met; else levels are the best that were found.
    bool solve(Real h, Real weight, Real area);

    /// The part of an error that a step repays, as in chapter 7: a hull that hits the water has gone too deep in a step, and
    /// were all of it repaid in the next one, it would be thrown back.
    static constexpr Real repaid = 0.2;
    /// An error of which so much is repaid, and no more than with a tenth of the speed of waves in water of this depth.
    static Real repayable(Real error, Real depth, Real g, Real h)
    {
        const Real most = 0.1 / repaid * h * std::sqrt(g * std::max(depth, 0.0));
        return std::clamp(error, -most, most);
    }

private:
    bool solve_once(Real h, Real weight, Real area);
    void apply(const std::vector<Real>& x, std::vector<Real>& out);

    Real h_ = 0, force_ = 0;  ///< h ρ g a
    std::vector<Vec3> free_;  ///< velocities without the water
    std::vector<Real> x_, r_, p_, Ap_, diagonal_,
        after_;  ///< volumes of slices at the end of the step
    std::vector<Mat3> inverse_;
    std::vector<Vec3> pushed_;
};

}  // namespace rigid
