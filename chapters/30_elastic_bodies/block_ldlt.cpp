#include "chapters/30_elastic_bodies/block_ldlt.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace rigid {

namespace {

template <class List>
auto& at(List& list, std::int64_t i)
{
    return list[static_cast<std::size_t>(i)];
}

}  // namespace

template <int Dim>
void BlockLdlt<Dim>::analyse(const BlockPattern& pattern)
{
    const int n = pattern.size();
    std::vector<Eigen::Triplet<Real, int>> ones;
    for (int j = 0; j < n; ++j)
        for (int p = at(pattern.start, j); p < at(pattern.start, j + 1); ++p) {
            ones.emplace_back(at(pattern.row, p), j, 1.0);
            if (at(pattern.row, p) != j)
                ones.emplace_back(j, at(pattern.row, p), 1.0);
        }
    Eigen::SparseMatrix<Real, Eigen::ColMajor, int> graph(n, n);
    graph.setFromTriplets(ones.begin(), ones.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> found;
    Eigen::AMDOrdering<int>()(graph, found);
    order_.assign(static_cast<std::size_t>(n), 0), place_ = order_;
    for (int k = 0; k < n; ++k) {
        at(order_, k) = found.indices()[k];
        at(place_, at(order_, k)) = k;
    }
    // what of A is above the diagonal in the new order, column by column
    above_start_.assign(static_cast<std::size_t>(n) + 1, 0);
    diagonal_slot_.assign(static_cast<std::size_t>(n), 0);
    const auto each = [&](auto&& visit) {
        for (int j = 0; j < n; ++j)
            for (int p = at(pattern.start, j); p < at(pattern.start, j + 1); ++p) {
                const int i = at(pattern.row, p), ri = at(place_, i),
                          rj = at(place_, j);
                if (i == j) at(diagonal_slot_, rj) = p;
                else visit(std::min(ri, rj), std::max(ri, rj), p, ri > rj);
            }
    };
    each([&](int, int column, int, bool) { ++at(above_start_, column + 1); });
    for (int k = 0; k < n; ++k) at(above_start_, k + 1) += at(above_start_, k);
    above_row_.assign(static_cast<std::size_t>(above_start_.back()), 0);
    above_slot_ = above_row_;
    above_turned_.assign(above_row_.size(), 0);
    std::vector<int> next(above_start_.begin(), above_start_.end() - 1);
    each([&](int row, int column, int slot, bool turned) {
        const int p = at(next, column)++;
        at(above_row_, p) = row, at(above_slot_, p) = slot;
        at(above_turned_, p) = turned;
    });
    // the elimination tree, and how many entries each column of L has
    parent_.assign(static_cast<std::size_t>(n), -1);
    mark_.assign(static_cast<std::size_t>(n), -1);
    first_.assign(static_cast<std::size_t>(n) + 1, 0);
    for (int k = 0; k < n; ++k) {
        at(mark_, k) = k;
        for (int p = at(above_start_, k); p < at(above_start_, k + 1); ++p)
            for (int i = at(above_row_, p); at(mark_, i) != k; i = at(parent_, i)) {
                if (at(parent_, i) < 0) at(parent_, i) = k;
                ++at(first_, i + 1);
                at(mark_, i) = k;
            }
    }
    for (int k = 0; k < n; ++k) at(first_, k + 1) += at(first_, k);
    filled_.assign(static_cast<std::size_t>(n), 0);
    row_.assign(static_cast<std::size_t>(first_.back()), 0);
    L_.assign(row_.size() * entries, 0);
    inverse_.assign(static_cast<std::size_t>(n) * entries, 0);
    Y_ = inverse_;
    reach_.assign(static_cast<std::size_t>(n), 0);
    y_.resize(Dim * n);
}

//! [factor]
template <int Dim>
bool BlockLdlt<Dim>::factor(const BlockMatrix<Dim>& A)
{
    const int n = size();
    std::fill(mark_.begin(), mark_.end(), -1);
    for (int k = 0; k < n; ++k) {
        // where row k of L has entries: up the tree from those of A
        int top = n;
        at(mark_, k) = k;
        at(filled_, k) = at(first_, k);
        for (int p = at(above_start_, k); p < at(above_start_, k + 1); ++p) {
            const Real* const a = A.block(at(above_slot_, p));
            Real* const y = &at(Y_, std::int64_t{at(above_row_, p)} * entries);
            for (int r = 0; r < Dim; ++r)
                for (int c = 0; c < Dim; ++c)
                    y[r * Dim + c] +=
                        at(above_turned_, p) ? a[c * Dim + r] : a[r * Dim + c];
            int length = 0;
            for (int i = at(above_row_, p); at(mark_, i) != k; i = at(parent_, i)) {
                at(reach_, length++) = i;
                at(mark_, i) = k;
            }
            while (length > 0) at(reach_, --top) = at(reach_, --length);
        }
        Real D[entries];
        std::copy_n(A.block(at(diagonal_slot_, k)), entries, D);
        for (; top < n; ++top) {
            const int i = at(reach_, top);
            Real* const y = &at(Y_, std::int64_t{i} * entries);
            Real Yi[entries];
            for (int e = 0; e < entries; ++e) Yi[e] = y[e], y[e] = 0;
            const std::int64_t last = at(filled_, i)++;
            for (std::int64_t p = at(first_, i); p < last; ++p) {
                const Real* const l = &at(L_, p * entries);
                Real* const to = &at(Y_, std::int64_t{at(row_, p)} * entries);
                for (int r = 0; r < Dim; ++r)
                    for (int c = 0; c < Dim; ++c) {
                        Real sum = l[r * Dim] * Yi[c];
                        for (int m = 1; m < Dim; ++m)
                            sum += l[r * Dim + m] * Yi[m * Dim + c];
                        to[r * Dim + c] -= sum;
                    }
            }
            const Real* const inverse = &at(inverse_, std::int64_t{i} * entries);
            Real* const l = &at(L_, last * entries);
            for (int r = 0; r < Dim; ++r)
                for (int c = 0; c < Dim; ++c) {  // L_ki = Y_iᵀ D_i⁻¹
                    Real sum = Yi[r] * inverse[c];
                    for (int m = 1; m < Dim; ++m)
                        sum += Yi[m * Dim + r] * inverse[m * Dim + c];
                    l[r * Dim + c] = sum;
                }
            for (int r = 0; r < Dim; ++r)
                for (int c = 0; c < Dim; ++c) {  // D_k −= L_ki Y_i
                    Real sum = l[r * Dim] * Yi[c];
                    for (int m = 1; m < Dim; ++m)
                        sum += l[r * Dim + m] * Yi[m * Dim + c];
                    D[r * Dim + c] -= sum;
                }
            at(row_, last) = k;
        }
        if (!invert<Dim>(D, &at(inverse_, std::int64_t{k} * entries))) {
            std::fill(Y_.begin(), Y_.end(), 0);
            return false;
        }
    }
    return true;
}
//! [factor]

template <int Dim>
void BlockLdlt<Dim>::solve(VecX& x) const
{
    const int n = size();
    for (int k = 0; k < n; ++k)
        for (int r = 0; r < Dim; ++r) y_[Dim * k + r] = x[Dim * at(order_, k) + r];
    for (int i = 0; i < n; ++i) {
        const Real* const yi = y_.data() + Dim * i;
        for (std::int64_t p = at(first_, i); p < at(first_, i + 1); ++p) {
            const Real* const l = &at(L_, p * entries);
            Real* const to = y_.data() + Dim * at(row_, p);
            for (int r = 0; r < Dim; ++r) {
                Real sum = l[r * Dim] * yi[0];
                for (int c = 1; c < Dim; ++c) sum += l[r * Dim + c] * yi[c];
                to[r] -= sum;
            }
        }
    }
    for (int i = n - 1; i >= 0; --i) {
        const Real* const inverse = &at(inverse_, std::int64_t{i} * entries);
        Real yi[Dim];
        for (int r = 0; r < Dim; ++r) {
            yi[r] = inverse[r * Dim] * y_[Dim * i];
            for (int c = 1; c < Dim; ++c)
                yi[r] += inverse[r * Dim + c] * y_[Dim * i + c];
        }
        for (std::int64_t p = at(first_, i); p < at(first_, i + 1); ++p) {
            const Real* const l = &at(L_, p * entries);
            const Real* const from = y_.data() + Dim * at(row_, p);
            for (int c = 0; c < Dim; ++c) {
                Real sum = l[c] * from[0];
                for (int r = 1; r < Dim; ++r) sum += l[r * Dim + c] * from[r];
                yi[c] -= sum;
            }
        }
        for (int r = 0; r < Dim; ++r) y_[Dim * i + r] = yi[r];
    }
    for (int k = 0; k < n; ++k)
        for (int r = 0; r < Dim; ++r) x[Dim * at(order_, k) + r] = y_[Dim * k + r];
}

template class BlockLdlt<1>;
template class BlockLdlt<2>;
template class BlockLdlt<3>;

}  // namespace rigid
