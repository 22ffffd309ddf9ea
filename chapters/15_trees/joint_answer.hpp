/// \file joint_answer.hpp
/// The impulses of joints that are met at once, from velocities and the impulses of all other rows.
#pragma once

#include "chapters/15_trees/joint_factor.hpp"
#include "chapters/15_trees/joint_residual.hpp"

namespace rigid {

/// times its own mass: the rounding of (15.6), ε (S/M)², is 2 · 10⁻⁸ then
inline constexpr Real much_carried = 1e4;

struct JointAnswer {
    Real unlike = 0;  ///< what λ makes of u, where it is something else [m/s]

    /// What is missing to J u + γ λ + b = 0 in each row of the joints.
    void solve(JointFactor& factor, const std::vector<Row<3>>& rows, const VecX& b,
               VecX& u, VecX& lambda)
    {
        missing_ = b;
        for (std::size_t i = 0; i < rows.size(); ++i)
            missing_[static_cast<Index>(i)] +=
                rows[i].softness * lambda[static_cast<Index>(i)];
        change_.setZero(lambda.size());
        factor.solve(rows, missing_, u, change_);
        lambda += change_;
    }

    //! [refine]
    /// (15.23): u from λ, and what is missing then once more. Where that does not
    /// help, u stays what the tree said, and is not called solved.
    /// \param begin  sets u to u*
    template <class Begin>
    void refine(JointFactor& factor, const std::vector<Row<3>>& rows, const VecX& b,
                Real enough, const Begin& begin, VecX& u, VecX& lambda)
    {
        said_ = u;
        for (Real before = infinity;;) {
            begin();
            apply_all(rows, lambda, u);
            const Real left = joint_residual(rows, b, lambda, u);
            if (left <= enough) return;
            if (!(left < before / 2)) break;
            before = left;
            solve(factor, rows, b, u, lambda);
        }
        unlike = (u - said_).norm();
        u.swap(said_);
    }
    //! [refine]

private:
    VecX missing_, change_;
    VecX said_;  ///< velocities before they were refined
};

}  // namespace rigid
