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
std::string sentence(const RowsAnswer& answer);

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
    const RowsAnswer& solve(const std::vector<Row<Dof>>& rows, const VecX& u);

private:
    static const Row<Dof>& row(const std::vector<Row<Dof>>& rows, Index i)
    {
        return rows[static_cast<std::size_t>(i)];
    }

    static void require_bilateral(const std::vector<Row<Dof>>& rows, const VecX& u);

    /// Tries the answer: gives the velocities the impulses, and looks at what is left of each row.
    void judge(const std::vector<Row<Dof>>& rows, const VecX& u);

    /// The sum of the sizes of what J u + b is made of: lengths, so that it does not matter how the axes lie.
    static Real reach(const Row<Dof>& row, const VecX& u);

    MatX A_;
    VecX q_, scale_, u_;
    Eigen::LDLT<MatX> ldlt_;
    Eigen::CompleteOrthogonalDecomposition<MatX> orthogonal_;
    RowsAnswer answer_;
};

// Compiled once, in solve_rows.cpp.
extern template class RowsSolver<1>;
extern template class RowsSolver<2>;
extern template class RowsSolver<3>;
extern template class RowsSolver<6>;

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
