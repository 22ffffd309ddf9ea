/// \file one_row_step.hpp
/// One body and one row: a bead on a wire, a disc beside a rail. The five ways to repay at a glance, without
/// contacts, orders and substeps. stabilized_step.hpp is the same for a whole scene.
#pragma once

#include "chapters/07_baumgarte/projection.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"
#include "common/forces.hpp"

#include <array>

namespace rigid {

struct OneRowStep {
    std::vector<Row<2>> rows;
    ImpulseMemory<2> memory;
    Solution solution;
    VecX v;
    std::vector<Real> goal;
};

//! [one_row_step]
/// forces → u* → C, J → b → λ → u → x, for body 0 on one bilateral constraint.
/// \param constraint_at  C and J at given positions: Constraint<2> (const VecX& x)
template <class ConstraintAt>
void one_row_step(const ConstraintAt& constraint_at, const StabilizerSettings& settings, const Vec2& gravity,
                  Real h, Bodies<2>& bodies, OneRowStep& now)
{
    bodies.f.setZero();
    add_gravity(bodies, gravity);
    bodies.u += h * bodies.inverse_mass.cwiseProduct(bodies.f);

    const std::array<Constraint<2>, 1> constraint = {constraint_at(bodies.x)};
    const std::span<const Constraint<2>> constraints(constraint);
    stabilized_rows(constraints, 1, bodies.inverse_mass, settings, h, now.rows);  // b
    now.solution.lambda.setZero(1);
    sequential_impulse(now.rows, {}, {.max_sweeps = 1}, now.memory, bodies.u, now.solution);
    bodies.x += h * bodies.u;

    if (settings.method == Stabilizer::relaxation) {
        relax(constraints, {}, 1, settings, h, now.memory);
        bodies.u = now.memory.u;
    }
    if (settings.method == Stabilizer::split_impulse) {
        split_impulse(constraints, {}, 1, settings, h, now.memory, now.v);
        bodies.x += h * now.v;
    }
    if (settings.method == Stabilizer::projection)
        project_positions<2>([&](std::size_t, const VecX& x) { return constraint_at(x); }, 1, {}, 1,
                             bodies.inverse_mass, settings, h, now.goal, bodies.x);
}
//! [one_row_step]

}  // namespace rigid
