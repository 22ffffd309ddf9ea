/// \file projection.hpp
/// Non-linear Gauss-Seidel on the positions: visit row after row, look at C where the bodies are now, and move
/// them so that the part β of the error is gone.
///
///     x ← x + M⁻¹ Jᵀ Λ,   Λ = −β C(x) / (J M⁻¹ Jᵀ)
///
/// No velocity is touched. C and J are computed anew at each visit, so the rows see the curve and not its tangent.
#pragma once

#include "chapters/07_baumgarte/stabilization.hpp"

#include <cmath>

namespace rigid {

/// Moves positions until the errors are gone or the sweeps are used up.
/// \param evaluate      constraint i at given positions: Constraint<Dof> (std::size_t i, const VecX& x)
/// \param count         number of constraints
/// \param order         of the visits; empty = as they are
/// \param links         the first `links` of them are bilateral
/// \param inverse_mass  [1/kg]
/// \param h             time step: it and `fastest` bound what one visit moves [s]
/// \param x             positions [m]; changed
/// \return              rows visited
template <int Dof, class Evaluate>
std::int64_t project_positions(const Evaluate& evaluate, std::size_t count, std::span<const int> order,
                               std::size_t links, const VecX& inverse_mass,
                               const StabilizerSettings& settings, Real h, VecX& x)
{
    std::int64_t visits = 0;
    for (int sweep = 0; sweep < settings.repaying_sweeps; ++sweep) {
        bool moved = false;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = order.empty() ? k : static_cast<std::size_t>(order[k]);
            const Constraint<Dof> c = evaluate(i, x);
            const Real distance = h * baumgarte_bias(c.C, i < links, settings, h);  // β C, bounded
            if (distance == 0) continue;
            const Row<Dof> row = bilateral(c, inverse_mass);
            const Real A = row.compliance();
            if (!(A > 0)) continue;
            row.apply(-distance / A, x);
            moved = true;
        }
        visits += static_cast<std::int64_t>(count);
        if (!moved) break;
    }
    return visits;
}

}  // namespace rigid
