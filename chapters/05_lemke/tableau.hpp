/// \file tableau.hpp
/// The tableau: every basic variable in terms of those that are zero; the pivot.
///
///     y_B = r + T y_N        one line for each basic variable; where y_N = 0 its value is r
///
/// It starts as the problem itself, w = q + d z0 + A z (5.5). A pivot swaps a basic variable with one that
/// was zero (5.8). This is the condensed tableau: the columns of the basic variables would be unit vectors
/// and are not stored. And a column is only brought up to date when it is needed: most never enter.
/// \cite cottle1992, §2.3 and §4.4
#pragma once

#include "common/math.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace rigid {

/// What counts as zero, relative to the numbers it is compared with. Section 5.C has the evidence.
struct Tolerances {
    /// An entry below this share of the largest of its column is rounding error, not a slope. Anything from
    /// 1e-6 to 1e-12 gives the same answers; 1e-14 pivots on rounding errors.
    Real pivot = 1e-10;
    /// Two ratios, or two terms of their perturbations, that differ by less than this share of their scale
    /// are equal. Anything from 1e-5 to 1e-8 serves; at 1e-11 rounding errors decide.
    Real tie = 1e-8;
};

struct Tableau {
    Tolerances tolerances;
    Index n = 0;
    /// the variable of each row: z_i has the number i, w_i n + i, z0 2n
    std::vector<Index> basic;
    std::vector<Index> nonbasic;  ///< the variable of each column
    /// of each variable: its column, or -1 - its row
    std::vector<Index> place;
    mutable long column_updates = 0;  ///< how often a pivot was applied to a column

    Tableau() = default;
    /// (5.5): w = q + d z0 + A z.
    Tableau(const MatX& A, const VecX& q, const VecX& d,
            const Tolerances& nothing = {});

    Index artificial() const { return 2 * n; }
    Index complement(Index variable) const
    {
        return variable < n ? variable + n : variable - n;
    }
    bool is_basic(Index variable) const { return place[size(variable)] < 0; }
    Index row_of(Index variable) const { return -1 - place[size(variable)]; }
    Index column_of(Index variable) const { return place[size(variable)]; }
    /// A column of T.
    auto column(Index j) const
    {
        bring_up_to_date(j);
        return std::as_const(T_).col(j).head(n);
    }
    auto values() const { return column(n + 1); }  ///< r, of the basic variables
    /// The value of any variable.
    Real value(Index variable) const
    {
        return is_basic(variable) ? values()[row_of(variable)] : 0;
    }
    /// All of [T r].
    MatX entries() const
    {
        for (Index j = 0; j < n + 2; ++j) bring_up_to_date(j);
        return T_.topRows(n);
    }

    /// (5.8): the basic variable of row p and the nonbasic one of column c change
    /// places. Here the pivot is only recorded: its row, -1/T_pc, and its column
    /// with a zero for T_pc.
    void pivot(Index p, Index c);

    /// (5.8) for one column: applies the pivots that were not yet applied to it.
    void bring_up_to_date(Index j) const;

private:
    struct PastPivot {
        Index row;
        Real inverse;        ///< -1/T_pc
        Index first, count;  ///< the rows that it changes
    };
    /// numbers in a cache line: every column starts at one
    static constexpr Index line = 8;

    static std::size_t size(Index i) { return static_cast<std::size_t>(i); }
    static Index whole_lines(Index rows) { return (rows + line - 1) / line * line; }

    /// Applies all pivots to all columns: from then on they are not needed.
    void forget()
    {
        for (Index j = 0; j < n + 2; ++j) bring_up_to_date(j);
        pivots_.clear();
        applied_.assign(applied_.size(), 0);
    }

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

    /// n rows, and zeros to fill the cache lines; a column for each y_N, then r
    mutable MatX T_;
    MatX U_;  ///< the columns of the past pivots
    std::vector<PastPivot> pivots_;
    /// how many of them were applied to each column of T_
    mutable std::vector<std::size_t> applied_;
};

}  // namespace rigid
