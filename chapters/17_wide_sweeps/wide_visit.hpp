/// \file wide_visit.hpp
/// Chapter 6's visit, written once for a number and for lanes of numbers.
///
///     w = J u + b + γ λ,   λ' = clamp(λ − w / A_ii, lo − μ λ_n, hi + μ λ_n),   u ← u + M⁻¹ Jᵀ (λ' − λ)
///
/// (17.3). The sums are made in the order of chapter 6, so each lane has its bits. M⁻¹ Jᵀ is not kept but made where it is
/// needed: a large problem is read from memory in each sweep, and numbers are made sooner than read.
#pragma once

#include "chapters/17_wide_sweeps/lanes.hpp"

namespace rigid {

//! [row]
/// M⁻¹ of the two bodies of each lane, a diagonal [1/kg, 1/(kg m²)].
template <int Dof, class V>
struct LaneMasses {
    V a[Dof] = {}, b[Dof] = {};
};
/// One row of each lane: the numbers of a field lie side by side.
template <int Dof, class V>
struct WideRow {
    V Ja[Dof], Jb[Dof];  ///< blocks of J
    V bias;              ///< b [m/s]
    /// 1 / A_ii [kg]; 0 = no impulse changes this row
    V mass;
    V lo, hi;    ///< bounds of λ [N s]; of a row that another one bounds, zero
    V lambda;    ///< accumulated impulse [N s]
    V friction;  ///< μ of rows that another one bounds
    V softness;  ///< γ of rows that give way [1/kg]
};

/// What is the same in all lanes of a row.
struct RowShape {
    /// the row of this packet whose impulse bounds this one; −1 = none
    int bounding = -1;
    bool soft = false;  ///< one of the lanes gives way
};
//! [row]

/// λ within its bounds.
/// \param reach  μ λ_n; zero where no other row bounds this one
template <int Dof, class V>
inline V clamped(const WideRow<Dof, V>& row, const RowShape& shape, const V& reach,
                 const V& lambda)
{
    if (shape.bounding < 0) return at_most(at_least(lambda, row.lo), row.hi);
    const V lo = row.lo - reach, hi = row.hi + reach;
    return at_most(at_least(lambda, lo), hi);
}

/// u ← u + M⁻¹ Jᵀ Δλ
template <int Dof, class V>
void add_impulse(const WideRow<Dof, V>& row, const LaneMasses<Dof, V>& inverse,
                 const V& change, V (&ua)[Dof], V (&ub)[Dof])
{
    for (int d = 0; d < Dof; ++d) {
        const V Wa = inverse.a[d] * row.Ja[d], Wb = inverse.b[d] * row.Jb[d];
        ua[d] = ua[d] + Wa * change;
        ub[d] = ub[d] + Wb * change;
    }
}

//! [visit]
/// λ' of one row in each lane [N s], (17.3)
/// \param reach   μ λ_n; zero where no other row bounds this one
/// \param ua, ub  velocities of the two bodies [m/s]
template <int Dof, class V>
V wide_lambda(const WideRow<Dof, V>& row, const RowShape& shape, const V& reach,
              const V (&ua)[Dof], const V (&ub)[Dof])
{
    V w = row.Ja[0] * ua[0] + row.Jb[0] * ub[0];
    for (int d = 1; d < Dof; ++d) {
        const V more = row.Ja[d] * ua[d] + row.Jb[d] * ub[d];
        w = w + more;
    }
    if (shape.soft) {
        const V bias = row.bias + row.softness * row.lambda;
        w = bias + w;
    } else w = row.bias + w;
    const V wanted = row.lambda - row.mass * w;
    return clamped(row, shape, reach, wanted);
}

/// One visit of one row in each lane.
/// \return  λ' − λ [N s]
template <int Dof, class V>
V wide_visit(WideRow<Dof, V>& row, const RowShape& shape, const V& reach,
             const LaneMasses<Dof, V>& inverse, V (&ua)[Dof], V (&ub)[Dof])
{
    const V lambda = wide_lambda<Dof, V>(row, shape, reach, ua, ub);
    const V change = lambda - row.lambda;
    row.lambda = lambda;
    add_impulse<Dof, V>(row, inverse, change, ua, ub);
    return change;
}
//! [visit]

}  // namespace rigid
