/// \file body_factor.hpp
/// The linear system of a guess, on the bodies and not on the rows: six unknowns to a body, however many rows hold it.
///
///     (J W + E) δλ = −e   ⇔   (1 + W E⁻¹ J) δv = −W E⁻¹ e,   δλ = −E⁻¹ (e + J δv)                    (18.52), (18.53)
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

    /// Who shares a row with whom, and the order of elimination.
    /// \param pairs  of bodies that some row holds
    void analyse(int bodies, std::span<const std::pair<int, int>> pairs)
    {
        n_ = bodies;
        place_.assign(static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_),
                      -1);
        neighbours_.resize(
            std::max(neighbours_.size(), static_cast<std::size_t>(n_)));
        for (int i = 0; i < n_; ++i) near(i).clear();
        blocks_ = 0;
        for (int i = 0; i < n_; ++i) place(i, i) = blocks_++;
        for (const auto& [a, b] : pairs) join(a, b);
        order_.clear();
        done_.assign(static_cast<std::size_t>(n_), 0);
        for (int k = 0; k < n_; ++k) {
            int next = -1;
            for (int i = 0; i < n_; ++i)
                if (!done_[static_cast<std::size_t>(i)] &&
                    (next < 0 || near(i).size() < near(next).size()))
                    next = i;
            done_[static_cast<std::size_t>(next)] = 1;
            order_.push_back(next);
            // near(next) keeps those that are eliminated later
            for (const int i : near(next)) std::erase(near(i), next);
            for (std::size_t p = 0; p < near(next).size(); ++p)
                for (std::size_t q = p + 1; q < near(next).size(); ++q)
                    join(near(next)[p], near(next)[q]);
        }
        block_.resize(std::max(block_.size(), static_cast<std::size_t>(blocks_)));
    }

    //! [factor]
    /// The matrix of (18.53) and its block factor, without exchanging bodies.
    void factor(std::span<const ConeEquation> equations)
    {
        for (int i = 0; i < blocks_; ++i)
            block_[static_cast<std::size_t>(i)].setZero();
        for (int i = 0; i < n_; ++i) at(i, i).setIdentity();
        for (const ConeEquation& r : equations) {
            const Real stiff = 1 / r.give;
            if (r.a >= 0) at(r.a, r.a).noalias() += (stiff * r.Wa) * r.Ja;
            if (r.b >= 0) at(r.b, r.b).noalias() += (stiff * r.Wb) * r.Jb;
            if (r.a < 0 || r.b < 0) continue;
            at(r.a, r.b).noalias() += (stiff * r.Wa) * r.Jb;
            at(r.b, r.a).noalias() += (stiff * r.Wb) * r.Ja;
        }
        for (const int k : order_) {
            Block& pivot = at(k, k);
            pivot = pivot.partialPivLu().inverse().eval();
            for (const int i : near(k)) {
                at(i, k) = (at(i, k) * pivot).eval();
                for (const int j : near(k))
                    at(i, j).noalias() -= at(i, k) * at(k, j);
            }
        }
    }
    //! [factor]

    /// Solves it in place, six numbers to a body.
    void solve(VecX& x)
    {
        for (const int k : order_)
            for (const int i : near(k))
                x.segment<6>(6 * i).noalias() -= at(i, k) * x.segment<6>(6 * k);
        for (auto k = order_.rbegin(); k != order_.rend(); ++k) {
            Vec<6> sum = x.segment<6>(6 * *k);
            for (const int j : near(*k))
                sum.noalias() -= at(*k, j) * x.segment<6>(6 * j);
            x.segment<6>(6 * *k).noalias() = at(*k, *k) * sum;
        }
    }

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
