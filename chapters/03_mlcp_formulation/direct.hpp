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
    void factor(const SparseMatrix& A, const std::vector<Index>& rows);

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
    VecX solve(const VecX& right) const;

private:
    static void require_symmetric(const SparseMatrix& A, Index i, Index j,
                                  Real value);

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

/// (3.25): all rows bilateral, w = 0. `solved`, or `singular` (λ is then zero) if a
/// row adds nothing to the others, whether or not they contradict each other: λ is
/// not determined.
/// \param tolerance  of the natural residual, relative to the numbers in the
///                   problem
/// \throws std::invalid_argument  for an invalid problem, a row with a bound, or an
///     A that is not symmetric
Solution direct(const Mlcp& mlcp, Real tolerance = 1e-10);

}  // namespace rigid
