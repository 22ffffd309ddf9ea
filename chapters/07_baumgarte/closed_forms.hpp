/// \file closed_forms.hpp
/// What correcting an error leads to, in formulas: the theory lines of this chapter's plots.
#pragma once

#include "chapters/04_pgs/rates.hpp"
#include "common/math.hpp"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <string>

namespace rigid {

/// (7.17): one step of a bead of 1 kg on a wire of radius 1 m, expressed as \f$D = r^2 - 1\f$ [m²]. With β = 0 it is the
/// drift (7.3).
/// \param hL  h times its angular momentum r u_t, which no radial impulse changes [m²]
inline Real next_bead(Real D, Real beta, Real hL)
{
    return D - beta * D + (beta * beta * D * D / 4 + hL * hL) / (1 + D);
}

//! [settled]
/// (7.18): where a bead on a wire of radius 1 m comes to rest with β, as \f$D = r^2
/// - 1\f$ [m²].
/// \param hL  as for next_bead() [m²]
inline Real settled_bead(Real beta, Real hL)
{
    const Real square = beta - beta * beta / 4;  // D² square + D β − (hL)² = 0
    return 2 * hL * hL / (beta + std::sqrt(beta * beta + 4 * square * hL * hL));
}
//! [settled]

//! [hop]
/// (7.11): how far a body rises that leaves with the speed v, under symplectic
/// Euler [m].
inline Real rise(Real v, Real g, Real h)
{
    const Real n = std::floor(v / (g * h)) + 1;  // steps in which it still moves up
    return n * h * v - g * h * h * n * (n - 1) / 2;
}
//! [hop]

/// (7.20): the error of link k of N, from the anchor, that hang with one sweep a step, first link first [m].
inline Real one_sweep_sag(Index k, Index N, Real g, Real beta, Real h)
{
    return static_cast<Real>(N - k) * g * h * h / beta;
}

inline MatX power(const MatX& G, int exponent)
{
    if (exponent < 0)
        throw std::invalid_argument("the number of sweeps is " +
                                    std::to_string(exponent) +
                                    "; it must be zero or positive");
    MatX product = MatX::Identity(G.rows(), G.cols());
    for (int k = 0; k < exponent; ++k) product = product * G;
    return product;
}

//! [sag]
/// (7.8): the error C that rows at rest carry when a step makes too few sweeps
/// [m].
/// \param A       m×m [1/kg]
/// \param lambda  the exact impulses of one step at rest [N s]
/// \param sweeps  from the first row to the last
/// \param beta    Baumgarte's
/// \param h       time step [s]
/// \param carry   part of λ that the next step starts from, (7.22); 0 = cold
inline VecX sag(const MatX& A, const VecX& lambda, int sweeps, Real beta, Real h,
                Real carry = 0)
{
    const MatX G = power(gauss_seidel_matrix(A), sweeps),
               one = MatX::Identity(A.rows(), A.cols());
    return -h / beta * (1 - carry) * A * (one - G).partialPivLu().solve(G * lambda);
}
//! [sag]

/// (7.21): the same where velocities only forget C and pseudo-velocities correct it, each with its own sweeps [m].
inline VecX split_sag(const MatX& A, const VecX& lambda, int sweeps,
                      int correction_sweeps, Real beta, Real h)
{
    const MatX one = MatX::Identity(A.rows(), A.cols());
    // h J u, the error that each step adds [m]
    const VecX sinking = sag(A, lambda, sweeps, 1, h);
    // Repaying multiplies C by I − β A (I − Gˢ) A⁻¹.
    const MatX repaid = beta * A *
                        (one - power(gauss_seidel_matrix(A), correction_sweeps)) *
                        A.partialPivLu().inverse();
    return repaid.partialPivLu().solve((one - repaid) * sinking);
}

}  // namespace rigid
