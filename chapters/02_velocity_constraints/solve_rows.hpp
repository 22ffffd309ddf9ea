/// \file solve_rows.hpp
/// Several bilateral rows in one shot, by a dense factorisation of the small matrix A.
///
///     A λ = −(J u + b),   A = J M⁻¹ Jᵀ,   u ← u + M⁻¹ Jᵀ λ
///
/// (2.24). The rows may be redundant (then many λ give the same velocity, and the one with the
/// least Σ A_ii λ_i² is given) or contradict each other (then the velocity that breaks them least
/// is found, and the rows with w ≠ 0 are named: they contradict each other by themselves).
#pragma once

#include "chapters/02_velocity_constraints/row_checks.hpp"
#include "common/text.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <string>
#include <vector>

namespace rigid {

/// The answer to several bilateral rows.
struct RowsAnswer {
    VecX lambda;        ///< m [N s]
    VecX w;             ///< m: \f$Ju + b\f$ after the impulses [m/s]
    Real residual = 0;  ///< the largest |w_i| [m/s]
    Index rank = 0;     ///< how many of the m rows say something new
    Verdict verdict = Verdict::independent;
    /// the rows that contradict each other; empty unless conflicting
    std::vector<Index> at_odds;
};

/// The answer in one sentence, for a reader.
inline std::string sentence(const RowsAnswer& answer)
{
    const std::string rows = std::to_string(answer.lambda.size()) +
                             " rows of rank " + std::to_string(answer.rank);
    if (answer.verdict == Verdict::independent)
        return rows + ": each has its own say, one answer";
    if (answer.verdict == Verdict::redundant)
        return rows + ": redundant, the velocity is certain but lambda is not; the "
                      "smallest is given";
    std::string names;
    for (std::size_t i = 0; i < answer.at_odds.size() && i < 8; ++i)
        names += (i ? ", " : "") + std::to_string(answer.at_odds[i]);
    if (answer.at_odds.size() > 8) names += ", ...";
    return rows + ": no velocity meets row(s) " + names +
           " together; the best compromise misses by " + readable(answer.residual) +
           " m/s";
}

/// How much smaller than the largest pivot one must be to count as zero. The rows are scaled to
/// \f$A_{ii} = 1\f$ first, so that units and masses don't matter. A is a square: rows whose directions
/// differ by the angle δ have the pivot δ², so 1e-12 distinguishes directions down to 1e-6 rad.
inline constexpr Real rank_tolerance = 1e-12;

/// A velocity this much smaller than those that it was summed from is rounding.
inline constexpr Real conflict_tolerance = 1e-9;

/// \f$A_{ij} = J_i M^{-1} J_j^T\f$ [1/kg]: what one unit of λ_j does to the velocity of row i.
/// Only bodies that both rows have in common carry it.
template <int Dof>
Real coupling(const Row<Dof>& i, const Row<Dof>& j)
{
    Real A = 0;
    if (i.a != world && i.a == j.a) A += i.Ja.dot(j.Wa);
    if (i.a != world && i.a == j.b) A += i.Ja.dot(j.Wb);
    if (i.b == j.a) A += i.Jb.dot(j.Wa);
    if (i.b == j.b) A += i.Jb.dot(j.Wb);
    return A;
}

/// Solves bilateral rows together. Keeps its memory, so that solving as many rows again does not allocate
/// (as long as they are independent).
template <int Dof>
class RowsSolver {
public:
    /// Throws std::invalid_argument for a row that is not bilateral or makes no sense.
    /// \param rows  m rows with lo = −∞, hi = ∞
    /// \param u     velocities before the impulses [m/s]; they are not changed, see apply()
    const RowsAnswer& solve(const std::vector<Row<Dof>>& rows, const VecX& u)
    {
        const Index m = static_cast<Index>(rows.size());
        require_bilateral(rows, u);
        answer_.at_odds.clear();
        answer_.lambda.resize(m);
        if (m == 0) {
            answer_ = {};
            return answer_;
        }
        //! [solve_rows]
        A_.resize(m, m);
        q_.resize(m);
        scale_.resize(m);
        for (Index i = 0; i < m; ++i) {  // (2.24): A = J M⁻¹ Jᵀ and q = J u + b
            q_[i] = row(rows, i).velocity(u);
            for (Index j = 0; j <= i; ++j)
                A_(i, j) = coupling(row(rows, i), row(rows, j));
            A_(i, i) += row(rows, i).softness;
            scale_[i] = A_(i, i) > 0 ? 1 / std::sqrt(A_(i, i)) : 1;
        }
        for (Index i = 0; i < m; ++i)  // to a unit diagonal
            for (Index j = 0; j <= i; ++j)
                A_(j, i) = A_(i, j) *= scale_[i] * scale_[j];
        q_.array() *= scale_.array();

        ldlt_.compute(A_);
        answer_.rank = m;
        if (ldlt_.vectorD().minCoeff() > rank_tolerance) {
            answer_.lambda = ldlt_.solve(-q_);
        } else {
            // rows that repeat others: the least λ of those that leave the least w
            orthogonal_.setThreshold(rank_tolerance);
            orthogonal_.compute(A_);
            answer_.rank = orthogonal_.rank();
            answer_.lambda = orthogonal_.solve(-q_);
        }
        answer_.lambda.array() *= scale_.array();
        //! [solve_rows]
        judge(rows, u);
        return answer_;
    }

private:
    static const Row<Dof>& row(const std::vector<Row<Dof>>& rows, Index i)
    {
        return rows[static_cast<std::size_t>(i)];
    }

