/// \file prescaled_sweeps.hpp
/// The sweeps of sweeps.hpp with less work per visit: all that does not change from sweep to sweep is done once.
///
///     λ_i ← clamp(keep_i λ_i + constant_i + Σ_j coefficient_ij λ_j, lo_i, hi_i)                    (4.24)
///
/// A visit is one short sum and a clamp, without a division, and the rows lie in memory in the order in which they
/// are visited.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

//! [layout]
/// One row in the form (4.24). Its neighbours in the order of the visits have
/// fields of their own: in a column or a chain there are no other entries, and the
/// λ that was just written stays in a register.
struct SweepRow {
    Real keep;      ///< 1 − ω A_ii / s_i, which is 1 − ω
    Real constant;  ///< −ω q_i / s_i [N s]
    /// −ω A_ij / s_i for the rows visited just before and just after
    Real before, after;
    Real lo, hi;  ///< [N s]
    /// s_i / ω [1/kg]: the velocity that a change of λ_i stands for
    Real scale;
};

/// The rows in the order of the visits. The other entries of row k: start[k] …
/// start[k+1] − 1.
struct SweepRows {
    std::vector<SweepRow> rows;
    std::vector<int> start;  ///< n + 1
    /// places in this order, not row numbers of the problem
    std::vector<int> column;
    std::vector<Real> coefficient;  ///< −ω A_ij / s_i
    std::vector<int> row_at;        ///< row number of the problem at each place
    std::vector<int> place_of;      ///< and back
    VecX lambda;                    ///< the impulses by place [N s]
    VecX next;                      ///< Jacobi's second copy
};
//! [layout]

/// True if no λ of any row changes the velocity of row k.
inline bool is_empty(const SweepRows& sweep, std::size_t k)
{
    const SweepRow& row = sweep.rows[k];
    return row.keep == 1 && row.before == 0 && row.after == 0 &&
           sweep.start[k] == sweep.start[k + 1];
}

/// Writes the rows of a valid problem as (4.24). Allocates only if the problem is larger than all before it.
/// \param omega  0 < ω < 2: 1 is plain Gauss-Seidel
/// \param order  the row numbers in the order of the visits; empty = as they are
/// \throws std::invalid_argument  for an ω out of range or an order that is not a permutation
void prepare(const Mlcp& mlcp, Real omega, std::span<const int> order,
             SweepRows& sweep);

//! [visit]
/// (4.18): the λ of row k that is right for the present λ of the others. A NaN
/// stays a NaN.
inline Real visit(const SweepRows& sweep, std::size_t k, const Real* lambda,
                  Real before, Real after)
{
    const SweepRow& row = sweep.rows[k];
    Real value = row.constant + row.keep * lambda[k];
    for (int e = sweep.start[k]; e < sweep.start[k + 1]; ++e)
        value += sweep.coefficient[static_cast<std::size_t>(e)] *
                 lambda[sweep.column[static_cast<std::size_t>(e)]];
    value += row.after * after;    // the newest number is added last:
    value += row.before * before;  // all other terms are ready by then
    value = value < row.lo ? row.lo : value;
    return value > row.hi ? row.hi : value;
}
//! [visit]

/// The same, with the neighbours looked up.
inline Real visit(const SweepRows& sweep, std::size_t k, const Real* lambda)
{
    return visit(sweep, k, lambda, k > 0 ? lambda[k - 1] : 0,
                 k + 1 < sweep.rows.size() ? lambda[k + 1] : 0);
}

/// One Gauss-Seidel sweep: each visit uses what the visits before it have changed.
/// \return  the largest change of a λ_i, as a velocity s_i |Δλ_i| / ω [m/s]; not
///     the residual, see (4.7)
Real sweep_forward(SweepRows& sweep);

/// The same from the last row to the first.
Real sweep_backward(SweepRows& sweep);

/// One Jacobi sweep: each visit uses what all λ were before the sweep.
Real sweep_jacobi(SweepRows& sweep);

}  // namespace rigid
