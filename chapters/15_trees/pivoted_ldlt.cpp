// The functions of pivoted_ldlt.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/pivoted_ldlt.hpp"

namespace rigid {

//! [factor]
void PivotedLdlt::factor(const MatX& A, Real tolerance)
{
    const Index n = A.rows();
    L_ = A;
    order_.resize(static_cast<std::size_t>(n));
    for (Index i = 0; i < n; ++i) order_[at(i)] = i;
    for (rank = 0; rank < n; ++rank) {
        Index p = rank;
        for (Index i = rank + 1; i < n; ++i)
            if (L_(i, i) > L_(p, p)) p = i;
        if (!(L_(p, p) > tolerance)) break;
        exchange(rank, p);
        const Real pivot = L_(rank, rank);
        for (Index i = rank + 1; i < n; ++i) {
            const Real l = L_(i, rank) / pivot;
            for (Index j = rank + 1; j <= i; ++j) L_(i, j) -= l * L_(j, rank);
        }
        for (Index i = rank + 1; i < n; ++i) L_(i, rank) /= pivot;
    }
}
//! [factor]

void PivotedLdlt::solve(VecX& x)
{
    y_.resize(x.size());
    for (Index i = 0; i < rank; ++i) {
        y_[i] = x[order_[at(i)]];
        for (Index j = 0; j < i; ++j) y_[i] -= L_(i, j) * y_[j];
    }
    for (Index i = 0; i < rank; ++i) y_[i] /= L_(i, i);
    for (Index i = rank; i-- > 0;)
        for (Index j = i + 1; j < rank; ++j) y_[i] -= L_(j, i) * y_[j];
    x.setZero();
    for (Index i = 0; i < rank; ++i) x[order_[at(i)]] = y_[i];
}

void PivotedLdlt::exchange(Index r, Index p)
{
    if (r == p) return;
    std::swap(order_[at(r)], order_[at(p)]);
    std::swap(L_(r, r), L_(p, p));
    for (Index j = 0; j < r; ++j) std::swap(L_(r, j), L_(p, j));
    for (Index i = r + 1; i < p; ++i) std::swap(L_(i, r), L_(p, i));
    for (Index i = p + 1; i < L_.rows(); ++i) std::swap(L_(i, r), L_(i, p));
}

}  // namespace rigid
