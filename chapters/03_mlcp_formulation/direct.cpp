// The functions of direct.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/direct.hpp"

namespace rigid {

void BilateralBlock::factor(const SparseMatrix& A, const std::vector<Index>& rows)
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
        for (SparseMatrix::InnerIterator entry(A,
                                               rows[static_cast<std::size_t>(k)]);
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

VecX BilateralBlock::solve(const VecX& right) const
{
    if (right.size() == 0) return right;
    const VecX r = right.cwiseProduct(scale_);
    VecX y = ldlt_.solve(r);
    y += ldlt_.solve(r - matrix_ * y);
    return y.cwiseProduct(scale_);
}

void BilateralBlock::require_symmetric(const SparseMatrix& A, Index i, Index j,
                                       Real value)
{
    const Real mirrored = A.coeff(j, i);
    if (std::abs(mirrored - value) > 1e-9 * (std::abs(value) + std::abs(mirrored)))
        throw std::invalid_argument(
            "A is not symmetric in its bilateral rows: A[" + std::to_string(i) +
            "," + std::to_string(j) + "] is " + shortest(value) + " and A[" +
            std::to_string(j) + "," + std::to_string(i) + "] is " +
            shortest(mirrored) + "; a Cholesky decomposition needs them equal");
}

//! [direct]
Solution direct(const Mlcp& mlcp, Real tolerance)
{
    require_valid(mlcp);
    if (!(tolerance >= 0))
        throw std::invalid_argument("the tolerance is " + shortest(tolerance) +
                                    "; it must be zero or positive");
    require_share(tolerance);
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
