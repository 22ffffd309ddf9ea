/// \file island_solver.hpp
/// The rows of one island, and nothing else: by chapter 6's visits until the residual is small, or, where there are
/// few, exactly by chapter 9.
///
///     stop when r ≤ tolerance,   r = max_i r_i the natural residual (3.15) of this island
///
/// An island that is at rest starts from yesterday's λ and stops after one sweep; its neighbour that is hit goes on.
#pragma once

#include "chapters/06_sequential_impulse/sequential_impulse.hpp"

#include <cstdint>
#include <span>

namespace rigid {

struct IslandAnswer {
    Status status = Status::iteration_limit;
    int sweeps = 0;
    Real residual = infinity;  ///< computed if the tolerance is positive [m/s]
    std::int64_t visits = 0;   ///< rows visited, those of residuals included
};

/// The natural residual of these rows [m/s].
template <int Dof>
Real natural_residual(std::span<const SolverRow<Dof>> rows, const VecX& u)
{
    Real largest = 0;
    for (const SolverRow<Dof>& row : rows) {
        const Real w = velocity<Dof>(row, u.template segment<Dof>(row.a), u.template segment<Dof>(row.b));
        const Real r = natural_residual_row(row.mass > 0 ? 1 / row.mass : 0, row.lambda, w, row.lo, row.hi);
        if (!(r <= largest)) largest = r;  // also takes over a NaN
        if (std::isnan(largest)) break;
    }
    return largest;
}

//! [sweep_island]
/// Sweeps over the rows of one island from their present λ, whose effect is in u already. With tolerance 0 all
/// sweeps are made, or until one changes nothing.
/// \param u  Dof·K; changed where the rows move something [m/s]
template <int Dof>
IslandAnswer sweep_island(std::span<SolverRow<Dof>> rows, const ImpulseSettings& settings, VecX& u)
{
    IslandAnswer answer;
    int changed = 1;
    while (answer.sweeps < settings.max_sweeps && changed > 0) {
        changed = 0;
        const auto visit_and_see = [&](SolverRow<Dof>& row) {
            changed += !(std::abs(visit(row, u)) <= settings.tolerance * row.mass);  // a NaN counts
        };
        if (settings.alternate && answer.sweeps % 2 == 1)
            for (std::size_t k = rows.size(); k-- > 0;) visit_and_see(rows[k]);
        else
            for (SolverRow<Dof>& row : rows) visit_and_see(row);
        ++answer.sweeps;
        answer.visits += static_cast<std::int64_t>(rows.size());

        // A small change is no small residual (chapter 4): it only says that it is time to look.
        if (!(settings.tolerance > 0) || (changed > 0 && answer.sweeps < settings.max_sweeps)) continue;
        answer.residual = natural_residual(std::span<const SolverRow<Dof>>(rows), u);
        answer.visits += static_cast<std::int64_t>(rows.size());
        if (answer.residual <= settings.tolerance) {
            answer.status = Status::solved;
            break;
        }
        changed = 1;
    }
    return answer;
}
//! [sweep_island]

/// Chapter 6's sweep_on() for the rows of one island: until a sweep finds no row off by more than the tolerance.
/// \return  rows visited
template <int Dof>
std::int64_t sweep_on(std::span<SolverRow<Dof>> rows, int max_sweeps, Real tolerance, VecX& u)
{
    std::int64_t visits = 0;
    for (int sweeps = 0, changed = 1; sweeps < max_sweeps && changed > 0; ++sweeps) {
        changed = 0;
        for (SolverRow<Dof>& row : rows) changed += !(std::abs(visit(row, u)) <= tolerance * row.mass);
        visits += static_cast<std::int64_t>(rows.size());
    }
    return visits;
}

}  // namespace rigid
