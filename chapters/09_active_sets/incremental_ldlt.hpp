/// \file incremental_ldlt.hpp
/// L D Lᵀ of a set of rows to which one row is appended, or from which one is removed, without factoring again.
///
///     append: L D l = a,  d = a_kk − lᵀ D l                                     (9.18), one triangular solve
///     remove: L₃ D₃ L₃ᵀ + d l lᵀ for the rows behind the one that goes          (9.19), a rank-one change
///
/// Each costs about as many operations as L has entries. \cite golub2013
#pragma once

#include "common/math.hpp"

#include <algorithm>
#include <vector>

namespace rigid {

class IncrementalLdlt {
public:
    /// whose factor it is, in the order in which they came
    std::vector<Index> rows;

    explicit IncrementalLdlt(Index most) : L_(most, most), d_(most) {}

    Index size() const { return static_cast<Index>(rows.size()); }

    //! [append]
    /// (9.18): takes in a row, if more than `nothing` is left of its diagonal.
    /// \param row       its number
    /// \param couplings A between it and `rows`, in their order
    /// \param diagonal  A_kk
    /// \param nothing   a pivot that small means that the row depends on the others
    bool append(Index row, const VecX& couplings, Real diagonal, Real nothing)
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
    /// (9.19): lets the row at a place go. What it had explained of the rows behind
    /// it goes back to them.
    void remove(Index place)
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

    /// A_FF x = b in place, in the order of `rows`.
    void solve(VecX& x) const
    {
        const Index f = size();
        for (Index i = 0; i < f; ++i) x[i] -= L_.row(i).head(i).dot(x.head(i));
        for (Index i = 0; i < f; ++i) x[i] /= d_[i];
        for (Index i = f; i-- > 0;)
            x.head(i) -= x[i] * L_.row(i).head(i).transpose();
    }

private:
    Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> L_;
    VecX d_, z_;
};

}  // namespace rigid
