/// \file answers.hpp
/// How many answers does a problem have?  Decided on evidence: every answer that was found is held to the
/// natural residual, and compared with the first.
#pragma once

#include "chapters/03_mlcp_formulation/family.hpp"
#include "chapters/03_mlcp_formulation/verification.hpp"

#include <algorithm>

namespace rigid {

/// Answers to one problem, as they are found.
class Answers {
public:
    /// \param tolerance  of the natural residual, relative to the numbers in the problem
    Answers(const Mlcp& mlcp, const DenseMlcp& dense, Real tolerance)
        : mlcp_(mlcp), dense_(dense), tolerance_(tolerance),
          first_(VecX::Zero(mlcp.size()).cwiseMax(dense.lo).cwiseMin(dense.hi)),
          first_w_(mlcp.size())
    {
    }

    /// Holds a scaled λ, once pressed into its bounds, to the natural residual:
    /// that of what would be returned, in m/s. Returns whether it is an answer.
    bool accept(const VecX& candidate);

    long count() const { return count_; }
    bool lambda_differs() const { return lambda_differs_; }
    bool w_differs() const { return w_differs_; }
    const VecX& last() const { return z_; }  ///< the last that was accepted, scaled

    /// The first answer; before there is one, the point of the bounds nearest to zero.
    VecX lambda() const { return unscaled(first_); }

    const VecX& lambda_scaled() const { return first_; }

    /// Remember that some question could not be answered: then nothing is said about how many answers there are.
    void doubt() { doubtful_ = true; }
    bool doubtful() const { return doubtful_; }
    /// Say nothing about how many there are, unless there is none or two were seen.
    void leave_count_open() { open_ = true; }

    Uniqueness uniqueness() const;

private:
    /// λ in N s; what is at a bound is there to the last digit.
    VecX unscaled(const VecX& z) const;

    /// A row without entries shares no unit with the others.
    bool is_alone(Index i) const
    {
        return dense_.A.row(i).isZero(0) && dense_.A.col(i).isZero(0);
    }

    Real size_of(const VecX& v) const
    {
        Real size = 0;
        for (Index i = 0; i < v.size(); ++i)
            if (!is_alone(i)) size = std::max(size, std::abs(v[i]));
        return size;
    }

    /// A difference that is small beside the largest number, and large beside its own, may be rounding or not.
    bool differ(const VecX& a, const VecX& b, Real size);

    const Mlcp& mlcp_;
    const DenseMlcp& dense_;
    Real tolerance_;
    VecX first_, first_w_, z_, w_, lambda_;
    long count_ = 0;
    bool lambda_differs_ = false, w_differs_ = false, doubtful_ = false,
         open_ = false;
};

}  // namespace rigid
