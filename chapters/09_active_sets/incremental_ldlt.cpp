// The functions of incremental_ldlt.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/incremental_ldlt.hpp"

namespace rigid {

//! [append]
bool IncrementalLdlt::append(Index row, const VecX& couplings, Real diagonal,
                             Real nothing)
{
    const Index f = size();
    Real pivot = diagonal;
    for (Index i = 0; i < f; ++i)  // d_i l_i
        L_(f, i) = couplings[i] - L_.row(i).head(i).dot(L_.row(f).head(i));
    for (Index i = 0; i < f; ++i) {
        const Real y = L_(f, i);
        L_(f, i) = y / d_[i];
        pivot -= y * L_(f, i);
    }
    if (!(pivot > nothing)) return false;
    d_[f] = pivot;
    rows.push_back(row);
    return true;
}
//! [append]

//! [remove]
void IncrementalLdlt::remove(Index place)
{
    const Index f = size() - 1;
    Real weight = d_[place];
    z_.resize(f - place);
    for (Index i = place; i < f; ++i) {  // the rows behind move up by one
        z_[i - place] = L_(i + 1, place);
        for (Index j = 0; j < place; ++j) L_(i, j) = L_(i + 1, j);
        for (Index j = place; j < i; ++j) L_(i, j) = L_(i + 1, j + 1);
        d_[i] = d_[i + 1];
    }
    rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(place));
    for (Index j = place; j < f; ++j) {
        const Real z = z_[j - place], before = d_[j];
        d_[j] = before + weight * z * z;
        const Real factor = weight * z / d_[j];
        weight *= before / d_[j];
        for (Index i = j + 1; i < f; ++i) {
            z_[i - place] -= z * L_(i, j);
            L_(i, j) += factor * z_[i - place];
        }
    }
}
//! [remove]

void IncrementalLdlt::solve(VecX& x) const
{
    const Index f = size();
    for (Index i = 0; i < f; ++i) x[i] -= L_.row(i).head(i).dot(x.head(i));
    for (Index i = 0; i < f; ++i) x[i] /= d_[i];
    for (Index i = f; i-- > 0;) x.head(i) -= x[i] * L_.row(i).head(i).transpose();
}

}  // namespace rigid
