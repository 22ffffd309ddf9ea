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

    /// (9.18): takes in a row, if more than `nothing` is left of its diagonal.
    /// \param row       its number
    /// \param couplings A between it and `rows`, in their order
    /// \param diagonal  A_kk
    /// \param nothing   a pivot that small means that the row depends on the others
    bool append(Index row, const VecX& couplings, Real diagonal, Real nothing);

    /// (9.19): lets the row at a place go. What it had explained of the rows behind
    /// it goes back to them.
    void remove(Index place);

    /// A_FF x = b in place, in the order of `rows`.
    void solve(VecX& x) const;

private:
    Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> L_;
    VecX d_, z_;
};

}  // namespace rigid