    static void require_bilateral(const std::vector<Row<Dof>>& rows, const VecX& u)
    {
        require_finite(u, "u");
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::string name = "row " + std::to_string(i);
            require_valid(rows[i], name, u.size() / Dof);
            if (rows[i].lo != -infinity || rows[i].hi != infinity ||
                rows[i].bounded_by >= 0)
                throw std::invalid_argument(
                    name + " is bounded; rows are solved together only if they may "
                           "push and "
                           "pull without bound (lo = -infinity, hi = infinity)");
        }
    }

    /// Tries the answer: gives the velocities the impulses, and looks at what is left of each row.
    void judge(const std::vector<Row<Dof>>& rows, const VecX& u)
    {
        const Index m = answer_.lambda.size();
        u_ = u;
        for (Index i = 0; i < m; ++i) row(rows, i).apply(answer_.lambda[i], u_);
        answer_.w.resize(m);
        Real worst = 0, speed = 0;  // of the scaled rows
        for (Index i = 0; i < m; ++i) {
            answer_.w[i] = row(rows, i).velocity(u_) +
                           row(rows, i).softness * answer_.lambda[i];
            worst = std::max(worst, scale_[i] * std::abs(answer_.w[i]));
            speed = std::max(speed, scale_[i] * std::max(reach(row(rows, i), u),
                                                         reach(row(rows, i), u_)));
        }
        answer_.residual = answer_.w.cwiseAbs().maxCoeff();
        answer_.verdict =
            answer_.rank == m ? Verdict::independent : Verdict::redundant;
        if (worst <= conflict_tolerance * speed) return;
        answer_.verdict = Verdict::conflicting;
        for (Index i = 0; i < m; ++i)
            if (scale_[i] * std::abs(answer_.w[i]) > 1e-6 * worst)
                answer_.at_odds.push_back(i);
    }

    /// The sum of the sizes of what J u + b is made of: lengths, so that it does not matter how the axes lie.
    static Real reach(const Row<Dof>& row, const VecX& u)
    {
        Real sum = std::abs(row.bias) +
                   row.Jb.norm() * u.template segment<Dof>(Dof * row.b).norm();
        if (row.a != world)
            sum += row.Ja.norm() * u.template segment<Dof>(Dof * row.a).norm();
        return sum;
    }

    MatX A_;
    VecX q_, scale_, u_;
    Eigen::LDLT<MatX> ldlt_;
    Eigen::CompleteOrthogonalDecomposition<MatX> orthogonal_;
    RowsAnswer answer_;
};

/// Solves bilateral rows together, see RowsSolver::solve().
template <int Dof>
RowsAnswer solve_rows(const std::vector<Row<Dof>>& rows, const VecX& u)
{
    return RowsSolver<Dof>().solve(rows, u);
}

/// \f$u \leftarrow u + M^{-1} J^T \lambda\f$ for all rows, (2.5).
template <int Dof>
void apply(const std::vector<Row<Dof>>& rows, const VecX& lambda, VecX& u)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].apply(lambda[static_cast<Index>(i)], u);
}

}  // namespace rigid
