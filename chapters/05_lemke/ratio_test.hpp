/// \file ratio_test.hpp
/// Which variable leaves: the basic one that reaches zero first, and the rule for several that do so together.
///
///     least of r_i / -T_ic over the rows with T_ic < 0
///
/// \cite murty1997, §2.2 (the ratio test) and §2.2.8 (the lexicographic rule)
#pragma once

#include "chapters/05_lemke/tableau.hpp"

#include <algorithm>
#include <vector>

namespace rigid {

/// Which one leaves when several basic variables reach zero together.
enum class TieRule { lexicographic, first_row, last_row };

/// Keeps the row that reaches zero first when each q_k is raised by ε^k, ε > ε² > …
/// (5.13). The coefficient of ε^k in row i is 1 if w_k is the basic variable of
/// that row, else -T_ik, k being the column of w_k (5.12).
void break_tie(const Tableau& tableau, Index c, std::vector<Index>& tied);

//! [ratio_test]
/// (5.10): the row that reaches zero first while the variable of column c grows; -1
/// if none does: a ray.
inline Index ratio_test(const Tableau& tableau, Index c, TieRule rule)
{
    const Index n = tableau.n;
    const Tolerances& tolerances = tableau.tolerances;
    const auto slope = tableau.column(c), r = tableau.values();
    const Real steepest = slope.cwiseAbs().maxCoeff();
    const Real falling = -tolerances.pivot * steepest;
    const auto ratio = [&](Index i) { return std::max(r[i], Real{0}) / -slope[i]; };
    Real least = infinity;
    for (Index i = 0; i < n; ++i)
        if (slope[i] < falling) least = std::min(least, ratio(i));
    if (!(least < infinity)) return -1;

    const Real limit = least + tolerances.tie * r.cwiseAbs().maxCoeff() / steepest;
    std::vector<Index> tied;
    for (Index i = 0; i < n; ++i) {
        if (!(slope[i] < falling) || ratio(i) > limit) continue;
        if (tableau.basic[static_cast<std::size_t>(i)] == tableau.artificial())
            return i;  // z0 can go: that is the end of the walk
        tied.push_back(i);
    }
    if (rule == TieRule::lexicographic && tied.size() > 1)
        break_tie(tableau, c, tied);
    return rule == TieRule::last_row ? tied.back() : tied.front();
}
//! [ratio_test]

}  // namespace rigid
