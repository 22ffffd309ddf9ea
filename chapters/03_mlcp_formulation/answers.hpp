/// \file answers.hpp
/// How many answers does a problem have?  Decided on evidence: every answer that was found is held to the
/// natural residual, and compared with the first.
#pragma once

#include "chapters/03_mlcp_formulation/family.hpp"

#include <algorithm>

namespace rigid {

/// Answers to one problem, as they are found.
class Answers {
public:
    /// \param tolerance  of the natural residual, relative to the numbers in the problem
    Answers(const Mlcp& mlcp, const DenseMlcp& dense, Real tolerance)
        : mlcp_(mlcp), dense_(dense), tolerance_(tolerance),
          first_(VecX::Zero(mlcp.size()).cwiseMax(dense.lo).cwiseMin(dense.hi)), first_w_(mlcp.size())
    {
    }

    //! [accept]
    /// Holds a scaled λ, once pressed into its bounds, to the natural residual: that of what would be handed
    /// out, in m/s. Returns whether it is an answer.
    bool accept(const VecX& candidate)
    {
        z_ = candidate.cwiseMax(dense_.lo).cwiseMin(dense_.hi);
        lambda_ = z_.cwiseProduct(dense_.scale);
        if (!(natural_residual(mlcp_, lambda_) <= tolerance_ * size_of_numbers(mlcp_, lambda_))) return false;
        w_ = dense_.A * z_ + dense_.q;
        if (count_++ == 0) {
            first_ = z_;
            first_w_ = w_;
            return true;
        }
        // Two answers to ten digits: are they the same to seven?
        const Real size = std::max(dense_.q.cwiseAbs().maxCoeff(), first_.cwiseAbs().maxCoeff());
        lambda_differs_ = lambda_differs_ || (z_ - first_).cwiseAbs().maxCoeff() > 1e-7 * size;
        w_differs_ = w_differs_ || (w_ - first_w_).cwiseAbs().maxCoeff() > 1e-7 * size;
        return true;
    }
    //! [accept]

    long count() const { return count_; }
    bool lambda_differs() const { return lambda_differs_; }
    bool w_differs() const { return w_differs_; }
    const VecX& last() const { return z_; }  ///< the last that was accepted, scaled

    /// The first answer; before there is one, the point of the bounds nearest to zero.
    VecX lambda() const { return first_.cwiseProduct(dense_.scale); }

    Uniqueness uniqueness() const
    {
        if (count_ == 0) return Uniqueness::none;
        if (w_differs_) return Uniqueness::any;
        return lambda_differs_ ? Uniqueness::w_unique : Uniqueness::unique;
    }

private:
    const Mlcp& mlcp_;
    const DenseMlcp& dense_;
    Real tolerance_;
    VecX first_, first_w_, z_, w_, lambda_;
    long count_ = 0;
    bool lambda_differs_ = false, w_differs_ = false;
};

}  // namespace rigid
