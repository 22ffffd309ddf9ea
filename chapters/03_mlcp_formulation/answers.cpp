// The functions of answers.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/answers.hpp"

namespace rigid {

//! [accept]
bool Answers::accept(const VecX& candidate)
{
    z_ = candidate.cwiseMax(dense_.lo).cwiseMin(dense_.hi);
    lambda_ = unscaled(z_);
    const Verification verified = verify(mlcp_, lambda_, {tolerance_, 0});
    if (!verified.solved) return false;
    // it may be one of several between which rounding can't choose
    if (!verified.in_each_row) leave_count_open();
    w_ = dense_.A * z_ + dense_.q;
    if (count_++ == 0) {
        first_ = z_;
        first_w_ = w_;
        return true;
    }
    // Two answers to ten digits: are they the same to seven? All of q and the
    // first λ may be zero.
    const Real size = std::max({size_of(dense_.q), size_of(first_), size_of(z_)});
    lambda_differs_ = lambda_differs_ || differ(z_, first_, size);
    w_differs_ = w_differs_ || differ(w_, first_w_, size);
    return true;
}
//! [accept]

Uniqueness Answers::uniqueness() const
{
    if (doubtful_ && !w_differs_) return Uniqueness::not_examined;
    if (count_ == 0) return Uniqueness::none;
    if (open_ && !w_differs_) return Uniqueness::not_examined;
    if (w_differs_) return Uniqueness::any;
    return lambda_differs_ ? Uniqueness::w_unique : Uniqueness::unique;
}

VecX Answers::unscaled(const VecX& z) const
{
    VecX lambda =
        z.cwiseProduct(dense_.scale).cwiseMax(mlcp_.lo).cwiseMin(mlcp_.hi);
    for (Index i = 0; i < z.size(); ++i) {
        if (z[i] <= dense_.lo[i]) lambda[i] = mlcp_.lo[i];
        else if (z[i] >= dense_.hi[i]) lambda[i] = mlcp_.hi[i];
    }
    return lambda;
}

bool Answers::differ(const VecX& a, const VecX& b, Real size)
{
    constexpr Real rounding = 1e3 * std::numeric_limits<Real>::epsilon();
    for (Index i = 0; i < a.size(); ++i) {
        const Real difference = std::abs(a[i] - b[i]),
                   own = std::max(std::abs(a[i]), std::abs(b[i]));
        if (difference > 1e-7 * (is_alone(i) ? own : size)) return true;
        if (!(difference <= 1e-7 * own + rounding * size)) doubt();
    }
    return false;
}

}  // namespace rigid
