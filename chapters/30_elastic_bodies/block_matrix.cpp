#include "chapters/30_elastic_bodies/block_matrix.hpp"

#include <algorithm>

namespace rigid {

int BlockPattern::slot(int a, int b) const
{
    const int column = std::min(a, b), wanted = std::max(a, b);
    const auto first = row.begin() + start[static_cast<std::size_t>(column)],
               last = row.begin() + start[static_cast<std::size_t>(column) + 1];
    const auto found = std::lower_bound(first, last, wanted);
    return found == last || *found != wanted
               ? -1
               : static_cast<int>(found - row.begin());
}

BlockPattern pattern_of(int nodes, std::vector<std::array<int, 2>> pairs)
{
    for (auto& [a, b] : pairs)
        if (a > b) std::swap(a, b);
    for (int i = 0; i < nodes; ++i) pairs.push_back({i, i});
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    BlockPattern pattern;
    pattern.start.assign(static_cast<std::size_t>(nodes) + 1, 0);
    for (const auto& [column, row] : pairs) {
        ++pattern.start[static_cast<std::size_t>(column) + 1];
        pattern.row.push_back(row);
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(nodes); ++i)
        pattern.start[i + 1] += pattern.start[i];
    return pattern;
}

template <int Dim>
void BlockMatrix<Dim>::multiply(const VecX& x, VecX& y) const
{
    y.setZero(x.size());
    for (int j = 0; j < pattern->size(); ++j) {
        const Real* const xj = x.data() + Dim * j;
        Real own[Dim] = {};
        for (int p = pattern->start[static_cast<std::size_t>(j)];
             p < pattern->start[static_cast<std::size_t>(j) + 1]; ++p) {
            const int i = pattern->row[static_cast<std::size_t>(p)];
            const Real* const B = block(p);
            Real* const yi = y.data() + Dim * i;
            for (int r = 0; r < Dim; ++r)
                for (int c = 0; c < Dim; ++c) yi[r] += B[r * Dim + c] * xj[c];
            if (i == j) continue;
            const Real* const xi = x.data() + Dim * i;
            for (int r = 0; r < Dim; ++r)
                for (int c = 0; c < Dim; ++c) own[c] += B[r * Dim + c] * xi[r];
        }
        for (int c = 0; c < Dim; ++c) y[Dim * j + c] += own[c];
    }
}

template <int Dim>
void fix(std::span<const char> fixed, BlockMatrix<Dim>& A)
{
    const BlockPattern& pattern = *A.pattern;
    for (int j = 0; j < pattern.size(); ++j)
        for (int p = pattern.start[static_cast<std::size_t>(j)];
             p < pattern.start[static_cast<std::size_t>(j) + 1]; ++p) {
            const int i = pattern.row[static_cast<std::size_t>(p)];
            Real* const B = A.block(p);
            for (int r = 0; r < Dim; ++r)
                for (int c = 0; c < Dim; ++c)
                    if (fixed[static_cast<std::size_t>(Dim * i + r)] ||
                        fixed[static_cast<std::size_t>(Dim * j + c)])
                        B[r * Dim + c] = i == j && r == c ? 1 : 0;
        }
}

Real ordered_dot(const VecX& a, const VecX& b)
{
    Real sum[4] = {};
    const Index n = a.size(), whole = n - n % 4;
    for (Index i = 0; i < whole; i += 4)
        for (Index k = 0; k < 4; ++k) sum[k] += a[i + k] * b[i + k];
    for (Index i = whole; i < n; ++i) sum[i - whole] += a[i] * b[i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

template <int Dim>
bool ConjugateGradients::solve(const BlockMatrix<Dim>& A, const VecX& b, VecX& x)
{
    const int n = A.pattern->size();
    inverse.resize(static_cast<std::size_t>(n * Dim * Dim));
    iterations = 0;
    x.setZero(b.size());
    for (int i = 0; i < n; ++i)
        if (!invert<Dim>(A.block(A.pattern->start[static_cast<std::size_t>(i)]),
                         inverse.data() + i * Dim * Dim))
            return false;
    const auto precondition = [&] {
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < Dim; ++k) {
                const Real* const B = inverse.data() + i * Dim * Dim + k * Dim;
                Real sum = 0;
                for (int c = 0; c < Dim; ++c) sum += B[c] * r[Dim * i + c];
                z[Dim * i + k] = sum;
            }
    };
    r = b;
    z.resize(b.size());
    precondition();
    p = z;
    Real rz = ordered_dot(r, z);
    const Real enough = tolerance * tolerance * rz;
    if (!(rz > 0)) return rz == 0;
    for (; iterations < most; ++iterations) {
        A.multiply(p, Ap);
        const Real curvature = ordered_dot(p, Ap);
        if (!(curvature > 0)) return false;
        const Real alpha = rz / curvature;
        x += alpha * p;
        r -= alpha * Ap;
        precondition();
        const Real next = ordered_dot(r, z);
        if (next <= enough) {
            ++iterations;
            return true;
        }
        p = z + (next / rz) * p;
        rz = next;
    }
    return false;
}

#define RIGID_BLOCKS(D)                                                            \
    template struct BlockMatrix<D>;                                                \
    template void fix(std::span<const char>, BlockMatrix<D>&);                     \
    template bool ConjugateGradients::solve(const BlockMatrix<D>&, const VecX&,    \
                                            VecX&);
RIGID_BLOCKS(1)
RIGID_BLOCKS(2)
RIGID_BLOCKS(3)

}  // namespace rigid
