/// \file case_conditions.hpp
/// What is checked in one set of cases when its linear system has been solved: does the answer fit, and is it the only one
/// of its family?
#pragma once

#include "chapters/02_velocity_constraints/solve_rows.hpp"
#include "chapters/03_mlcp_formulation/answers.hpp"

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <span>

namespace rigid {

/// True if scaled numbers differ by more than ten digits: then rounding in one row hides another.
bool is_spread(const DenseMlcp& dense);

/// By how much what came out misses the set's conditions.
inline Real violation(const DenseMlcp& dense, const std::vector<BoundState>& set,
                      const VecX& z, const VecX& w)
{
    Real largest = 0;
    const auto miss = [&largest](Real by) {
        if (!(by <= largest)) largest = by;
    };
    for (Index i = 0; i < dense.q.size(); ++i) {
        miss(dense.lo[i] - z[i]);
        miss(z[i] - dense.hi[i]);
        if (!(dense.lo[i] < dense.hi[i])) continue;
        const BoundState here = set[static_cast<std::size_t>(i)];
        if (here == BoundState::at_lo) miss(-w[i]);
        if (here == BoundState::at_hi) miss(w[i]);
    }
    return largest;
}

/// A pivot of rounding may be a pivot: rows that differ in their last digits have w = 0 at a large λ. True if none below
/// 10¹¹ times the numbers gives block · λ = right: some y has yᵀ block = 0 to all digits of the products, yᵀ right not.
bool is_contradiction(const MatX& block, const VecX& right, Real numbers);

/// The least bound that is neither zero nor infinite, and 1 where there is none.
Real least_bound(const DenseMlcp& dense);

/// A set with a singular block fits: are there other answers in its family?  Along
/// each null direction look for a member a little to either side.
/// \param null     null directions of the block, one a column
/// \param free     row numbers of the block
/// \param numbers  how large the numbers of the set are [m/s]
void look_around(const DenseMlcp& dense, const std::vector<BoundState>& set,
                 const MatX& null, std::span<const Index> free, Real numbers,
                 Answers& answers);

}  // namespace rigid
