/// \file position_rows.hpp
/// A row in positions: what is left of it at x, and its solver stage, which leaves all to the positions.
///
///     h (J u + b + γ λ) = r(x) + γ Λ,   Λ = h λ                                         (16.20)
///     joint, contact    r = C(x)
///     spring            r = p C(x) + (1 − p) J (x − x₀),   p = h k/(h k + c)
///     motor, friction   r = J (x − x₀) − h speed
///
/// x₀ is where the bodies were at the start of the sub-step. XPBD sweeps these rows, block descent their energies.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"

namespace rigid {

//! [residual]
/// r(x) of (16.20) [m].
/// \param c      the constraint at x
/// \param moved  J (x − x₀) [m]
template <int Dof>
Real position_residual(const Constraint<Dof>& c, Real moved, Real h)
{
    if (has_error(c.kind)) return c.C;
    if (c.kind != ConstraintKind::spring) return moved - h * c.speed;
    const Real part = h * c.stiffness / (h * c.stiffness + c.damping);
    return part * c.C + (1 - part) * moved;
}
//! [residual]

/// J d of a constraint for a small motion d of all bodies [m].
template <int Dof>
Real along(const Constraint<Dof>& c, const VecX& d)
{
    Real sum = c.Jb.dot(d.template segment<Dof>(Dof * c.b));
    if (c.a != world) sum += c.Ja.dot(d.template segment<Dof>(Dof * c.a));
    return sum;
}

/// The solver stage of methods that find positions first: u = u*.
struct FreeVelocities : PlainSolver {
    template <int Dof>
    void solve(Bodies<Dof>& bodies, StepData<Dof>& now) const
    {
        for (const int k : now.active)
            bodies.velocity(k) = now.u_star.template segment<Dof>(Dof * k);
        now.solution.status = Status::iteration_limit;
        now.solution.residual = infinity;
    }
};

}  // namespace rigid
