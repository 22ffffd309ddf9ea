/// \file projection.hpp
/// Non-linear Gauss-Seidel on the positions: visit row after row, compute C where the bodies are now, and move
/// them to where C has reached the goal of this step.
///
///     x ← x + M⁻¹ Jᵀ Λ,   Λ = (goal − C(x)) / (J M⁻¹ Jᵀ),   goal = (1 − β) C at the start
///
/// (7.14). No velocity is touched. C and J are computed again at each visit, so the rows follow the curve and not its
/// tangent. The goal keeps β's meaning: the part that one step corrects, however many sweeps it makes.
#pragma once

#include "chapters/07_baumgarte/stabilization.hpp"

#include <cmath>
#include <cstdint>

namespace rigid {

//! [projection]
/// Moves positions until each row is at its goal or the sweeps are used up.
/// \param evaluate      constraint i at given positions: Constraint<Dof>
///                      (std::size_t i, const VecX& x)
/// \param count         number of constraints
/// \param inverse_mass  [1/kg]
/// \param h             time step [s]: a visit that moves a row by less than h
///                      times the tolerance moves nothing
/// \param goal          memory for one number a row [m]
/// \param x             positions [m]; changed
/// \return              rows visited, the first look at C included
template <int Dof, class Evaluate>
std::int64_t project_positions(const Evaluate& evaluate, std::size_t count,
                               const VecX& inverse_mass,
                               const StabilizerSettings& settings, Real h,
                               std::vector<Real>& goal, VecX& x)
{
    bool done = true;
    goal.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Constraint<Dof> c = evaluate(i, x);
        const Real repaid = h * baumgarte_bias(c.C, c.kind, settings, h);
        goal[i] =
            c.kind == ConstraintKind::unilateral && c.C > 0 ? 0 : c.C - repaid;
        done = done && std::abs(repaid) <= h * settings.tolerance;
    }
    int sweep = 0;
    for (; sweep < settings.correction_sweeps && !done; ++sweep) {
        done = true;
        for (std::size_t i = 0; i < count; ++i) {
            const Constraint<Dof> c = evaluate(i, x);
            if (!has_error(c.kind)) continue;
            const Real missing = goal[i] - c.C;
            if (c.kind == ConstraintKind::bilateral
                    ? std::abs(missing) <= h * settings.tolerance
                    : missing <= h * settings.tolerance)
                continue;
            const Row<Dof> row = bilateral(c, inverse_mass);
            const Real A = row.inverse_effective_mass();
            if (!(A > 0)) continue;
            row.apply(missing / A, x);  // (7.14)
            done = false;
        }
    }
    return static_cast<std::int64_t>(count) * (sweep + 1);
}
//! [projection]

}  // namespace rigid
