/// \file wrong_clamping.hpp
/// The mistake that the accumulated impulse is there to avoid: each correction is clamped by itself.
///
///     Δλ = clamp(−w / A_ii, lo, hi),   λ ← λ + Δλ
///
/// For a contact, Δλ ≥ 0: what a visit has given no later visit takes back. The first of two rows that help each
/// other gives too much, and the body leaves; see (6.9) to (6.12).
#pragma once

#include "chapters/06_sequential_impulse/impulse_method.hpp"

namespace rigid {

//! [wrong_visit]
/// A visit that clamps the correction. Right for a single row, wrong for two.
template <int Dof>
Real visit_clamping_the_correction(SolverRow<Dof>& row, VecX& u)
{
    const Vec<Dof> ua = u.template segment<Dof>(row.a);
    const Vec<Dof> ub = u.template segment<Dof>(row.b);
    const Real wanted = -row.mass * velocity(row, ua, ub);
    const Real change = std::min(std::max(wanted, row.lo), row.hi);  // the mistake
    row.lambda += change;
    u.template segment<Dof>(row.a) = ua + row.Wa * change;
    u.template segment<Dof>(row.b) = ub + row.Wb * change;
    return change;
}
//! [wrong_visit]

/// sequential_impulse() with that visit. It may come to rest, all visits giving nothing, at a wrong answer: then
/// the status is `iteration limit`, because the residual is not met.
template <int Dof>
void impulse_clamping_corrections(const std::vector<Row<Dof>>& rows,
                                  std::span<const int> order,
                                  const ImpulseSettings& settings,
                                  ImpulseMemory<Dof>& memory, VecX& u,
                                  Solution& solution)
{
    const bool hopeless =
        begin_sweeps(rows, order, settings.tolerance, memory, u, solution);
    const auto one_sweep = [&](int) {
        int off = 0;
        for (SolverRow<Dof>& row : memory.rows)
            off += !(std::abs(visit_clamping_the_correction(row, memory.u)) <=
                     settings.tolerance * row.mass);
        return off;
    };
    sweep_until(settings, hopeless, one_sweep, memory, solution);
    end_sweeps(order, memory, u, solution);
}

/// The solver stage with that mistake, or, with `wrong` = false, without it.
struct WrongClampingSolver : ImpulseSolver<2> {
    bool wrong = true;

    void solve(Bodies<2>& bodies, StepData<2>& now)
    {
        if (!wrong) return ImpulseSolver::solve(bodies, now);
        order_rows(now.rows, bodies.count(), ordering, random, colouring, order);
        for (const int k : now.active)
            bodies.velocity(k) = now.u_star.segment<2>(2 * k);
        impulse_clamping_corrections<2>(now.rows, order, sweeps, memory, bodies.u,
                                        now.solution);
        now.visits += memory.visits;
    }
};

struct WrongClampingMethod {
    AllPairs contacts;
    LeaveErrors correction;
    ColdStart start;
    WrongClampingSolver solver;
};

}  // namespace rigid
