/// \file xpbd.hpp
/// Extended position-based dynamics: the soft row, with C and J where the bodies are at each visit.
///
///     x ← x₀ + h u*
///     repeat   ΔΛ = −(r(x) + γ Λ)/(J M⁻¹ Jᵀ + γ),   Λ clamped,   x ← x + M⁻¹ Jᵀ ΔΛ       (16.21)
///     u ← (x − x₀)/h;   contacts that pushed: w = J u becomes that of a bounce, or 0
///
/// γ is what its papers call α/h², the compliance over h²; hard rows have γ = 0. \cite macklin2016 \cite muller2020
/// In place of the papers' friction in two parts, |Λ_t| ≤ μ Λ_n as in chapter 13.
#pragma once

#include "chapters/06_sequential_impulse/restitution.hpp"
#include "chapters/16_soft_constraints/position_rows.hpp"

namespace rigid {

//! [xpbd]
/// The correction stage; the solver stage is FreeVelocities.
/// Its rows are those of sweeps over velocities that leave errors alone: γ, the
/// bounds, and b of a bounce.
struct Xpbd : LeaveErrors {
    int sweeps = 1;
    /// false: what pushes an overlap out stays as velocity
    bool velocity_pass = true;

    // What is kept from step to step.
    VecX x0;    ///< positions at the start of the sub-step [m]
    VecX d;     ///< x − x₀ [m]
    VecX sums;  ///< Λ of each row [N s²]

    void require_valid() const
    {
        LeaveErrors::require_valid();
        if (sweeps < 0)
            throw std::invalid_argument("the number of sweeps is " +
                                        std::to_string(sweeps) +
                                        "; it must be zero or positive");
    }

    template <class Scene, class Solver>
    void move(Scene& scene, const StepSettings& settings, Solver&,
              StepData<Scene::dof>& now)
    {
        constexpr int Dof = Scene::dof;
        auto& bodies = scene.bodies;
        const Real h = settings.part();
        x0 = bodies.x;
        advance_positions(bodies, h, now);
        d = bodies.x - x0;
        sums.setZero(static_cast<Index>(now.rows.size()));
        for (int s = 0; s < sweeps; ++s)
            for (std::size_t i = 0; i < now.rows.size(); ++i) {
                now.constraints[i] = constraint_at(scene, now, i, bodies.x);
                visit<Dof>(i, h, now, bodies);
            }
        now.visits += static_cast<std::int64_t>(now.rows.size()) * sweeps;
        for (const int k : now.active)
            bodies.velocity(k) = d.template segment<Dof>(Dof * k) / h;
        now.solution.lambda = sums / h;
        if (velocity_pass) pass_velocities(now, bodies);
    }

    /// (16.21)
    template <int Dof>
    void visit(std::size_t i, Real h, const StepData<Dof>& now, Bodies<Dof>& bodies)
    {
        const Constraint<Dof>& c = now.constraints[i];
        const Row<Dof>& bounds = now.rows[i];
        const Row<Dof> row = bilateral(c, bodies.inverse_mass);
        const Real A = row.inverse_effective_mass(), gamma = bounds.softness;
        if (!(A > 0)) return;
        Real& sum = sums[static_cast<Index>(i)];
        const Real r = position_residual(c, along(c, d), h);
        Real lo = h * bounds.lo, hi = h * bounds.hi;
        if (bounds.bounded_by >= 0) {
            hi = bounds.friction * std::max(Real{0}, sums[bounds.bounded_by]);
            lo = -hi;
        }
        const Real next = std::clamp(sum - (r + gamma * sum) / (A + gamma), lo, hi);
        row.apply(next - sum, bodies.x);
        row.apply(next - sum, d);
        sum = next;
    }
    //! [xpbd]

    //! [velocity_pass]
    /// Contacts that pushed part at the speed of their bounce, else not at all: what
    /// pushed an overlap out is no velocity.
    template <int Dof>
    void pass_velocities(StepData<Dof>& now, Bodies<Dof>& bodies) const
    {
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const Constraint<Dof>& c = now.constraints[i];
            Real& lambda = now.solution.lambda[static_cast<Index>(i)];
            if (!c.bounces || !(lambda > 0)) continue;
            Row<Dof> row = bilateral(c, bodies.inverse_mass);
            row.bias =
                std::min(Real{0}, now.rows[i].bias);  // −e times the approach
            const Real A = row.inverse_effective_mass();
            if (!(A > 0)) continue;
            const Real change = -row.velocity(bodies.u) / A;
            row.apply(change, bodies.u);
            lambda += change;
        }
    }
    //! [velocity_pass]
};

}  // namespace rigid
