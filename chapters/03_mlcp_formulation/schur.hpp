/// \file schur.hpp
/// Bilateral rows and others together: eliminate the bilateral ones, enumerate what is left, substitute back.
///
///     S = A_NN − A_NB A_BB⁻¹ A_BN,   r = q_N − A_NB A_BB⁻¹ q_B         B bilateral, N the others
///     S λ_N + r ⟂ lo ≤ λ_N ≤ hi,     λ_B = −A_BB⁻¹ (q_B + A_BN λ_N)
///
/// (3.27) and (3.28). So joints cost no either/or: the sets of cases are those of the contacts alone.
/// \cite cottle1992
#pragma once

#include "chapters/03_mlcp_formulation/direct.hpp"
#include "chapters/03_mlcp_formulation/enumeration.hpp"

#include <vector>

namespace rigid {

/// What is left when the bilateral rows have been eliminated.
struct SchurComplement {
    std::vector<Index> bilateral, others;  ///< row numbers of the whole problem
    BilateralBlock block;                  ///< A_BB
    /// by columns: each is a right side to solve for
    Eigen::SparseMatrix<Real> A_BN;
    Mlcp rest;  ///< S, r and the bounds of the others
    /// least share that the elimination left of an A_ii or a q_i
    Real kept = 1;

    /// λ of the whole problem from the λ of the others: \f$\lambda_B = -A_{BB}^{-1}(q_B + A_{BN}
    /// \lambda_N)\f$, (3.27).
    VecX whole(const Mlcp& mlcp, const VecX& rest_lambda) const;
};

/// (3.28): takes the bilateral rows out of the problem. If block.singular_row()
/// says that they are redundant, `rest` is not computed.
void eliminate_bilateral(const Mlcp& mlcp, SchurComplement& schur);

/// Eliminates the bilateral rows, enumerates the cases of the others, and
/// substitutes back. `singular` if the bilateral rows are redundant, else the
/// status of the enumeration, once the whole λ has proved itself.
/// \param settings  of the enumeration; `first` names all rows of the whole problem
/// \throws std::invalid_argument  for an invalid problem, too many rows with
///     bounds, or an A that is not symmetric in its bilateral rows
Solution schur(const Mlcp& mlcp, const EnumerationSettings& settings = {});

}  // namespace rigid
