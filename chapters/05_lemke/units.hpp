/// \file units.hpp
/// The units of the rows: what to divide rows and columns by, so that z and w fit in one tableau.
///
///     A'_ij = A_ij / (η_i η_j),   q'_i = q_i / η_i,   z_i = z'_i / η_i                   (5.21)
///
/// The ratio test compares lines of the tableau. Their numbers are N s where z is basic and m/s where w is; in a row on friction's
/// bound it is the other way round.
#pragma once

#include "common/elementary.hpp"
#include "common/math.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {

/// (5.21) with one η for all rows that have a diagonal: its square is the largest
/// A_ii, but for a factor below 4 that makes η a power of two, so that nothing is
/// rounded and no pivot changes. A row without a diagonal gets the η_i that makes
/// its largest entry beside one of those as large as the largest A_ii; without even
/// that, the root of its largest entry. With another unit of mass or length all
/// entries change by the same factor.
VecX row_units(const MatX& A);

}  // namespace rigid
