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
inline bool llt_in_place(MatX& L, Index f)
{
    if (f > small_llt) {
        Eigen::Ref<MatX> block = L.topLeftCorner(f, f);
        const Eigen::LLT<Eigen::Ref<MatX>> llt(block);
        return llt.info() == Eigen::Success;
    }
    for (Index c = 0; c < f; ++c) {
        for (Index j = 0; j < c; ++j) {
            const Real l = L(c, j);
            if (l == 0) continue;
            for (Index r = c; r < f; ++r) L(r, c) -= l * L(r, j);
        }
        if (!(L(c, c) > 0)) return false;
        L(c, c) = std::sqrt(L(c, c));
        const Real inverse = 1 / L(c, c);
        for (Index r = c + 1; r < f; ++r) L(r, c) *= inverse;
    }
    return true;
}

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
