/// \file small_llt.hpp
/// L Lᵀ and its two triangular solves. Up to 32 rows by plain loops: there a library's preparations cost more
/// than the work. \cite golub2013
#pragma once

#include "common/math.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace rigid {

inline constexpr Index small_llt = 32;

/// The leading f×f block becomes its own factor, below the diagonal. False if it is not positive definite.
bool llt_in_place(MatX& L, Index f);

/// L x = z in place; f rows.
template <class Vector>
void lower_solve(const MatX& L, Index f, Vector&& z)
{
    if (f > small_llt)
        L.topLeftCorner(f, f).triangularView<Eigen::Lower>().solveInPlace(z);
    else
        for (Index c = 0; c < f; ++c) {
            z[c] /= L(c, c);
            for (Index r = c + 1; r < f; ++r) z[r] -= L(r, c) * z[c];
        }
}

/// Lᵀ x = z in place; f rows.
template <class Vector>
void upper_solve(const MatX& L, Index f, Vector&& z)
{
    if (f > small_llt)
        L.topLeftCorner(f, f)
            .triangularView<Eigen::Lower>()
            .transpose()
            .solveInPlace(z);
    else
        for (Index c = f; c-- > 0;) {
            for (Index r = c + 1; r < f; ++r) z[c] -= L(r, c) * z[r];
            z[c] /= L(c, c);
        }
}

}  // namespace rigid
