/// \file units.hpp
/// The units of the rows: what to divide rows and columns by, so that z and w fit in one tableau.
///
///     A'_ij = A_ij / (η_i η_j),   q'_i = q_i / η_i,   z_i = z'_i / η_i                   (5.20a)
///
/// The ratio test compares lines of the tableau. Their numbers are N s where z is basic and m/s where w is; in a row on friction's
/// bound it is the other way round.
#pragma once

#include "common/elementary.hpp"
#include "common/math.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {

//! [units]
/// (5.20a) with one η for all rows that have a diagonal: its square is the largest
/// A_ii, but for a factor below 4 that makes η a power of two, so that nothing is
/// rounded and no pivot changes. A row without a diagonal gets the η_i that makes
/// its largest entry beside one of those as large as the largest A_ii; without even
/// that, the root of its largest entry. With another unit of mass or length all
/// entries change by the same factor.
inline VecX row_units(const MatX& A)
{
    const Index n = A.rows();
    const Real most = n > 0 ? std::max(A.diagonal().maxCoeff(), Real{0}) : 0;
    const Real eta =
        most > 0 ? std::ldexp(1, static_cast<int>(std::floor(log2(most) / 2))) : 1;
    VecX unit = VecX::Constant(n, eta);
    for (Index i = 0; i < n; ++i) {
        if (A(i, i) > 0) continue;
        Real beside = 0, any = 0;
        for (Index j = 0; j < n; ++j) {
            const Real entry = std::max(std::abs(A(i, j)), std::abs(A(j, i)));
            if (A(j, j) > 0) beside = std::max(beside, entry);
            any = std::max(any, entry);
        }
        if (beside > 0) unit[i] = beside / most * eta;
        else if (any > 0) unit[i] = std::sqrt(any);
    }
    return unit;
}
//! [units]

}  // namespace rigid
