/// \file random_problems.hpp
/// Random MLCPs with a known answer, and a judge of answers: for the tests of exact solvers.
#pragma once

#include "chapters/03_mlcp_formulation/cases.hpp"
#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "common/random.hpp"

#include <initializer_list>

namespace rigid {

inline VecX vector(std::initializer_list<Real> numbers)
{
    VecX v(static_cast<Index>(numbers.size()));
    std::copy(numbers.begin(), numbers.end(), v.begin());
    return v;
}

inline MatX matrix2(Real a, Real b, Real c, Real d)
{
    MatX A(2, 2);
    A << a, b, c, d;
    return A;
}

/// The natural residual in long double: the judge does not share the arithmetic of the judged.
inline long double judged_residual(const Mlcp& mlcp, const VecX& lambda)
{
    long double largest = 0;
    for (Index i = 0; i < mlcp.size(); ++i) {
        long double w = mlcp.q[i], a = 0;
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            w += static_cast<long double>(entry.value()) * lambda[entry.col()];
            if (entry.col() == i) a = entry.value();
        }
        if (!(a > 0)) a = 1;
        const long double x = a * lambda[i];
        const long double r =
            std::abs(x - std::max(a * mlcp.lo[i], std::min(a * static_cast<long double>(mlcp.hi[i]), x - w)));
        if (!(r <= largest)) largest = r;
    }
    return largest;
}

inline MatX gaussian(Index rows, Index columns, Random& random)
{
    MatX G(rows, columns);
    for (Real& entry : G.reshaped()) entry = random.normal();
    return G;
}

/// The kinds of random problems.
enum class Kind { spd, psd, p_matrix, positive_real, bounded, bilateral };
constexpr Kind all_kinds[] = {Kind::spd,           Kind::psd,     Kind::p_matrix,
                              Kind::positive_real, Kind::bounded, Kind::bilateral};

inline MatX random_matrix(Kind kind, Index n, Random& random)
{
    const auto size = static_cast<Real>(n);
    if (kind == Kind::psd) {
        const MatX G = gaussian(n, (n + 1) / 2, random);
        return G * G.transpose() / size;
    }
    if (kind == Kind::p_matrix) {  // a dominant positive diagonal makes all principal minors positive
        MatX A = gaussian(n, n, random);
        for (Index i = 0; i < n; ++i) A(i, i) = 0.1 + A.row(i).cwiseAbs().sum();
        return A;
    }
    const MatX G = gaussian(n, n, random);
    MatX A = G * G.transpose() / size + 0.05 * MatX::Identity(n, n);
    if (kind == Kind::positive_real) {  // not symmetric, and yet zᵀAz > 0
        const MatX S = gaussian(n, n, random);
        A += S - S.transpose();
    }
    return A;
}

/// A problem with a planted answer: each row has λ at a bound and w of the right sign, or λ between
/// and w = 0.
inline Mlcp planted(Kind kind, Index n, Random& random, VecX& lambda)
{
    Mlcp mlcp = plain_lcp(random_matrix(kind, n, random), VecX::Zero(n));
    lambda = VecX::Zero(n);
    VecX w = VecX::Zero(n);
    for (Index i = 0; i < n; ++i) {
        if (kind == Kind::bilateral && random.uniform() < 0.4) {
            mlcp.lo[i] = -infinity;
            lambda[i] = random.normal();
            continue;
        }
        if (kind == Kind::bounded) {
            mlcp.lo[i] = random.uniform() < 0.2 ? -infinity : -random.uniform();
            mlcp.hi[i] = mlcp.lo[i] > -infinity && random.uniform() < 0.3 ? infinity : random.uniform();
        }
        const bool below = mlcp.lo[i] > -infinity, above = mlcp.hi[i] < infinity;
        const Real where = random.uniform();
        if (below && where < 0.4) {
            lambda[i] = mlcp.lo[i];
            w[i] = random.uniform();
        } else if (above && where > 0.6) {
            lambda[i] = mlcp.hi[i];
            w[i] = -random.uniform();
        } else {
            const Real lo = below ? mlcp.lo[i] : mlcp.hi[i] - 1, hi = above ? mlcp.hi[i] : lo + 1;
            lambda[i] = lo + (hi - lo) * random.uniform();
        }
    }
    mlcp.q = w - mlcp.A * lambda;
    return mlcp;
}

}  // namespace rigid
