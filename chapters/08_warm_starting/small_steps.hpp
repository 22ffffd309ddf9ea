/// \file small_steps.hpp
/// Many small steps, one sweep in each, every one warm: this chapter's step without what a scene of discs does not
/// need.
///
///     once:   contacts; which rows there are, their order, mass, bounds, where λ starts
///     n ×:    u += h g;  C, J, b;  u += M⁻¹ Jᵀ λ;  a sweep;  x += h u         (h: a substep)
///     once:   projection
///
/// The answer is that of step() by WarmMethod with the same substeps and sweeps and a projection at the end (no slop),
/// to rounding: a test checks that. Left out is what does not change within a step, and the way from
/// Constraint to Row to SolverRow: J, C and b are written where the sweep reads them. While the rows are
/// those of the previous step, no key is looked up and no colour chosen: λ is where it was. Restitution and a hand that pulls are that
/// method's alone; a scene with bends or joints is refused.
#pragma once

#include "chapters/08_warm_starting/small_step_rows.hpp"

#include <cmath>

namespace rigid {

/// Eight substeps: what this book proposes for scenes that move.
inline SmallStepSettings quick_steps() { return {}; }

/// Sixteen, and a first step from known impulses: for piles that should not even begin to sink.
SmallStepSettings careful_steps();

/// J and M⁻¹ Jᵀ of a row where the bodies are now.
/// \param rest  distance at which C = 0 [m]
/// \return      C [m]
Real refresh(const VecX& x, const VecX& inverse_mass, Real rest, SolverRow<2>& row);

/// What the impulse of a row does to its bodies, and bᵀλ, with λ J u of discs that nothing moves and that move.
void carry(std::size_t k, SmallStep& now);

/// C, J and b where the bodies are now, and what the remembered impulses do along
/// this J.
/// \param h  a substep [s]
void begin_substep(const Bodies<2>& bodies, Real h, SmallStep& now);

/// u becomes u* + s M⁻¹ Jᵀ λ with the multiple s of each group, (8.12): qᵀλ = bᵀλ +
/// Σ m u*·Δu, and λ J u of what nothing moves, λᵀAλ = Σ m Δu².
/// \param gain  h g [m/s]
void take_multiples(const MultipleRule& rule, const Vec2& gain, SmallStep& now);

/// Sweeps until no visit changes the velocity of its row by more than the tolerance. What they are slowest at is a
/// load that is too small or too large as a whole, so in between they go on from the best multiple of what they have.
/// \param sweeps  made before
/// \return        sweeps made in total
int first_sweeps(const SmallStepSettings& settings, int sweeps, SmallStep& now);

//! [small_steps]
/// One time step. Depends on its arguments alone.
inline void small_steps(DiscScene& scene, const SmallStepSettings& settings,
                        SmallStep& now)
{
    Bodies<2>& bodies = scene.bodies;
    const bool first_step = now.cache.h == 0;
    begin_rows(scene, settings, now);
    const Real h = settings.h / settings.substeps;
    const Vec2 gain = h * scene.gravity;
    now.u = bodies.u;
    now.change.setZero(now.u.size());
    now.sweeps = 0;

    for (int n = 0; n < settings.substeps; ++n) {
        begin_substep(bodies, h, now);
        take_multiples(settings.start, gain, now);
        for (std::size_t k = 0; k < now.rows.size(); ++k) {
            now.rows[k].lambda *= now.starts[now.group_of_row[k]].multiple;
            visit(now.rows[k], now.u);
        }
        int sweeps = first_step && n == 0 ? first_sweeps(settings, 1, now) : 1;
        for (; sweeps < settings.sweeps; ++sweeps)
            for (SolverRow<2>& row : now.rows) visit(row, now.u);
        now.sweeps += sweeps;
        bodies.x += h * now.u;
    }
    bodies.u = now.u;

    // The error goes out of x, row by row in the order that they were given: with
    // colours the last one would undo in its neighbours what the first had
    // corrected.
    const StabilizerSettings correction =
        in_metres(settings.correction, now.length);
    for (int s = 0; s < correction.correction_sweeps; ++s)
        for (const int k : now.place) {
            SolverRow<2>& row = now.rows[static_cast<std::size_t>(k)];
            const Real C = refresh(bodies.x, bodies.inverse_mass,
                                   now.rest[static_cast<std::size_t>(k)], row);
            const ConstraintKind kind =
                row.lo < 0 ? ConstraintKind::bilateral : ConstraintKind::unilateral;
            const Real repaid =
                settings.h * baumgarte_bias(C, kind, correction, settings.h);
            if (repaid == 0) continue;
            bodies.x.segment<2>(row.a) -= row.Wa * (row.mass * repaid);
            bodies.x.segment<2>(row.b) -= row.Wb * (row.mass * repaid);
        }
}
//! [small_steps]

}  // namespace rigid
