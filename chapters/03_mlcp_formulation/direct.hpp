/// \file direct.hpp
/// Two exact ways for the rows that have no either/or: solve them directly, or eliminate them.
///
///     direct   A λ = −q                                            all rows bilateral
///     Schur    S = A_NN − A_NB A_BB⁻¹ A_BN,  r = q_N − A_NB A_BB⁻¹ q_B      B bilateral, N the others
///
/// (3.26) and (3.28). A_BB is factored by a sparse Cholesky (LDLᵀ) decomposition with a fill-reducing order:
/// a chain of N links costs O(N). Redundant rows make A_BB singular: then λ is not determined, and
/// `singular` is what both say, with the row that adds nothing to the others. \cite davis2006
#pragma once

#include "chapters/03_mlcp_formulation/enumeration.hpp"
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
        for (Index k = 0; k < n; ++k) place[static_cast<std::size_t>(rows[static_cast<std::size_t>(k)])] = k;
        scale_ = VecX::Ones(n);
        for (Index k = 0; k < n; ++k) {
            const Index i = rows[static_cast<std::size_t>(k)];
            const Real diagonal = A.coeff(i, i);
            if (diagonal > 0) scale_[k] = 1 / std::sqrt(diagonal);
        }
        entries_.clear();
        for (Index k = 0; k < n; ++k)
            for (SparseMatrix::InnerIterator entry(A, rows[static_cast<std::size_t>(k)]); entry; ++entry) {
                const Index l = place[static_cast<std::size_t>(entry.col())];
                if (l < 0) continue;
                require_symmetric(A, entry.row(), entry.col(), entry.value());
                entries_.emplace_back(static_cast<int>(k), static_cast<int>(l),
                                      entry.value() * scale_[k] * scale_[l]);
            }
        matrix_.resize(n, n);
        matrix_.setFromTriplets(entries_.begin(), entries_.end());
        singular_row_ = -1;
        if (n == 0) return;
        ldlt_.compute(matrix_);
        // With a unit diagonal a pivot is what is left of the row when the others are taken out of it. After
        // the first pivot of zero Eigen stops: what stands behind it is not looked at.
        const VecX pivots = ldlt_.vectorD();
        for (Index k = 0; k < n && singular_row_ < 0; ++k)
            if (!(std::abs(pivots[k]) > rank_tolerance))
                singular_row_ = rows[static_cast<std::size_t>(ldlt_.permutationPinv().indices()[k])];
    }

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
    static void require_symmetric(const SparseMatrix& A, Index i, Index j, Real value)
    {
        const Real mirrored = A.coeff(j, i);
        if (std::abs(mirrored - value) > 1e-9 * (std::abs(value) + std::abs(mirrored)))
            throw std::invalid_argument("A is not symmetric in its bilateral rows: A[" + std::to_string(i) +
                                        "," + std::to_string(j) + "] is " + shortest(value) + " and A[" +
                                        std::to_string(j) + "," + std::to_string(i) + "] is " +
                                        shortest(mirrored) + "; a Cholesky decomposition needs them equal");
    }

    VecX scale_;
    std::vector<Eigen::Triplet<Real>> entries_;
    Eigen::SparseMatrix<Real> matrix_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<Real>> ldlt_;
    Index singular_row_ = -1;
};

/// Computes the residual of solution.lambda and says `solved` if it is small for this problem, else
/// `otherwise`.
inline void conclude(const Mlcp& mlcp, Solution& solution, Real tolerance, Status otherwise)
{
    solution.residual = natural_residual(mlcp, solution.lambda);
    const bool met = solution.residual <= tolerance * size_of_numbers(mlcp, solution.lambda);
    solution.status = met ? Status::solved : otherwise;
}

