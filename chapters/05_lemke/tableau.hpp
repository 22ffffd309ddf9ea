/// \file tableau.hpp
/// The tableau: every basic variable written in terms of those that are zero; the pivot; the ratio test.
///
///     y_B = r + T y_N        one line for each basic variable; where y_N = 0 its value is r
///
/// It starts as the question itself, w = q + d z0 + A z (5.5). A pivot swaps a basic variable with one that
/// was zero (5.8). This is the condensed tableau: the columns of the basic variables would be unit vectors,
/// so they are not stored, and n² numbers are worked on instead of 2n².
/// \cite cottle1992, §2.3 and §4.4
#pragma once

#include "common/math.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace rigid {

/// Who leaves when several basic variables reach zero together.
enum class TieRule { lexicographic, first_row, last_row };

/// What counts as nothing, relative to the numbers it is compared with. Section 5.6 has the evidence.
struct Tolerances {
    /// An entry below this share of the largest of its column is rounding error, not a slope. Anything from
    /// 1e-6 to 1e-12 gives the same answers; 1e-14 pivots on noise.
    Real pivot = 1e-10;
    /// Two ratios, or two terms of their perturbations, that differ by less than this share of their scale
    /// are equal. Anything from 1e-5 to 1e-8 serves; 1e-11 takes noise for order.
    Real tie = 1e-8;
};

struct Tableau {
    Tolerances tolerances;
    Index n = 0;
    MatX T;                       ///< n×(n + 2): a column for each y_N, then r
    std::vector<Index> basic;     ///< the variable of each row: z_i has the number i, w_i n + i, z0 2n
    std::vector<Index> nonbasic;  ///< the variable of each column
    std::vector<Index> place;     ///< of each variable: its column, or -1 - its row
    VecX column;                  ///< scratch: the multipliers of a pivot

    Tableau() = default;
    /// (5.5): w = q + d z0 + A z.
    Tableau(const MatX& A, const VecX& q, const VecX& d, const Tolerances& nothing = {})
        : tolerances(nothing), n(q.size()), T(n, n + 2), basic(size(n)), nonbasic(size(n + 1)),
          place(size(2 * n + 1)), column(n)
    {
        T.leftCols(n) = A;
        T.col(n) = d;
        T.col(n + 1) = q;
        for (Index i = 0; i < n; ++i) {
            put_row(i, n + i);
            put_column(i, i);
        }
        put_column(n, artificial());
    }

    Index artificial() const { return 2 * n; }
    Index complement(Index variable) const { return variable < n ? variable + n : variable - n; }
    bool is_basic(Index variable) const { return place[size(variable)] < 0; }
    Index row_of(Index variable) const { return -1 - place[size(variable)]; }
    Index column_of(Index variable) const { return place[size(variable)]; }
    auto values() const { return T.col(n + 1); }  ///< r, of the basic variables
    /// The value of any variable.
    Real value(Index variable) const { return is_basic(variable) ? T(row_of(variable), n + 1) : 0; }

    //! [pivot]
    /// (5.8): the basic variable of row p and the nonbasic one of column c change places.
    void pivot(Index p, Index c)
    {
        const Real inverse = -1 / T(p, c);
        column = T.col(c);
        column[p] = 0;
        T.col(c).setZero();
        T(p, c) = -1;
        Index first = 0, last = n;  // only rows first … last-1 can change
        while (first < last && column[first] == 0) ++first;
        while (last > first && column[last - 1] == 0) --last;
        for (Index j = 0; j < n + 2; ++j) {
            const Real multiplier = inverse * T(p, j);
            if (multiplier == 0) continue;  // a multiplier of zero changes nothing
            T.col(j).segment(first, last - first) += multiplier * column.segment(first, last - first);
            T(p, j) = multiplier;
        }
        const Index leaving = basic[size(p)];
        put_row(p, nonbasic[size(c)]);
        put_column(c, leaving);
    }
    //! [pivot]

    //! [ratio_test]
    /// (5.9): the row that reaches zero first while the variable of column c grows; -1 if none does: a ray.
    Index ratio_test(Index c, TieRule rule) const
    {
        const auto slope = T.col(c);
        const Real steepest = slope.cwiseAbs().maxCoeff();
        const Real falling = -tolerances.pivot * steepest;
        Real least = infinity;
        for (Index i = 0; i < n; ++i)
            if (slope[i] < falling) least = std::min(least, std::max(values()[i], Real{0}) / -slope[i]);
        if (!(least < infinity)) return -1;

        const Real limit = least + tolerances.tie * values().cwiseAbs().maxCoeff() / steepest;
        Index best = -1;
        for (Index i = 0; i < n; ++i) {
            if (!(slope[i] < falling) || values()[i] > -slope[i] * limit) continue;
            if (basic[size(i)] == artificial()) return i;  // z0 can go: that is the end of the walk
            if (best < 0 || rule == TieRule::last_row) best = i;
            else if (rule == TieRule::lexicographic && comes_before(i, best, c)) best = i;
        }
        return best;
    }
    //! [ratio_test]

    //! [lexicographic]
    /// (5.12): the coefficient of ε^k in basic variable i when each q_k is raised by ε^k.
    Real perturbation(Index i, Index k) const
    {
        const Index w = n + k;
        if (is_basic(w)) return row_of(w) == i ? 1 : 0;
        return -T(i, column_of(w));
    }
    /// True if row i reaches zero before row k as soon as the tie is broken by ε > ε² > … (5.13).
    bool comes_before(Index i, Index k, Index c) const
    {
        const auto scale = [&](Index row) {
            return std::max(Real{1}, T.row(row).head(n + 1).cwiseAbs().maxCoeff()) / -T(row, c);
        };
        const Real noise = tolerances.tie * std::max(scale(i), scale(k));
        for (Index j = 0; j < n; ++j) {
            const Real difference = perturbation(i, j) / -T(i, c) - perturbation(k, j) / -T(k, c);
            if (std::abs(difference) > noise) return difference < 0;
        }
        return false;
    }
    //! [lexicographic]

private:
    static std::size_t size(Index i) { return static_cast<std::size_t>(i); }

    void put_row(Index row, Index variable)
    {
        basic[size(row)] = variable;
        place[size(variable)] = -1 - row;
    }
    void put_column(Index c, Index variable)
    {
        nonbasic[size(c)] = variable;
        place[size(variable)] = c;
    }
};

}  // namespace rigid
