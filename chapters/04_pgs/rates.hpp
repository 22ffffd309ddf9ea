/// \file rates.hpp
/// The theory lines: by what factor the error shrinks with each sweep, and the problem they are about.
///
/// For N rows in a line (a column of discs, a hanging chain) whose last body has the mass R of the
/// others' unit: Gauss-Seidel cos²θ with tan θ tan (N−1)θ = 1/R, (4.14). Jacobi and SOR follow from it
/// by (4.12) and (4.19) \cite young1954.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "common/elementary.hpp"

#include <cmath>

namespace rigid {

/// (4.8): N rows in a line, a column of touching discs at rest on a floor. All have 1 kg but one.
/// \param end_mass  mass of the uppermost, or of the lowest, which rests on the floor [kg]
/// \param impulse   what gravity adds to each kilogram in the step, g h [N s/kg]
Mlcp line_problem(Index count, Real end_mass, Real impulse,
                  bool heavy_at_the_floor = false);

/// (4.9): its answer. Row k carries all that is above it.
VecX line_answer(Index count, Real end_mass, Real impulse,
                 bool heavy_at_the_floor = false);

/// (4.10a): the matrix G that one sweep multiplies the error of λ by, rows visited from first to last, none clamped.
inline MatX gauss_seidel_matrix(const MatX& A)
{
    const MatX lower = A.triangularView<Eigen::Lower>();
    return MatX::Identity(A.rows(), A.cols()) -
           lower.triangularView<Eigen::Lower>().solve(A);
}

/// The smallest angle θ of (4.14): tan θ tan (N−1)θ = 1/R, by bisection.
/// \param count  N ≥ 2 rows
/// \param ratio  R > 0: mass of the end / mass of one of the others
Real line_angle(Index count, Real ratio);

/// The rate of Gauss-Seidel for N rows in a line with end mass R: cos²θ; 0 for a single row.
inline Real line_rate(Index count, Real ratio)
{
    if (count < 2) return 0;
    const Real c = cos(line_angle(count, ratio));
    return c * c;
}

/// (4.15): the share of the slowest mode in the error of a cold start, for a column of N equal bodies; the
/// largest error after k sweeps is this times ρ^k times the largest λ.
inline Real slowest_weight(Index count)
{
    const auto N = static_cast<Real>(count);
    const Real s = sin(pi / (2 * N));
    return 2 / (N * N * s * s);
}

/// (4.17): Jacobi lowers the merit of a symmetric problem for every ω below this.
Real safe_jacobi_omega(const Mlcp& mlcp);

//! [young]
/// (4.20): the relaxation with the smallest rate, from the rate ρ of Gauss-Seidel.
inline Real best_omega(Real rate) { return 2 / (1 + std::sqrt(1 - rate)); }

/// (4.19): the rate of SOR with relaxation ω, from the rate ρ of Gauss-Seidel.
inline Real sor_rate(Real omega, Real rate)
{
    const Real inside = omega * omega * rate - 4 * (omega - 1);
    if (inside <= 0) return omega - 1;  // a complex pair: all modes shrink alike
    const Real root = (omega * std::sqrt(rate) + std::sqrt(inside)) / 2;
    return root * root;
}
//! [young]

}  // namespace rigid
