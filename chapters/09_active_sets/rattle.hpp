/// \file rattle.hpp
/// The correction stage whose repair does no work at second order: RATTLE, with contacts.
///
///     u½ = u + (h/2) M⁻¹ f(x) + M⁻¹ J(x)ᵀ λ,     x' = x + h u½,   C(x') = goal
///     u' = u½ + (h/2) M⁻¹ f(x') + M⁻¹ J(x')ᵀ μ,  J(x') u' = 0
///
/// (9.24), (9.25): half of the forces, a move onto C = 0 along M⁻¹ Jᵀ of its start, the other half, and a velocity that
/// keeps to the rows where the bodies now are. \cite andersen1983 \cite ryckaert1977 \cite hairer2006, §VII.1.4
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/06_sequential_impulse/restitution.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"
#include "chapters/09_active_sets/exact_method.hpp"
#include "chapters/09_active_sets/rattle_settings.hpp"

namespace rigid {

struct Rattle : RattleSettings, Restitution, PlainCorrection {
    // Of the last step.
    /// of Newton's method, in the sub-step that needed the most
    int iterations = 0;
    int not_converged = 0;  ///< sub-steps whose positions did not meet C
    /// sub-steps in which an error of position was moved out, apart from the
    /// velocities
    int repairs = 0;

    // Memory.
    std::vector<Real> goal;      ///< of each row [m]
    std::vector<Real> approach;  ///< J u before the step [m/s]
    SecondProblem second;
    VecX x;                      ///< where the bodies would be [m]
    VecX v;                      ///< pseudo-velocities of the repair [m/s]
    VecX u_first, lambda_first;  ///< of the first pass; λ of the first half

    void require_valid() const
    {
        rigid::require_valid(static_cast<const RattleSettings&>(*this));
        rigid::require_valid(static_cast<const Restitution&>(*this));
    }

    //! [rattle_rows]
    /// The first half: half of the forces, and rows that hold C where it is,
    /// (9.24). A gap may close.
    template <class Scene>
    void rows(const Scene& scene, const StepSettings& settings,
              StepData<Scene::dof>& now)
    {
        now.second_half = false;
        if (now.substep == 0) iterations = not_converged = repairs = 0;
        const Real h = settings.part();
        half_of_the_forces(scene.bodies, now);
        now.rows.resize(now.constraints.size());
        goal.assign(now.rows.size(), 0);
        approach.assign(now.rows.size(), 0);
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const auto& c = now.constraints[i];
            if (c.kind == ConstraintKind::spring)
                throw std::invalid_argument(
                    "constraint " + std::to_string(i) +
                    " is a spring; RATTLE takes springs as forces, not as rows");
            goal[i] =
                c.kind == ConstraintKind::unilateral ? std::min(Real{0}, c.C) : c.C;
            now.rows[i] = row_of(c, scene.bodies.inverse_mass, 0, h / 2);
            approach[i] = now.rows[i].velocity(scene.bodies.u);
            now.rows[i].bias =
                has_error(c.kind) ? (c.C - goal[i]) / h : own_bias(c, h);
        }
    }
    //! [rattle_rows]

    //! [rattle_move]
    template <class Scene, SolvesAgain<Scene::dof> Solver>
    void move(Scene& scene, const StepSettings& settings, Solver& solver,
              StepData<Scene::dof>& now)
    {
        constexpr int Dof = Scene::dof;
        auto& bodies = scene.bodies;
        const Real h = settings.part();
        const Real close = std::max(tolerance * now.length,
                                    h * rounded_speed(bodies.x, bodies.u, h));
        meet_positions(scene, h, close, solver, now);
        advance_positions(bodies, h, now);
        // what was there before the step, without a velocity
        repair(scene, h, 4 * close, solver, now);
        const Status first = now.solution.status;
        const Real first_residual = now.solution.residual;
        lambda_first = now.solution.lambda;

        // The second half, (9.25): no row but those that touch.
        free_velocities(scene, settings, now);
        half_of_the_forces(bodies, now);
        const Real slowest = threshold * scene.gravity.norm() * settings.part();
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const Constraint<Dof> c = now.constraints[i] =
                constraint_at(scene, now, i, bodies.x);
            const bool touches = c.kind != ConstraintKind::unilateral ||
                                 c.C <= 4 * close ||
                                 lambda_first[static_cast<Index>(i)] > 0;
            const bool bounces =
                c.bounces && restitution > 0 && approach[i] < -slowest;
            now.rows[i] = row_of(c, bodies.inverse_mass,
                                 bounces ? restitution * approach[i] : 0, h / 2);
            if (!has_error(c.kind)) now.rows[i].bias = own_bias(c, h);
            if (!touches) now.rows[i].lo = now.rows[i].hi = 0;
        }
        now.second_half = true;
        solver.solve(bodies, now);
        now.second_half = false;
        now.solution.lambda += lambda_first;  // the whole impulse of the sub-step
        now.solution.residual = std::max(now.solution.residual, first_residual);
        if (first != Status::solved) now.solution.status = first;
    }
    //! [rattle_move]

