/// \file row_residual.hpp
/// How far λ and u are from an answer, on some rows of a step: in m/s, whatever the rows are.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"

#include <span>

namespace rigid {

/// The natural residual of λ and u on these rows, with the bounds that λ sets [m/s], (3.15). A row that only turns, in
/// rad/s, is taken at the distance ℓ; one that takes its bounds from another is a speed already (13.3).
/// \param count   how many rows are looked at
/// \param number  int(int): which they are
template <int Dof, class Number>
Real natural_residual(const std::vector<Row<Dof>>& rows, int count,
                      const Number& number, const VecX& lambda, const VecX& u,
                      Real length)
{
    Real largest = 0;
    for (int k = 0; k < count; ++k) {
        const int i = number(k);
        const Row<Dof>& row = rows[static_cast<std::size_t>(i)];
        const auto [lo, hi] = bounds_of(row, lambda);
        const Real w = row.velocity(u) + row.softness * lambda[i];
        Real r = natural_residual_row(row.diagonal(), lambda[i], w, lo, hi);
        if constexpr (Dof > 2) {
            constexpr int ways = Dof == 3 ? 2 : 3;  // the others are angles
            if (row.bounded_by < 0 && row.Ja.template head<ways>().isZero(0) &&
                row.Jb.template head<ways>().isZero(0))
                r *= length;
        }
        if (!(r <= largest)) largest = r;  // also takes over a NaN
        if (std::isnan(largest)) return largest;
    }
    return largest;
}

/// Of all of them.
template <int Dof>
Real natural_residual(const std::vector<Row<Dof>>& rows, const VecX& lambda,
                      const VecX& u, Real length)
{
    return natural_residual(
        rows, static_cast<int>(rows.size()), [](int k) { return k; }, lambda, u,
        length);
}

/// Of some rows of a step.
template <int Dof>
Real natural_residual(const StepData<Dof>& now, std::span<const int> rows,
                      const VecX& u)
{
    return natural_residual(
        now.rows, static_cast<int>(rows.size()),
        [rows](int k) { return rows[static_cast<std::size_t>(k)]; },
        now.solution.lambda, u, now.length);
}

}  // namespace rigid
