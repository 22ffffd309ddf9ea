/// \file island_solver.hpp
/// The rows of one island, and nothing else: by chapter 6's visits until the residual is small, or, where there are
/// few, exactly by chapter 9.
///
///     stop when r ≤ tolerance,   r = max_i r_i the natural residual (3.15) of this island
///
/// An island that is at rest starts from the previous λ and stops after one sweep; its neighbour that is hit goes on.
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

//! [sweep_island]
/// Sweeps over the rows of one island from their present λ, whose effect is in u
/// already. With tolerance 0 all sweeps are made, or until one changes nothing.
/// \param feedback  of the rows; empty = none of them has any
/// \param u         Dof·K; changed where the rows move something [m/s]
template <int Dof>
IslandAnswer sweep_island(std::span<SolverRow<Dof>> rows,
                          std::span<const Feedback> feedback,
                          const ImpulseSettings& settings, VecX& u)
{
    IslandAnswer answer;
    int changed = 1;
    while (answer.sweeps < settings.max_sweeps && changed > 0) {
        changed = sweep(rows, feedback, u, settings.tolerance,
                        settings.alternate && answer.sweeps % 2 == 1);
        ++answer.sweeps;
        answer.visits += static_cast<std::int64_t>(rows.size());

        // A small change is no small residual (chapter 4): it only says that it is
        // time to look.
        if (!(settings.tolerance > 0) ||
            (changed > 0 && answer.sweeps < settings.max_sweeps))
            continue;
        take_all_bounds(rows, feedback);
        answer.residual = natural_residual<Dof>(rows, u);
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

}  // namespace rigid
