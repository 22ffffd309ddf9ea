/// \file exact_step.hpp
/// A step of small steps whose velocities and whose position errors are both solved exactly.
///
///     once:  contacts
///     n ×:   u* = u + h M⁻¹ f;   rows with b = 0, a gap with b = C/h
///            w = A λ + J u* + b          → λ, u = u* + M⁻¹ Jᵀ λ
///            w = A Λ + β C'/h            → Λ, v = M⁻¹ Jᵀ Λ        C' = C + h J u, (7.17)
///            x += h (u + v),   v is forgotten                     (h: a substep)
///
/// Chapter 7's split impulse, with an exact answer in the place of its sweeps. Both problems have the same A, and
/// each its own memory of which rows were active.
#pragma once

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/07_baumgarte/stabilized_step.hpp"
#include "chapters/09_active_sets/active_sets.hpp"

namespace rigid {

/// Whole errors are repaid: they leave no velocity, so nothing speaks against β = 1.
inline StabilizedStepSettings exact_step_settings()
{
    StabilizedStepSettings settings;
    settings.stabilizer.method = Stabilizer::split_impulse;
    settings.stabilizer.beta = 1;
    settings.substeps = 4;
    return settings;
}

/// What the step finds on its way. `solution` holds the λ of the last substep, `repaying` its Λ.
struct ExactStep : StabilizedStep {
    AssemblyScratch scratch;
    Mlcp mlcp;                ///< of the velocities
    Mlcp errors;              ///< of the positions: the same A
    ActiveSetMemory active, active_errors;
    Solution repaying;
    Status status = Status::solved;  ///< of all problems of a step: the first that is not `solved`
};

//! [errors]
/// (7.17) as a problem of its own: v starts from zero, so q = b = β C'/h, and the gap that is left may close.
inline void error_problem(std::size_t links, const StabilizerSettings& stabilizer, Real h, const VecX& u,
                          ExactStep& now)
{
    now.errors.A = now.mlcp.A;
    now.errors.lo = now.mlcp.lo;
    now.errors.hi = now.mlcp.hi;
    now.errors.q.setZero(now.mlcp.size());
    for (std::size_t i = 0; i < now.constraints.size(); ++i) {
        const Real C = now.constraints[i].C + h * now.rows[i].velocity(u);
        now.errors.q[static_cast<Index>(i)] =
            i >= links && C > 0 ? C / h : baumgarte_bias(C, i < links, stabilizer, h);
    }
}
//! [errors]

//! [step]
/// One time step. Depends on its arguments alone. Any stabiliser but `relaxation` and `projection` has its meaning;
/// with `split_impulse` errors are repaid exactly.
inline void exact_step(DiscScene& scene, const StabilizedStepSettings& settings,
                       const ActiveSetSettings& exactness, ExactStep& now)
{
    find_step_contacts(scene, settings, now);
    const Real h = settings.h / settings.substeps;
    Bodies<2>& bodies = scene.bodies;
    ActiveSetSettings exact = exactness;
    now.status = Status::solved;
    const auto keep_status = [&now](Status status) {
        if (now.status == Status::solved) now.status = status;
    };
    for (int n = 0; n < settings.substeps; ++n) {
        substep_rows(scene, settings, h, now);  // chapter 7, word for word
        assemble(now.rows, now.u_star, now.scratch, now.mlcp);
        exact.enough = std::max(exactness.enough, rounded_speed(bodies.x, now.u_star, h));
        active_sets(now.mlcp, exact, now.active, now.solution);
        keep_status(now.solution.status);
        bodies.u = now.u_star;
        apply(now.rows, now.solution.lambda, bodies.u);
        bodies.x += h * bodies.u;
        if (settings.stabilizer.method != Stabilizer::split_impulse) continue;
        error_problem(scene.links.size(), settings.stabilizer, h, bodies.u, now);
        active_sets(now.errors, exact, now.active_errors, now.repaying);
        keep_status(now.repaying.status);
        now.v.setZero(bodies.u.size());
        apply(now.rows, now.repaying.lambda, now.v);
        bodies.x += h * now.v;
    }
}
//! [step]

}  // namespace rigid