private:
    /// (u + u*)/2 is u with half of the forces' impulse.
    template <int Dof>
    static void half_of_the_forces(const Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        for (const int k : now.active) {
            auto u = now.u_star.template segment<Dof>(Dof * k);
            u = (u + bodies.velocity(k)) / 2;
        }
    }

    //! [meet_positions]
    /// (9.26): Newton's method on C(x + h u) = goal, or ≥ and complementary to λ,
    /// with the A of the step. If it does not arrive, u is that of the first pass,
    /// whose rows are met to first order, and the status says so.
    template <class Scene, class Solver>
    void meet_positions(Scene& scene, Real h, Real close, Solver& solver,
                        StepData<Scene::dof>& now)
    {
        auto& bodies = scene.bodies;
        u_first = bodies.u;
        lambda_first = now.solution.lambda;
        second.max_sweeps = 1000;
        second.tolerance = close / h / 10;
        if (now.solution.status != Status::solved) return;
        for (int n = 1;
             n <= max_iterations && now.solution.status == Status::solved; ++n) {
            iterations = std::max(iterations, n);
            if (is_met(scene, h, close, now)) return;
            if (!x.allFinite()) break;
            solver.solve_again(second, bodies, now);
            for (std::size_t i = 0; i < now.rows.size(); ++i)
                now.rows[i].bias = second.bias[i];
        }
        ++not_converged;
        bodies.u = u_first;
        now.solution.lambda = lambda_first;
        if (now.solution.status == Status::solved)
            now.solution.status = Status::iteration_limit;
    }

    /// Whether each row is where it should be after the step, and the biases that
    /// would bring it there.
    template <class Scene>
    bool is_met(const Scene& scene, Real h, Real close,
                const StepData<Scene::dof>& now)
    {
        constexpr int Dof = Scene::dof;
        const auto& bodies = scene.bodies;
        x = bodies.x;
        for (const int k : now.active)
            x.template segment<Dof>(Dof * k) += h * bodies.velocity(k);
        second.bias.assign(now.rows.size(), 0);
        second.left_out.assign(now.rows.size(), 0);
        bool met = true;
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const auto& row = now.rows[i];
            const auto c = constraint_at(scene, now, i, x);
            second.bias[i] = row.bias;
            if (!has_error(c.kind) || turns_too_far(row, c.kind, now)) continue;
            const Real off = c.C - goal[i];
            // (C − goal)/h − J u
            second.bias[i] += off / h - row.velocity(bodies.u);
            const bool holds = c.kind == ConstraintKind::bilateral ||
                               now.solution.lambda[static_cast<Index>(i)] > 0;
            met = met && (holds ? std::abs(off) <= close : off >= -close);
        }
        return met;
    }
    //! [meet_positions]

    /// (7.13), all of it at once: errors of position are moved out, and leave no velocity.
    template <class Scene, class Solver>
    void repair(Scene& scene, Real h, Real left_alone, Solver& solver,
                StepData<Scene::dof>& now)
    {
        constexpr int Dof = Scene::dof;
        auto& bodies = scene.bodies;
        bool wanted = false;
        second.bias.assign(now.rows.size(), 0);
        second.left_out.assign(now.rows.size(), 0);
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const auto c = constraint_at(scene, now, i, bodies.x);
            second.left_out[i] = !has_error(c.kind);
            if (second.left_out[i]) continue;
            second.bias[i] = c.C / h;
            wanted = wanted ||
                     (c.kind == ConstraintKind::bilateral ? std::abs(c.C) : -c.C) >
                         left_alone;
        }
        if (!wanted) return;
        ++repairs;
        if (v.size() != bodies.u.size()) v.setZero(bodies.u.size());
        solver.solve_apart(second, v, now);
        if (Solver::is_exact && second.solution.status != Status::solved)
            now.solution.status = second.solution.status;
        for (const int k : now.active)
            bodies.integrate(k, v.template segment<Dof>(Dof * k), h);
    }
};

/// The method: positions that are met, velocities that keep to the rows, both solved exactly.
struct RattleMethod {
    AllPairs contacts;
    Rattle correction;
    ColdStart start;
    ExactSolver solver;
};

}  // namespace rigid
