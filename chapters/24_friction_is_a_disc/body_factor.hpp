/// \file body_factor.hpp
/// The linear system of a guess, on the bodies and not on the rows: six unknowns to a body, however many rows hold it.
///
///     (J W + E) δλ = −e   ⇔   (1 + W E⁻¹ J) δv = −W E⁻¹ e,   δλ = −E⁻¹ (e + J δv)                    (24.17), (24.18)
///
/// It has a block where two bodies share a row. Bodies are eliminated in the order of the fewest neighbours, each with the
/// blocks of those that are left.
#pragma once

#include "common/math.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace rigid {

//! [equation]
/// One unknown δλ of a guess: how its velocity is measured, what it moves, and how
/// much it gives way.
struct ConeEquation {
    RowVec<6> Ja, Jb;
    Vec<6> Wa, Wb;       ///< with what follows this impulse
    Real give = 0;       ///< E [1/kg]
    Real error = 0;      ///< e, to become zero [m/s]
    int a = -1, b = -1;  ///< numbers of the bodies in the island; −1: cannot move
};
//! [equation]

class BodyFactor {
public:
    using Block = Eigen::Matrix<Real, 6, 6>;

    /// Which bodies share a row, and the order of elimination.
    /// \param pairs  of bodies that some row holds
    void analyse(int bodies, std::span<const std::pair<int, int>> pairs);

    /// The matrix of (24.18) and its block factor, without exchanging bodies.
    void factor(std::span<const ConeEquation> equations);

    /// Solves it in place, six numbers to a body.
    void solve(VecX& x);

private:
    int& place(int i, int j)
    {
        return place_[static_cast<std::size_t>(i) * static_cast<std::size_t>(n_) +
                      static_cast<std::size_t>(j)];
    }
    Block& at(int i, int j)
    {
        return block_[static_cast<std::size_t>(place(i, j))];
    }
    std::vector<int>& near(int i)
    {
        return neighbours_[static_cast<std::size_t>(i)];
    }
    void join(int a, int b)
    {
        if (a == b || place(a, b) >= 0) return;
        place(a, b) = blocks_++, place(b, a) = blocks_++;
        near(a).push_back(b), near(b).push_back(a);
    }

    int n_ = 0, blocks_ = 0;
    std::vector<int> place_, order_;
    std::vector<char> done_;
    std::vector<std::vector<int>> neighbours_;
    std::vector<Block> block_;
};

}  // namespace rigid
