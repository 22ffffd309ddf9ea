/// \file standard_form.hpp
/// From the MLCP to the plain problem that Lemke's algorithm walks on, and back.
///
///     0 ≤ z ⟂ A z + q ≥ 0
///
///     lo ≤ λ                λ = lo + z (5.16)
///          λ ≤ hi           λ = hi - z, and the row changes its sign (5.16)
///     lo ≤ λ ≤ hi           λ = lo + z, and a row of its own keeps z ≤ hi - lo (5.17)
///     lo = λ = hi           nothing to find
///     λ free                w = 0: eliminated by the Schur complement of chapter 3 (3.28); where the
///     bilateral
///                           rows repeat each other, λ = z₊ - z₋ instead (5.18)
///
/// Rows and columns are scaled (units.hpp), so that no unit of mass or length matters.
#pragma once

#include "chapters/03_mlcp_formulation/schur.hpp"
#include "chapters/05_lemke/tableau.hpp"
#include "chapters/05_lemke/units.hpp"

#include <utility>
#include <vector>

namespace rigid {

class StandardForm {
public:
    MatX A;  ///< scaled
    VecX q;

    /// \param mlcp  a valid problem; it has to live as long as the form
    explicit StandardForm(const Mlcp& mlcp);

    /// λ of the MLCP.
    VecX impulses(const VecX& z) const;

    /// What a vertex says of the rows of the MLCP: λ where it stands at a bound,
    /// and which rows are between. Of a row that was split and has no basic z, λ =
    /// 0.
    VecX bounds_at(const Tableau& tableau, std::vector<Index>& between) const;

    /// A direction of z as weights of the rows of the MLCP, for (5.15). Eliminated rows get the weights that
    /// make (Aᵀy)_B zero: A_BB y_B = −(Aᵀ y_N)_B.
    VecX direction(const VecX& y) const;

private:
    void add(Index row, Real sign)
    {
        row_.push_back(row);
        sign_.push_back(sign);
        box_.push_back(-1);
    }

    bool has_symmetric_bilateral_block() const;

    const Mlcp& mlcp_;
    SchurComplement schur_;
    bool eliminated_ = false;
    VecX fixed_;                      ///< λ where all z are zero
    std::vector<Index> row_;          ///< of each z, the row that it moves
    std::vector<Real> sign_;          ///< and which way
    std::vector<std::size_t> first_;  ///< of each row, its first z
    std::vector<Index> box_;          ///< of each z, its row of (5.17), or -1
    /// of each z, what its row and column were divided by
    VecX unit_;
};

}  // namespace rigid
