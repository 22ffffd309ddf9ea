/// \file dantzig.hpp
/// Principal pivoting one row at a time: the drive of dantzig_drive.hpp as a solver.
#pragma once

#include "chapters/09_active_sets/active_sets.hpp"
#include "chapters/09_active_sets/dantzig_drive.hpp"

namespace rigid {

/// Solves an MLCP with a symmetric A, one row at a time. `iterations` counts pivots.
/// \throws std::invalid_argument  for a malformed problem, settings that make no sense, or an A that is not
///                                symmetric
inline void dantzig(const Mlcp& mlcp, const ActiveSetSettings& settings,
                    ActiveSetMemory& memory, Solution& solution)
{
    require_valid(mlcp);
    require_valid(settings);
    if (!mlcp.A.isCompressed()) {  // is_symmetric() reads the arrays of A
        Mlcp compressed = mlcp;
        compressed.A.makeCompressed();
        return dantzig(compressed, settings, memory, solution);
    }
    if (!is_symmetric(mlcp.A, memory.cursor))
        throw std::invalid_argument("A is not symmetric; Dantzig's method with L D "
                                    "Lᵀ needs A[i,j] = A[j,i]");
    memory.work = {};
    DantzigDrive drive(mlcp, settings.limit > 0
                                 ? settings.limit
                                 : 1000 + 10 * static_cast<int>(mlcp.size()));
    const DantzigDrive::Place place = drive.run();
    solution.uniqueness = Uniqueness::not_examined;
    const VecX driven = drive.lambda;
    if (place == DantzigDrive::Place::right) drive.refine();
    bool verified = verify_guess(mlcp, settings, drive.lambda, solution);
    // what was right already may not be any more
    if (!verified && place == DantzigDrive::Place::right) {
        drive.lambda = driven;
        verified = verify_guess(mlcp, settings, driven, solution);
    }
    if (!verified && place == DantzigDrive::Place::limit)
        solution.status = Status::iteration_limit;
    if (!verified && place == DantzigDrive::Place::ray)
        solution.status = proves_infeasibility(mlcp, drive.direction())
                              ? Status::infeasible
                              : Status::ray_termination;
    solution.iterations = drive.pivots;
    memory.work.flips = memory.work.single_flips = drive.pivots;
    memory.guess.lambda = drive.lambda;
    memory.guess.w = drive.w;
    memory.guess.wrong.clear();
    memory.cases = memory.guess.cases = drive.cases;
}

inline Solution dantzig(const Mlcp& mlcp, const ActiveSetSettings& settings = {})
{
    ActiveSetMemory memory;
    Solution solution;
    dantzig(mlcp, settings, memory, solution);
    return solution;
}

}  // namespace rigid
