/// \file exact_method.hpp
/// The method of this chapter: the step with an exact solver.
///
/// Where the correction needs a second answer on the same rows it gets an exact one as well: with `split_impulse`
/// velocities and position errors are both solved exactly, apart.
///
///     w = A λ + J u* + b        → λ, u = u* + M⁻¹ Jᵀ λ
///     w = A Λ + β C'/h          → Λ, v = M⁻¹ Jᵀ Λ        C' = C + h J u, (7.13)
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/07_baumgarte/correction.hpp"
#include "chapters/09_active_sets/active_sets.hpp"

namespace rigid {

/// active_sets() as a solver of the MLCP that remembers which rows were active.
struct FindActiveSets {
    ActiveSetSettings settings;
    ActiveSetMemory memory;

    void operator()(const Mlcp& mlcp, Solution& solution)
    {
        active_sets(mlcp, settings, memory, solution);
    }
};

//! [exact_solver]
/// The solver stage: active sets for the velocities, and, with a memory of their
/// own, for the position errors.
struct ExactSolver : MatrixSolver<FindActiveSets> {
    static constexpr bool is_exact = true;

    /// both problems have the same A, and each its own active rows
    FindActiveSets errors;
    /// a residual below this is none [ℓ/s]; never less than what rounding makes,
    /// (9.21a)
    Real enough = 0;

    void require_valid() const
    {
        if (!(enough >= 0 && enough < infinity))
            throw std::invalid_argument(
                "the residual that is nothing is " + shortest(enough) +
                " lengths of the scene a second; it must be zero or positive, and "
                "finite");
        rigid::require_valid(find.settings);
    }

    template <int Dof>
    void solve(Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        if (now.substep == 0 && !now.second_half) unsolved = 0;
        // (9.21a)
        find.settings.enough =
            std::max(enough, rounded_speed(bodies.x, bodies.u, now.h) / now.length);
        MatrixSolver::solve(bodies, now);
        unsolved += now.solution.status != Status::solved;
    }
    template <int Dof>
    void solve_again(SecondProblem& second, Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        MatrixSolver::solve_again(second, bodies, now);
        unsolved += now.solution.status != Status::solved;
    }
    template <int Dof>
    void solve_apart(SecondProblem& second, VecX& v, StepData<Dof>& now)
    {
        errors.settings = find.settings;
        std::swap(errors, find);
        MatrixSolver::solve_apart(second, v, now);
        std::swap(errors, find);
        unsolved += second.solution.status != Status::solved;
    }
};
//! [exact_solver]

//! [method]
struct ExactMethod {
    AllPairs contacts;
    Correction correction;
    ColdStart start;  // not λ but the active rows are remembered, by the solver
    ExactSolver solver;
};
//! [method]

/// Small steps whose whole errors are corrected exactly: they leave no velocity, so nothing speaks against β = 1.
inline Correction exact_correction()
{
    Correction correction;
    correction.method = Stabilizer::split_impulse;
    correction.beta = 1;
    return correction;
}

// Compiled once, in exact_method.cpp.
extern template void step(DiscScene&, const StepSettings&, ExactMethod&,
                          StepData<2>&);

}  // namespace rigid
