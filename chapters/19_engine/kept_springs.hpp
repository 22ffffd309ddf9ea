/// \file kept_springs.hpp
/// The rows of springs in the engine: what a step resolves keeps its swing.
///
///     λ = −h (k C + h k/4 (w' − w) + c w'),   w = J u before the step, w' after it     where h² k A ≤ 1            (19.2)
///     λ = −h (k C + h k w' + c w')                                                    (16.8), elsewhere
///
/// A = J M⁻¹ Jᵀ. The force at the end of the step, (16.8), takes a part of h² ω² of a swing's energy in each step, whatever its
/// damping: of 0.2 m at 10 rad/s 5 mm are left in the fifth second. With a quarter of it, and what w was taken off, a mass on a
/// spring without damping turns by the same angle in each step and keeps its amplitude, as (x, u) ↦ (x', u') has the determinant
/// 1; c is taken as before. It is the trapezoidal rule of positions that are half a step later than velocities. A swing of less
/// than six steps, h ω > 1, no step resolves: it is damped.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"

namespace rigid {

//! [kept_springs]
/// Writes γ and b of the springs among the rows of a step.
inline void keep_springs(const Bodies<3>& bodies, Real h, StepData<3>& now)
{
    for (std::size_t i = 0; i < now.rows.size(); ++i) {
        const Constraint<3>& c = now.constraints[i];
        if (c.kind != ConstraintKind::spring) continue;
        Row<3>& row = now.rows[i];
        const Real k = c.stiffness,
                   stiff = h * h * k * row.inverse_effective_mass();
        const Real part = stiff <= 1 ? h * k / 4 : h * k, whole = part + c.damping;
        row.bias = 0;
        const Real w = stiff <= 1 ? row.velocity(bodies.u) : 0;
        row.bias = (k * c.C - part * w) / whole;
        row.softness = 1 / (h * whole);
    }
}
//! [kept_springs]

}  // namespace rigid
