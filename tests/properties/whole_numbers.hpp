/// \file whole_numbers.hpp
/// All answers of a problem of small whole numbers, without any rounding.
///
///     for each set of cases:  A_FF λ_F = −(q_F + A_FB λ_B),   lo ≤ λ_F ≤ hi,   w_i ≥ 0 at lo,   w_i ≤ 0 at hi
///
/// is a polyhedron. A simplex method in whole numbers (every entry is a determinant, all over one common denominator)
/// says whether it is empty, and between which values each λ_i and each w_i runs in it. \cite cottle1992
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "tests/properties/wide.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace rigid::properties {

#if defined(__SIZEOF_INT128__)
__extension__ typedef __int128 Whole;
#else
using Whole = std::int64_t;
#endif

struct TooLarge {};  ///< a determinant does not fit: nothing is decided

/// Max cᵀx subject to E x = f, x ≥ 0, all whole numbers. Bland's rule: it ends.
class WholeSimplex {
public:
    /// \param E  by rows, its last column is f
    explicit WholeSimplex(std::vector<std::vector<Whole>> E) : T_(std::move(E))
    {
        columns_ = T_.empty() ? 0 : T_[0].size() - 1;
        for (auto& line : T_) {
            if (line.back() < 0)
                for (Whole& entry : line) entry = -entry;
            basic_.push_back(columns_ + basic_.size());  // an artificial variable for each row
        }
        std::vector<Whole> cost(columns_ + 1, 0);
        for (const auto& line : T_)
            for (std::size_t j = 0; j <= columns_; ++j) cost[j] += line[j];
        climb(cost);  // cost: how fast the sum of the artificial variables falls, and what is left of it
        feasible_ = cost.back() == 0;
        for (std::size_t r = 0;
             feasible_ && r < T_.size();) {  // artificial ones at zero: out, or their row goes
            if (basic_[r] < columns_) {
                ++r;
                continue;
            }
            std::size_t c = 0;
            while (c < columns_ && T_[r][c] == 0) ++c;
            if (c < columns_) {
                pivot(r, c, cost);
                ++r;
            } else {
                T_.erase(T_.begin() + static_cast<std::ptrdiff_t>(r));
                basic_.erase(basic_.begin() + static_cast<std::ptrdiff_t>(r));
            }
        }
    }

    bool feasible() const { return feasible_; }

    /// The largest cᵀx; nothing if there is no largest. Only for a feasible problem.
    std::optional<Wide> largest(const std::vector<int>& c)
    {
        std::vector<Whole> cost(columns_ + 1, 0);  // c − c_B T, times the denominator; its end is −cᵀx
        for (std::size_t j = 0; j < columns_; ++j) cost[j] = times(c[j], denominator_);
        for (std::size_t r = 0; r < T_.size(); ++r)
            for (std::size_t j = 0; j <= columns_; ++j) cost[j] -= times(c[basic_[r]], T_[r][j]);
        if (!climb(cost)) return std::nullopt;
        return -static_cast<Wide>(cost.back()) / static_cast<Wide>(denominator_);
    }

private:
    static Whole times(Whole a, Whole b)
    {
        constexpr Real most =
            sizeof(Whole) > 8 ? 8e37 : 4e18;  // the difference of two products must fit, too
        if (std::abs(static_cast<Real>(a) * static_cast<Real>(b)) > most) throw TooLarge{};
        return a * b;
    }

    /// True at the largest, false if it grows without end.
    bool climb(std::vector<Whole>& cost)
    {
        for (;;) {
            std::size_t c = 0;
            while (c < columns_ && cost[c] <= 0) ++c;
            if (c == columns_) return true;
            std::size_t best = T_.size();
            for (std::size_t r = 0; r < T_.size(); ++r) {
                if (T_[r][c] <= 0) continue;
                if (best == T_.size()) best = r;
                const Whole here = times(T_[r].back(), T_[best][c]), there = times(T_[best].back(), T_[r][c]);
                if (here < there || (here == there && basic_[r] < basic_[best])) best = r;
            }
            if (best == T_.size()) return false;
            pivot(best, c, cost);
        }
    }

    /// Every entry becomes (entry · pivot − row · column) / last pivot: a division without rest.
    void pivot(std::size_t p, std::size_t c, std::vector<Whole>& cost)
    {
        const Whole by = T_[p][c];
        const auto eliminate = [&](std::vector<Whole>& line) {
            const Whole factor = line[c];
            for (std::size_t j = 0; j <= columns_; ++j)
                line[j] = (times(line[j], by) - times(factor, T_[p][j])) / denominator_;
        };
        for (std::size_t r = 0; r < T_.size(); ++r)
            if (r != p) eliminate(T_[r]);
        eliminate(cost);
        denominator_ = by;
        basic_[p] = c;
        if (denominator_ > 0) return;
        denominator_ = -denominator_;
        for (auto& line : T_)
            for (Whole& entry : line) entry = -entry;
        for (Whole& entry : cost) entry = -entry;
    }

    std::vector<std::vector<Whole>> T_;
    std::vector<std::size_t> basic_;
    std::size_t columns_ = 0;
    Whole denominator_ = 1;
    bool feasible_ = false;
};

