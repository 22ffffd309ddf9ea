/// \file standard_form.hpp
/// From the MLCP to the plain problem that Lemke's algorithm walks on, and back.
///
///     λ free                w = 0 is an equation: eliminated by the Schur complement (5.20)
///     lo ≤ λ                λ = lo + z (5.21)
///          λ ≤ hi           λ = hi - z, and the row changes its sign (5.21)
///     lo ≤ λ ≤ hi           λ = lo + z, and a row of its own keeps z ≤ hi - lo (5.22)
///     lo = λ = hi           nothing to find
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <Eigen/LU>
#include <vector>

namespace rigid {

/// 0 ≤ z ⟂ A z + q ≥ 0 with the way back to λ.
struct StandardForm {
    MatX A;
    VecX q;
    bool singular = false;  ///< the bilateral rows contradict or repeat each other

    explicit StandardForm(const Mlcp& mlcp) : fixed_(VecX::Zero(mlcp.size()))
    {
        // λ = fixed + sign z: where z = 0 stands, and which way it goes.
        std::vector<Index> split;
        for (Index i = 0; i < mlcp.size(); ++i) {
            const Real lo = mlcp.lo[i], hi = mlcp.hi[i];
            if (lo == -infinity && hi == infinity) {
                free_.push_back(i);
                continue;
            }
            fixed_[i] = lo > -infinity ? lo : hi;
            if (lo == hi) continue;
            if (lo > -infinity && hi < infinity) split.push_back(static_cast<Index>(moving_.size()));
            moving_.push_back(i);
            sign_.push_back(lo > -infinity ? 1 : -1);
        }
        const MatX full(mlcp.A);
        const VecX w_fixed = full * fixed_ + mlcp.q;
        const auto m = static_cast<Index>(moving_.size()), s = static_cast<Index>(split.size());
        A = MatX::Zero(m + s, m + s);
        q.resize(m + s);
        A.topLeftCorner(m, m) = full(moving_, moving_);
        q.head(m) = w_fixed(moving_);

        //! [schur]
        if (!free_.empty()) {  // (5.20)
            const Eigen::PartialPivLU<MatX> block(full(free_, free_));
            singular = !(block.rcond() > 1e-14);  // fewer than two digits would be left
            if (singular) return;
            from_moving_ = block.solve(full(free_, moving_));
            from_fixed_ = block.solve(VecX(w_fixed(free_)));
            A.topLeftCorner(m, m) -= full(moving_, free_) * from_moving_;
            q.head(m) -= full(moving_, free_) * from_fixed_;
        }
        //! [schur]
        for (Index i = 0; i < m; ++i) {  // (5.21): rows that hang from their upper bound
            if (sign_[static_cast<std::size_t>(i)] > 0) continue;
            A.row(i) *= -1;
            A.col(i) *= -1;
            q[i] *= -1;
        }
        for (Index k = 0; k < s; ++k) {  // (5.22), in units of the row itself
            const Index i = split[static_cast<std::size_t>(k)];
            const Index row = moving_[static_cast<std::size_t>(i)];
            const Real unit = A(i, i) > 0 ? A(i, i) : 1;
            A(i, m + k) = unit;
            A(m + k, i) = -unit;
            q[m + k] = unit * (mlcp.hi[row] - mlcp.lo[row]);
        }
    }

    /// λ from z.
    VecX impulses(const VecX& z) const
    {
        VecX lambda = fixed_;
        const auto m = static_cast<Index>(moving_.size());
        VecX moved(m);
        for (Index i = 0; i < m; ++i) {
            const auto k = static_cast<std::size_t>(i);
            moved[i] = sign_[k] * z[i];
            lambda[moving_[k]] += moved[i];
        }
        if (!free_.empty()) {
            const VecX free = -(from_fixed_ + from_moving_ * moved);
            for (std::size_t k = 0; k < free_.size(); ++k) lambda[free_[k]] = free[static_cast<Index>(k)];
        }
        return lambda;
    }

private:
    std::vector<Index> free_, moving_;  ///< rows of the MLCP: bilateral, and those with one z each
    std::vector<Real> sign_;            ///< of each moving row
    VecX fixed_;                        ///< λ where all z are zero (and free rows are left out)
    MatX from_moving_;                  ///< A_FF⁻¹ A_FM
    VecX from_fixed_;                   ///< A_FF⁻¹ of the bilateral rows' w at z = 0
};

}  // namespace rigid
