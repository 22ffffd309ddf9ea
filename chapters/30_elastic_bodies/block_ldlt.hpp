/// \file block_ldlt.hpp
/// A symmetric positive definite matrix of blocks as L D Lᵀ, in an order that fills in little.
///
///     L_ki = Y_iᵀ D_i⁻¹,   D_k = A_kk − Σ L_ki Y_i,   Y = what the rows before leave of column k   (30.21)
///
/// Row after row ("up-looking") \cite davis2006, ch. 4, with a block of Dim × Dim where
/// chapter 9's SparseLdlt has a number: the list of where entries are is Dim² times as
/// short. The order is Eigen's approximate minimum degree \cite amestoy1996.
#pragma once

#include "chapters/30_elastic_bodies/block_matrix.hpp"

namespace rigid {

template <int Dim>
class BlockLdlt {
public:
    /// Orders the nodes and finds where L has entries. Allocates; the others do not.
    void analyse(const BlockPattern& pattern);

    /// Returns false at a block on the diagonal that is not positive definite.
    bool factor(const BlockMatrix<Dim>& A);

    /// x: the right side, then the answer of A x = b.
    void solve(VecX& x) const;

    int size() const { return static_cast<int>(order_.size()); }
    /// Blocks of L below the diagonal.
    std::int64_t blocks() const { return first_.empty() ? 0 : first_.back(); }
    bool is_analysed() const { return !first_.empty(); }

private:
    static constexpr int entries = Dim * Dim;
    std::vector<int> order_, place_;  ///< node of a row; row of a node
    std::vector<int> parent_;         ///< the elimination tree
    /// of A above the diagonal, in the new order: rows, slots, whether transposed
    std::vector<int> above_start_, above_row_, above_slot_, diagonal_slot_;
    std::vector<char> above_turned_;
    std::vector<std::int64_t> first_, filled_;  ///< of each column of L
    std::vector<int> row_;
    std::vector<Real> L_, inverse_, Y_;
    std::vector<int> mark_, reach_;
    mutable VecX y_;
};

extern template class BlockLdlt<1>;
extern template class BlockLdlt<2>;
extern template class BlockLdlt<3>;

}  // namespace rigid