/// Between which values a number runs over all answers.
struct Range {
    Wide least = infinity, most = -infinity;
    void add(Wide x) { least = std::min(least, x), most = std::max(most, x); }
    bool is_point() const
    {
        const Wide size = 1 + magnitude(most);
        return size < infinity && most - least <= 1e-24 * size;  // quotients of small whole numbers
    }
};

struct AllAnswers {
    bool any = false;
    std::vector<Range> lambda, w;

    Uniqueness uniqueness() const
    {
        if (!any) return Uniqueness::none;
        bool one_lambda = true, one_w = true;
        for (const Range& range : lambda) one_lambda = one_lambda && range.is_point();
        for (const Range& range : w) one_w = one_w && range.is_point();
        return one_lambda ? Uniqueness::unique : one_w ? Uniqueness::w_unique : Uniqueness::any;
    }
};

/// All answers of a problem whose numbers are whole; empty if a number on the way does not fit.
inline std::optional<AllAnswers> all_answers(const Mlcp& mlcp)
{
    const auto n = static_cast<std::size_t>(mlcp.size());
    const auto whole = [](Real x) { return static_cast<Whole>(x); };
    std::vector<std::vector<Whole>> A(n, std::vector<Whole>(n, 0));
    for (Index i = 0; i < mlcp.size(); ++i)
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
            A[static_cast<std::size_t>(i)][static_cast<std::size_t>(entry.col())] = whole(entry.value());
    AllAnswers found;
    found.lambda.resize(n);
    found.w.resize(n);
    std::vector<int> set(n, 0);  // 0 between, 1 at lo, 2 at hi
    try {
        for (;;) {
            bool possible = true;
            // λ = base + Σ x: one column for each x ≥ 0 that moves a λ or a w, or is a slack of a second bound.
            struct Column {
                std::size_t row;
                int sign;
            };
            std::vector<Column> moves_lambda, moves_w;
            std::vector<Whole> base(n, 0);
            std::vector<std::size_t> boxed;
            for (std::size_t k = 0; k < n && possible; ++k) {
                const auto i = static_cast<Index>(k);
                const bool below = mlcp.lo[i] > -infinity, above = mlcp.hi[i] < infinity,
                           pinned = mlcp.lo[i] == mlcp.hi[i];
                if (set[k] == 0) {
                    possible = !pinned;
                    base[k] = below ? whole(mlcp.lo[i]) : above ? whole(mlcp.hi[i]) : 0;
                    if (below || !above) moves_lambda.push_back({k, 1});
                    if (!below) moves_lambda.push_back({k, -1});
                    if (below && above) boxed.push_back(k);
                } else {
                    possible = set[k] == 1 ? below : above && !pinned;
                    if (!possible) break;
                    base[k] = whole(set[k] == 1 ? mlcp.lo[i] : mlcp.hi[i]);
                    if (set[k] == 1 || pinned) moves_w.push_back({k, 1});
                    if (set[k] == 2 || pinned) moves_w.push_back({k, -1});
                }
            }
            if (possible) {
                const std::size_t L = moves_lambda.size(), W = moves_w.size(), columns = L + W + boxed.size();
                std::vector<std::vector<Whole>> E;
                for (std::size_t r = 0; r < n; ++r) {  // A λ − w = −q
                    std::vector<Whole> line(columns + 1, 0);
                    line[columns] = -whole(mlcp.q[static_cast<Index>(r)]);
                    for (std::size_t k = 0; k < n; ++k) line[columns] -= A[r][k] * base[k];
                    for (std::size_t c = 0; c < L; ++c)
                        line[c] = A[r][moves_lambda[c].row] * moves_lambda[c].sign;
                    for (std::size_t c = 0; c < W; ++c)
                        if (moves_w[c].row == r) line[L + c] = -moves_w[c].sign;
                    E.push_back(line);
                }
                for (std::size_t b = 0; b < boxed.size(); ++b) {
                    std::vector<Whole> line(columns + 1, 0);
                    for (std::size_t c = 0; c < L; ++c)
                        if (moves_lambda[c].row == boxed[b]) line[c] = 1;
                    line[L + W + b] = 1;
                    const auto i = static_cast<Index>(boxed[b]);
                    line[columns] = whole(mlcp.hi[i]) - whole(mlcp.lo[i]);
                    E.push_back(line);
                }
                WholeSimplex simplex(E);
                if (simplex.feasible()) {
                    found.any = true;
                    const auto measure = [&](bool of_w, std::size_t k, Range& range, Wide offset) {
                        for (const int side : {1, -1}) {
                            std::vector<int> c(columns, 0);
                            const auto& moves = of_w ? moves_w : moves_lambda;
                            for (std::size_t m = 0; m < moves.size(); ++m)
                                if (moves[m].row == k) c[(of_w ? L : 0) + m] = side * moves[m].sign;
                            const auto most = simplex.largest(c);
                            range.add(most ? offset + side * *most : static_cast<Wide>(side * infinity));
                        }
                    };
                    for (std::size_t k = 0; k < n; ++k) {
                        measure(false, k, found.lambda[k], static_cast<Wide>(base[k]));
                        measure(true, k, found.w[k], 0);
                    }
                }
            }
            std::size_t k = 0;
            while (k < n && ++set[k] > 2) set[k++] = 0;
            if (k == n) return found;
        }
    } catch (const TooLarge&) {
        return std::nullopt;
    }
}

}  // namespace rigid::properties
