// The functions of elimination.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/elimination.hpp"

namespace rigid {

//! [analyse_pattern]
void Elimination::analyse_pattern(const SparseMatrix& A)
{
    const auto n = static_cast<std::size_t>(A.rows());
    const int* const outer = A.outerIndexPtr();
    const int* const inner = A.innerIndexPtr();
    const auto entries_of_A = static_cast<std::size_t>(A.nonZeros());
    analysed =
        !(seen_outer_.size() == n + 1 && seen_inner_.size() == entries_of_A &&
          std::equal(outer, outer + n + 1, seen_outer_.begin()) &&
          std::equal(inner, inner + entries_of_A, seen_inner_.begin()));
    if (!analysed) return;
    seen_outer_.assign(outer, outer + n + 1);
    seen_inner_.assign(inner, inner + entries_of_A);

    // Rows in the order in which they stand are best for columns and chains,
    // and cost nothing.
    order.resize(n);
    for (std::size_t k = 0; k < n; ++k) order[k] = static_cast<int>(k);
    if (find_pattern(A, 2 * entries_of_A)) return;
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
    // its columns are its rows
    const Eigen::Map<const Eigen::SparseMatrix<Real>> by_columns(
        A.rows(), A.cols(), A.nonZeros(), outer, inner, A.valuePtr());
    Eigen::AMDOrdering<int>()(by_columns.selfadjointView<Eigen::Lower>(),
                              permutation);
    std::copy(permutation.indices().begin(), permutation.indices().end(),
              order.begin());
    find_pattern(A, n * n);
}
//! [analyse_pattern]

bool Elimination::find_pattern(const SparseMatrix& A, std::size_t most)
{
    const auto n = static_cast<int>(A.rows());
    const auto at = [](auto& list, int i) -> auto&
    {
        return list[static_cast<std::size_t>(i)];
    };
    place_.resize(order.size());
    for (int k = 0; k < n; ++k) at(place_, at(order, k)) = k;
    lower_begin.assign(1, 0);
    lower_column.clear();
    lower_column.reserve(static_cast<std::size_t>(A.nonZeros()) / 2);
    lower_value.clear();
    lower_value.reserve(static_cast<std::size_t>(A.nonZeros()) / 2);
    diagonal_value.assign(order.size(), -1);
    row_begin.assign(1, 0);
    row_columns.clear();
    // where it may become larger it grows as a vector does
    row_columns.reserve(std::min(most, 4 * static_cast<std::size_t>(A.nonZeros())));
    parent_.assign(order.size(), -1);
    met_.assign(order.size(), -1);
    path_.resize(order.size());
    column_begin.assign(order.size() + 1, 0);

    //! [tree]
    for (int k = 0; k < n; ++k) {
        // path_[top], …: row k of L, later columns behind the earlier ones they
        // need
        int top = n;
        at(met_, k) = k;
        const int i = at(order, k);
        for (int p = A.outerIndexPtr()[i]; p < A.outerIndexPtr()[i + 1]; ++p) {
            int j = at(place_, A.innerIndexPtr()[p]);
            if (j == k) at(diagonal_value, k) = p;
            if (j >= k) continue;
            lower_column.push_back(j);
            lower_value.push_back(p);
            // up the tree until a node that row k has met already
            int length = 0;
            for (; at(met_, j) != k; j = at(parent_, j)) {
                if (at(parent_, j) == -1) at(parent_, j) = k;
                at(path_, length++) = j;
                at(met_, j) = k;
            }
            while (length > 0) at(path_, --top) = at(path_, --length);
        }
        for (; top < n; ++top) {
            row_columns.push_back(at(path_, top));
            ++at(column_begin, at(path_, top) + 1);
        }
        if (row_columns.size() > most) return false;
        row_begin.push_back(static_cast<int>(row_columns.size()));
        lower_begin.push_back(static_cast<int>(lower_column.size()));
    }
    //! [tree]
    for (int k = 0; k < n; ++k) at(column_begin, k + 1) += at(column_begin, k);
    return true;
}

}  // namespace rigid
