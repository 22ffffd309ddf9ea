/// \file mlcp.hpp
/// The mixed linear complementarity problem, its answer, and the one measure of its error.
///
///     w = A λ + q,   lo ≤ λ ≤ hi,
///     w ≥ 0 where λ = lo,   w ≤ 0 where λ = hi,   w = 0 between
///
/// (3.12) and (3.14). \cite cottle1992
#pragma once

#include "common/math.hpp"
#include "common/text.hpp"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace rigid {

using SparseMatrix = Eigen::SparseMatrix<Real, Eigen::RowMajor>;

//! [mlcp]
struct Mlcp {
    SparseMatrix A;  ///< m×m [1/kg], row by row
    VecX q;          ///< m [m/s]
    VecX lo, hi;     ///< m [N s]; ∓infinity where there is no bound

    Index size() const { return q.size(); }
};
//! [mlcp]

enum class Status {
    solved,
    iteration_limit,
    ray_termination,
    infeasible,
    singular
};

/// The status in the words of the book.
constexpr std::string_view to_string(Status status)
{
    switch (status) {
    case Status::solved:
        return "solved";
    case Status::iteration_limit:
        return "iteration limit";
    case Status::ray_termination:
        return "ray termination";
    case Status::infeasible:
        return "infeasible";
    case Status::singular:
        return "singular";
    }
    return "unknown";
}

/// How many answers there are. Only a solver that examined all of them can report it. Two λ are one answer if they
/// differ by rounding alone in the units √A_ii λ_i of their rows, [√J].
enum class Uniqueness {
    not_examined,
    unique,    ///< one λ
    w_unique,  ///< several λ, all with the same w: the bodies move in one way only
    any,       ///< several w
    none       ///< no λ at all
};

/// The word of the problem files for it; "" if it was not examined.
constexpr std::string_view to_string(Uniqueness uniqueness)
{
    switch (uniqueness) {
    case Uniqueness::not_examined:
        return "";
    case Uniqueness::unique:
        return "unique";
    case Uniqueness::w_unique:
        return "w_unique";
    case Uniqueness::any:
        return "any";
    case Uniqueness::none:
        return "none";
    }
    return "";
}

struct Solution {
    VecX lambda;  ///< m [N s]
    /// `solved` only if the residual met the tolerance
    Status status = Status::iteration_limit;
    /// sweeps, pivots or tried sets: what the method counts
    int iterations = 0;
    Real residual = infinity;  ///< natural residual of lambda [m/s]
    Uniqueness uniqueness = Uniqueness::not_examined;
};

//! [residual]
/// (3.15), row i of the natural residual [m/s]: how far λ_i is from its own best
/// answer.
/// \param a  the diagonal entry A_ii [1/kg]; a row without one (a ≤ 0) is measured
///           with 1
/// \return   NaN if λ_i is not finite
inline Real natural_residual_row(Real a, Real lambda, Real w, Real lo, Real hi)
{
    if (!std::isfinite(lambda)) return std::numeric_limits<Real>::quiet_NaN();
    const Real scale = a > 0 ? a : 1;
    // (3.15) with scale λ inside the clamp: outside, a λ of 1e20 would swallow w.
    return std::abs(std::clamp(w, scale * (lambda - hi), scale * (lambda - lo)));
}

/// The natural residual of λ [m/s], the one definition of error in this book; 0 for
/// the solution.
inline Real natural_residual(const Mlcp& mlcp, const VecX& lambda)
{
    Real largest = 0;
    for (Index i = 0; i < mlcp.size(); ++i) {
        Real w = mlcp.q[i];
        Real diagonal = 0;
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            w += entry.value() * lambda[entry.col()];
            if (entry.col() == i) diagonal = entry.value();
        }
        const Real r =
            natural_residual_row(diagonal, lambda[i], w, mlcp.lo[i], mlcp.hi[i]);
        if (!(r <= largest)) largest = r;  // also takes over a NaN
        if (std::isnan(largest)) return largest;
    }
    return largest;
}
//! [residual]

/// Throws std::invalid_argument unless all sizes agree, all numbers of A and q are finite, and some number lies
/// between lo and hi.
void require_valid(const Mlcp& mlcp);

}  // namespace rigid
