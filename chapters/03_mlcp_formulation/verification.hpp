/// \file verification.hpp
/// When is a λ an answer? The one rule by which every solver of this book returns `solved`.
///
///     v_i = |w_i| between the bounds, max(0, −w_i) at lo, max(0, w_i) at hi                      (3.16a)
///     S_i = |q_i| + Σ_j |A_ij λ_j|,   U_i = min(max_j N_j, d_i max_j N_j/d_j),   d_i = √|A_ii|      (3.16b)
///     v_i ≤ max(f, τ min(S_i, U_i), ε U_i)                                                       (3.16c)
///     v_i ≤ 100 max(f, τ U_i, 64 ε U_i) for every w_i within ½ (k_i + 1) ε S_i of the computed one (3.16d)
///
/// S_i are the numbers that are added up in row i, k_i how many products; N_i is S_i at the point of the bounds that
/// is nearest to zero, and no λ has a smaller S_i. v_i is never below the natural residual r_i. A row without entries
/// has w_i = q_i whatever λ is: it is left out of the maxima, and v_i ≤ f there.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {

/// Throws std::invalid_argument unless τ is below 1/100: there (3.16d) lets in all of U_i, as much as drives the problem, and
/// from 1 on λ = 0 would be an answer to any, for |w_i| ≤ S_i.
void require_share(Real tolerance);

/// Throws std::invalid_argument, naming what it is of ("the sweeps"), unless a tolerance is zero or positive, and finite: an
/// infinite one would make any λ an answer.
void require_tolerance(const char* of, Real tolerance);

/// How small a residual has to be.
struct Acceptance {
    Real tolerance = 1e-10;  ///< τ, as a share of the numbers in the row
    /// f [m/s]: so little is nothing; 0 where the speeds are unknown
    Real enough = 0;
};

/// The natural residual of a λ, and whether it makes λ an answer.
struct Verification {
    Real residual = infinity;  ///< (3.15) [m/s]
    bool solved = false;       ///< by (3.16c) and (3.16d)
    /// without the help of f and of ε max N_j: each v_i is small beside its own S_i
    bool in_each_row = false;
};

/// d_i: row i has the unit d_i √J. √|A_ii|, and in a row without a diagonal what its neighbours make of it.
Real row_unit(const Mlcp& mlcp, Index i, Real diagonal);

/// d_i where A need not be positive semi-definite: at least |A_ij| / d_j for all j.
Real coupled_unit(const Mlcp& mlcp, Index i);

/// Whether max N_j / d_j over the rows that some λ moves, with these d_j, is at least this.
bool coupled_energy_reaches(const Mlcp& mlcp, Real least);

/// v_i of (3.16a).
inline Real violation(Real lambda, Real w, Real lo, Real hi)
{
    if (!(lo < hi)) return 0;  // nothing to choose: any w will do
    return std::max(lambda < hi ? -w : 0, lambda > lo ? w : 0);
}

/// Holds λ to (3.16c) and (3.16d), in one pass over A. `solved` needs lo ≤ λ ≤ hi
/// to the last digit. Does not allocate.
Verification verify(const Mlcp& mlcp, const VecX& lambda,
                    const Acceptance& acceptance = {});

}  // namespace rigid
