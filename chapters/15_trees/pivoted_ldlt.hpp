/// \file pivoted_ldlt.hpp
/// A small dense matrix that may be singular: LDLᵀ with the largest pivot first, until none is left that counts.
///
///     P A Pᵀ = L D Lᵀ up to what is below the tolerance;   x = 0 in the rows that are left over
///
/// A is symmetric without a negative direction, and scaled, so that its tolerance means the same for all of it.
#pragma once

#include "common/math.hpp"

#include <utility>
#include <vector>

namespace rigid {

class PivotedLdlt {
public:
    Index rank = 0;

    /// \param A          n×n; only what is on and below the diagonal is read
    /// \param tolerance  a pivot of no more than this is none
    void factor(const MatX& A, Real tolerance);

    /// x ← A⁻¹ x
    void solve(VecX& x);

private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

    /// Rows and columns r < p change places, below the diagonal alone.
    void exchange(Index r, Index p);

    MatX L_;
    std::vector<Index> order_;
    VecX y_;
};

}  // namespace rigid
