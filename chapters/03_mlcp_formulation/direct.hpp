/// \file direct.hpp
/// The exact way for rows that have no either/or: all bilateral, one linear system.
///
///     A λ = −q
///
/// (3.25). A is factored by a sparse Cholesky (LDLᵀ) decomposition with a fill-reducing order: a chain of N
/// links costs O(N). Redundant rows make A singular: then λ is not determined, and `singular` is said, with
/// the row that adds nothing to the others. \cite davis2006
#pragma once

#include "chapters/02_velocity_constraints/solve_rows.hpp"
#include "chapters/03_mlcp_formulation/verification.hpp"
#include "common/text.hpp"

#include <Eigen/SparseCholesky>
#include <vector>

namespace rigid {

inline bool is_bilateral(const Mlcp& mlcp, Index i)
{
    return mlcp.lo[i] == -infinity && mlcp.hi[i] == infinity;
}

/// The factored block of the bilateral rows, scaled to a unit diagonal.
class BilateralBlock {
public:
    /// \param A     symmetric matrix of the whole problem
    /// \param rows  which rows belong to the block, ascending
    /// \throws std::invalid_argument  if the block is not symmetric
    void factor(const SparseMatrix& A, const std::vector<Index>& rows)
    {
        const auto n = static_cast<Index>(rows.size());
        std::vector<Index> place(static_cast<std::size_t>(A.rows()), -1);
        for (Index k = 0; k < n; ++k)
            place[static_cast<std::size_t>(rows[static_cast<std::size_t>(k)])] = k;
        scale_ = VecX::Ones(n);
        for (Index k = 0; k < n; ++k) {
            const Index i = rows[static_cast<std::size_t>(k)];
            const Real diagonal = A.coeff(i, i);
            if (diagonal > 0) scale_[k] = 1 / std::sqrt(diagonal);
        }
        entries_.clear();
        for (Index k = 0; k < n; ++k)
            for (SparseMatrix::InnerIterator entry(
                     A, rows[static_cast<std::size_t>(k)]);
                 entry; ++entry) {
                const Index l = place[static_cast<std::size_t>(entry.col())];
                if (l < 0) continue;
                require_symmetric(A, entry.row(), entry.col(), entry.value());
                entries_.emplace_back(static_cast<int>(k), static_cast<int>(l),
                                      entry.value() * scale_[k] * scale_[l]);
            }
        matrix_.resize(n, n);
        matrix_.setFromTriplets(entries_.begin(), entries_.end());
        singular_row_ = -1;
        least_pivot_ = 1;
        definite_ = true;
        if (n == 0) return;
        ldlt_.compute(matrix_);
        // With a unit diagonal a pivot is what is left of the row when the others are taken out of it. After
        // the first pivot of zero Eigen stops: what comes after it is not factored.
        const VecX pivots = ldlt_.vectorD();
        least_pivot_ = pivots.cwiseAbs().minCoeff();
        definite_ = pivots.minCoeff() > 0;
        for (Index k = 0; k < n && singular_row_ < 0; ++k)
            if (!(std::abs(pivots[k]) > rank_tolerance))
                singular_row_ = rows[static_cast<std::size_t>(
                    ldlt_.permutationPinv().indices()[k])];
    }

    /// True if the block is known to be regular, and not by luck: small pivots of a matrix that is not definite
    /// make the later ones grow, and with them the rounding.
    bool surely_regular() const
    {
        return singular_row_ < 0 && (definite_ || least_pivot_ > 1e-6);
    }
    /// The least pivot: the share of the digits of 1 that are left after it was divided by.
    Real least_pivot() const { return least_pivot_; }

    /// A row that adds nothing to the others, or -1 if there is none.
    Index singular_row() const { return singular_row_; }

    /// \f$A_{BB}^{-1} r\f$, with one step of iterative refinement.
    VecX solve(const VecX& right) const
    {
        if (right.size() == 0) return right;
        const VecX r = right.cwiseProduct(scale_);
        VecX y = ldlt_.solve(r);
        y += ldlt_.solve(r - matrix_ * y);
        return y.cwiseProduct(scale_);
    }

private:
    static void require_symmetric(const SparseMatrix& A, Index i, Index j,
                                  Real value)
    {
        const Real mirrored = A.coeff(j, i);
        if (std::abs(mirrored - value) >
            1e-9 * (std::abs(value) + std::abs(mirrored)))
            throw std::invalid_argument(
                "A is not symmetric in its bilateral rows: A[" + std::to_string(i) +
                "," + std::to_string(j) + "] is " + shortest(value) + " and A[" +
                std::to_string(j) + "," + std::to_string(i) + "] is " +
                shortest(mirrored) + "; a Cholesky decomposition needs them equal");
    }

    VecX scale_;
    std::vector<Eigen::Triplet<Real>> entries_;
    Eigen::SparseMatrix<Real> matrix_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<Real>> ldlt_;
    Index singular_row_ = -1;
    Real least_pivot_ = 1;
    bool definite_ = true;
};

/// Says `solved` if solution.lambda is an answer by (3.16c) and (3.16d), else `otherwise`.
inline void conclude(const Mlcp& mlcp, Solution& solution, Real tolerance,
                     Status otherwise)
{
    const Verification verified = verify(mlcp, solution.lambda, {tolerance, 0});
    solution.residual = verified.residual;
    solution.status = verified.solved ? Status::solved : otherwise;
}

//! [direct]
/// (3.25): all rows bilateral, w = 0. `solved`, or `singular` (λ is then zero) if a
/// row adds nothing to the others, whether or not they contradict each other: λ is
/// not determined.
/// \param tolerance  of the natural residual, relative to the numbers in the
///                   problem
/// \throws std::invalid_argument  for an invalid problem, a row with a bound, or an
///     A that is not symmetric
inline Solution direct(const Mlcp& mlcp, Real tolerance = 1e-10)
{
    require_valid(mlcp);
    if (!(tolerance >= 0))
        throw std::invalid_argument("the tolerance is " + shortest(tolerance) +
                                    "; it must be zero or positive");
    std::vector<Index> rows;
    for (Index i = 0; i < mlcp.size(); ++i) {
        if (!is_bilateral(mlcp, i))
            throw std::invalid_argument(
                "row " + std::to_string(i) + " has the bounds " +
                shortest(mlcp.lo[i]) + " and " + shortest(mlcp.hi[i]) +
                "; the direct solve needs all rows without bounds (-inf and inf)");
        rows.push_back(i);
    }
    BilateralBlock block;
    block.factor(mlcp.A, rows);
    Solution solution;
    solution.iterations = 1;
    if (block.singular_row() >= 0) {
        solution.lambda = VecX::Zero(mlcp.size());
        solution.residual = natural_residual(mlcp, solution.lambda);
        solution.status = Status::singular;
        return solution;
    }
    solution.lambda = block.solve(-mlcp.q);
    conclude(mlcp, solution, tolerance, Status::singular);
    if (block.surely_regular()) solution.uniqueness = Uniqueness::unique;
    return solution;
}
//! [direct]

}  // namespace rigid
