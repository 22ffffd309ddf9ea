/// \file stewart_trinkle_rows.hpp
/// Section 13.N's problem of Stewart and Trinkle for any rows: each friction row with its own μ and its own normal, beside rows with
/// bounds of any kind. \cite stewart1996
///
///     0 ≤ β± ⟂ γ ± w_f ≥ 0,   0 ≤ γ ⟂ μ λ_n − β₊ − β₋ ≥ 0,   λ_f = β₊ − β₋
///
/// β₊ takes the place of λ_f; behind the n rows come the β₋ of all boxes, then their γ.
#pragma once

#include "chapters/05_lemke/lemke.hpp"
#include "chapters/13_friction/coulomb_residual.hpp"

namespace rigid {

//! [stewart_trinkle]
/// (13.29) of any rows: an MLCP of n + 2m rows for n rows of which m are friction.
/// \throws std::invalid_argument  for a malformed box
inline Mlcp stewart_trinkle(const Mlcp& rows, std::span<const FrictionBox> boxes)
{
    require_valid(rows, boxes);
    const auto n = static_cast<int>(rows.size()),
               m = static_cast<int>(boxes.size());
    std::vector<int> box_of(static_cast<std::size_t>(n), -1);
    for (int k = 0; k < m; ++k)
        box_of[static_cast<std::size_t>(boxes[std::size_t(k)].row)] = k;
    std::vector<Eigen::Triplet<Real>> entries;
    for (int i = 0; i < n; ++i)
        for (SparseMatrix::InnerIterator a(rows.A, i); a; ++a) {
            const auto j = static_cast<int>(a.col());
            const int k = box_of[static_cast<std::size_t>(i)],
                      l = box_of[static_cast<std::size_t>(j)];
            entries.emplace_back(i, j, a.value());
            if (k >= 0) entries.emplace_back(n + k, j, -a.value());
            if (l >= 0) entries.emplace_back(i, n + l, -a.value());
            if (k >= 0 && l >= 0) entries.emplace_back(n + k, n + l, a.value());
        }
    const int size = n + 2 * m;
    Mlcp lcp{SparseMatrix(size, size), VecX::Zero(size), VecX::Zero(size),
             VecX::Constant(size, infinity)};
    lcp.q.head(n) = rows.q;
    lcp.lo.head(n) = rows.lo;
    lcp.hi.head(n) = rows.hi;
    for (int k = 0; k < m; ++k) {
        const FrictionBox& box = boxes[static_cast<std::size_t>(k)];
        const auto f = static_cast<int>(box.row);
        const int gamma = n + m + k;
        lcp.q[n + k] = -rows.q[f];
        lcp.lo[f] = 0;
        lcp.hi[f] = infinity;
        entries.emplace_back(f, gamma, 1.0);      // γ + w
        entries.emplace_back(n + k, gamma, 1.0);  // γ − w
        entries.emplace_back(gamma, static_cast<int>(box.normal), box.mu);  // μ λ
        entries.emplace_back(gamma, f, -1.0);      // − β₊
        entries.emplace_back(gamma, n + k, -1.0);  // − β₋
    }
    lcp.A.setFromTriplets(entries.begin(), entries.end());
    return lcp;
}
//! [stewart_trinkle]

/// Its answer by Lemke's algorithm, with the λ of the n rows.
inline Solution stewart_trinkle_by_lemke(const Mlcp& rows,
                                         std::span<const FrictionBox> boxes,
                                         const LemkeSettings& settings = {})
{
    Solution solution = lemke(stewart_trinkle(rows, boxes), settings);
    const Index n = rows.size();
    VecX lambda = solution.lambda.head(n);
    for (std::size_t k = 0; k < boxes.size(); ++k)
        lambda[boxes[k].row] -= solution.lambda[n + static_cast<Index>(k)];
    solution.lambda = lambda;
    return solution;
}

}  // namespace rigid