//! [direct]
/// (3.26): all rows bilateral, w = 0. `solved`, or `singular` (λ is then zero) if a row adds nothing to the
/// others, whether or not they contradict each other: λ is not determined.
/// \param tolerance  of the natural residual, relative to the numbers in the problem
/// \throws std::invalid_argument  for an invalid problem, a row with a bound, or an A that is not symmetric
inline Solution direct(const Mlcp& mlcp, Real tolerance = 1e-10)
{
    require_valid(mlcp);
    std::vector<Index> rows;
    for (Index i = 0; i < mlcp.size(); ++i) {
        if (!is_bilateral(mlcp, i))
            throw std::invalid_argument("row " + std::to_string(i) + " has the bounds " +
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
    solution.uniqueness = Uniqueness::unique;
    conclude(mlcp, solution, tolerance, Status::singular);
    return solution;
}
//! [direct]

/// What is left when the bilateral rows have been eliminated.
struct SchurComplement {
    std::vector<Index> bilateral, others;  ///< row numbers of the whole problem
    BilateralBlock block;                  ///< A_BB
    SparseMatrix A_BN;
    Mlcp rest;  ///< S, r and the bounds of the others

    /// λ of the whole problem from the λ of the others: \f$\lambda_B = -A_{BB}^{-1}(q_B + A_{BN}
    /// \lambda_N)\f$, (3.27).
    VecX whole(const Mlcp& mlcp, const VecX& rest_lambda) const
    {
        VecX lambda(mlcp.size());
        VecX right = -(A_BN * rest_lambda);
        for (std::size_t k = 0; k < bilateral.size(); ++k)
            right[static_cast<Index>(k)] -= mlcp.q[bilateral[k]];
        const VecX bilateral_lambda = block.solve(right);
        for (std::size_t k = 0; k < bilateral.size(); ++k)
            lambda[bilateral[k]] = bilateral_lambda[static_cast<Index>(k)];
        for (std::size_t k = 0; k < others.size(); ++k)
            lambda[others[k]] = rest_lambda[static_cast<Index>(k)];
        return lambda;
    }
};

//! [eliminate]
/// (3.28): takes the bilateral rows out of the problem. If block.singular_row() says that they are redundant,
/// `rest` is not computed.
inline void eliminate_bilateral(const Mlcp& mlcp, SchurComplement& schur)
{
    schur.bilateral.clear();
    schur.others.clear();
    std::vector<int> place(static_cast<std::size_t>(mlcp.size()));  // of a row within its part
    for (Index i = 0; i < mlcp.size(); ++i) {
        std::vector<Index>& part = is_bilateral(mlcp, i) ? schur.bilateral : schur.others;
        place[static_cast<std::size_t>(i)] = static_cast<int>(part.size());
        part.push_back(i);
    }
    const auto B = static_cast<Index>(schur.bilateral.size()), N = static_cast<Index>(schur.others.size());
    schur.block.factor(mlcp.A, schur.bilateral);
    if (schur.block.singular_row() >= 0) return;

    std::vector<Eigen::Triplet<Real>> BN, NB, NN;
    for (Index i = 0; i < mlcp.size(); ++i)
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            const bool row = is_bilateral(mlcp, i), column = is_bilateral(mlcp, entry.col());
            if (row && column) continue;
            auto& part = row ? BN : column ? NB : NN;
            part.emplace_back(place[static_cast<std::size_t>(i)],
                              place[static_cast<std::size_t>(entry.col())], entry.value());
        }
    schur.A_BN.resize(B, N);
    schur.A_BN.setFromTriplets(BN.begin(), BN.end());
    SparseMatrix A_NB(N, B), A_NN(N, N);
    A_NB.setFromTriplets(NB.begin(), NB.end());
    A_NN.setFromTriplets(NN.begin(), NN.end());

    VecX q_B(B);
    schur.rest.q.resize(N);
    schur.rest.lo.resize(N);
    schur.rest.hi.resize(N);
    for (Index k = 0; k < B; ++k) q_B[k] = mlcp.q[schur.bilateral[static_cast<std::size_t>(k)]];
    for (Index k = 0; k < N; ++k) {
        const Index i = schur.others[static_cast<std::size_t>(k)];
        schur.rest.q[k] = mlcp.q[i];
        schur.rest.lo[k] = mlcp.lo[i];
        schur.rest.hi[k] = mlcp.hi[i];
    }
    MatX S = A_NN;
    for (Index k = 0; k < N; ++k) S.col(k) -= A_NB * schur.block.solve(VecX(schur.A_BN.col(k)));
    schur.rest.A = S.sparseView();
    schur.rest.q -= A_NB * schur.block.solve(q_B);
}
//! [eliminate]

//! [schur]
/// Eliminates the bilateral rows, enumerates the cases of the others, and substitutes back. `singular` if the
/// bilateral rows are redundant, else the status of the enumeration, once the whole λ has proved itself.
/// \param settings  of the enumeration; `first` names all rows of the whole problem
/// \throws std::invalid_argument  for an invalid problem, too many rows with bounds, or an A that is not
///                                symmetric in its bilateral rows
inline Solution schur(const Mlcp& mlcp, const EnumerationSettings& settings = {})
{
    require_valid(mlcp);
    SchurComplement parts;
    eliminate_bilateral(mlcp, parts);
    Solution solution;
    if (parts.block.singular_row() >= 0) {
        solution.lambda = VecX::Zero(mlcp.size()).cwiseMax(mlcp.lo).cwiseMin(mlcp.hi);
        solution.residual = natural_residual(mlcp, solution.lambda);
        solution.status = Status::singular;
        return solution;
    }
    EnumerationSettings of_rest = settings;
    if (static_cast<Index>(settings.first.size()) == mlcp.size()) {
        of_rest.first.clear();
        for (const Index i : parts.others)
            of_rest.first.push_back(settings.first[static_cast<std::size_t>(i)]);
    }
    solution = enumerate(parts.rest, of_rest);
    solution.lambda = parts.whole(mlcp, solution.lambda);
    if (solution.status == Status::solved)
        conclude(mlcp, solution, settings.tolerance, Status::singular);  // A_BB was too nearly singular
    else solution.residual = natural_residual(mlcp, solution.lambda);
    return solution;
}
//! [schur]

}  // namespace rigid
