/// \file elimination.hpp
/// What can be known of a Cholesky factor before any number is: where its entries are.
///
///     row k of L has an entry in column j  ⇔  k is reached from some j' with A_kj' ≠ 0 along parent(·)
///
/// (9.9): the elimination tree. The pattern is that of the whole A. The factor of any set of active rows has
/// no entry outside it, so this is computed once for a structure, however often the guess changes.
/// \cite davis2006, ch. 4
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <vector>

namespace rigid {

class Elimination {
public:
    std::vector<int> order;  ///< order[k]: the row that is eliminated k-th
    /// n + 1: row k of L has its entries in row_columns from here
    std::vector<int> row_begin;
    /// an order in which no column comes before one that it depends on
    std::vector<int> row_columns;
    /// n + 1: room for the entries of each column
    std::vector<int> column_begin;
    /// n + 1: entries of A left of the diagonal of row k …
    std::vector<int> lower_begin;
    std::vector<int> lower_column;  ///< … their places in the order …
    std::vector<int> lower_value;   ///< … and where A has their values
    /// the same for the diagonal; -1 = A has none
    std::vector<int> diagonal_value;
    /// whether the last analyse_pattern() had to work
    bool analysed = false;

    Index size() const { return static_cast<Index>(order.size()); }
    Index entries() const { return static_cast<Index>(row_columns.size()); }

    /// Finds the order and the pattern, unless the structure is the one of last
    /// time.
    /// \param A  of symmetric structure, compressed
    void analyse_pattern(const SparseMatrix& A);

private:
    /// The pattern of L for the present order; false if it has more entries than wanted.
    bool find_pattern(const SparseMatrix& A, std::size_t most);

    std::vector<int> seen_outer_, seen_inner_, place_, parent_, met_, path_;
};

}  // namespace rigid
