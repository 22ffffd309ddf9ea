/// \file wide_solver.hpp
/// The solver stage of the step by wide sweeps: the same rows and visits, in an order in which many are under way at a time.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/10_skipping_work/row_residual.hpp"
#include "chapters/17_wide_sweeps/sweep_momentum.hpp"

namespace rigid {

/// Rows that nothing moves keep their w: each takes the bound that is right for it.
/// \return  true if one of them would need an infinite one, and w is off by more than the tolerance
template <int Dof>
bool settle_unmoved(const std::vector<Row<Dof>>& rows, const VecX& u,
                    Real tolerance, VecX& lambda)
{
    bool hopeless = false;
    // those that another row bounds come last
    for (std::size_t k = 0; k < 2 * rows.size(); ++k) {
        const std::size_t i = k % rows.size();
        if (rows[i].inverse_effective_mass() > 0 ||
            (rows[i].bounded_by >= 0) != (k >= rows.size()))
            continue;
        Real& own = lambda[static_cast<Index>(i)];
        const auto [lo, hi] = bounds_of(rows[i], lambda);
        const Real w = rows[i].velocity(u);
        if (rows[i].softness > 0) {
            own = std::clamp(-w / rows[i].softness, lo, hi);
            continue;
        }
        const Real bound = w > 0 ? lo : w < 0 ? hi : own;
        if (std::isfinite(bound)) own = bound;
        else hopeless = hopeless || std::abs(w) > tolerance;
    }
    return hopeless;
}

//! [solver]
/// \tparam T  of the numbers that are swept; if these are floats, λ and u are doubles
///            all the same
/// \tparam L  lanes: bundles side by side
template <int Dof, class T = Real, int L = full_lanes<T>>
struct WideSolver : PlainSolver {
    ImpulseSettings sweeps;
    int threads = 1;  ///< that share a colour
    /// of floats: sweeps from one look with doubles to the next
    int pass = 20;
    bool momentum = false;  ///< sweeps go further in their direction, (17.11)
    bool careless = false;  ///< to break it: all bundles have one colour

    // What is kept from step to step.
    Bundles bundles;
    WideRows<Dof, T, L> wide;
    SweepMomentum<Dof, T, L> going;

    void require_valid() const;
    Real noise() const { return sweeps.tolerance; }

    /// The rows into their places, unless they are there.
    void begin(const Bodies<Dof>& bodies, const StepData<Dof>& now)
    {
        if (wide.place.size() == now.rows.size() && careless == was_careless_ &&
            (now.substep > 0 || (now.same_rows && same_movers(now.rows, bundles))))
            return put_masses(bodies.inverse_mass, wide);
        require_bodies<Dof>(now.rows, bodies.count());
        bundle_rows(now.rows, bodies.count(), bundles);
        colour(bodies, now);
    }
    /// The rows of the bundles into their places.
    void colour(const Bodies<Dof>& bodies, const StepData<Dof>& now)
    {
        colour_bundles(now.rows, bodies.count(), bundles);
        was_careless_ = careless;
        if (careless) forget_colours(bundles);
        arrange(now.rows, bodies.count(), bundles, wide);
        put_masses(bodies.inverse_mass, wide);
    }

    void solve(Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        begin(bodies, now);
        VecX& lambda = now.solution.lambda;
        for (const int k : now.active)
            bodies.velocity(k) = now.u_star.template segment<Dof>(Dof * k);
        const auto m = static_cast<Index>(now.rows.size());
        if (lambda.size() != m) lambda.setZero(m);
        clamp_start(now.rows, lambda);
        const Real tolerance = sweeps.tolerance * now.length;
        const bool hopeless = settle_unmoved(now.rows, bodies.u, tolerance, lambda);
        const WideProblem<Dof> problem{now.rows};
        if constexpr (in_differences<T>) {
            for (std::size_t i = 0; i < now.rows.size(); ++i)
                now.rows[i].apply(lambda[static_cast<Index>(i)], bodies.u);
        } else {
            fill(problem, bundles, lambda, bodies.u, wide);
            apply_impulses(wide);
            get_velocities(wide.u, bodies.u);
        }
        sweep_until(problem, sweeps.max_sweeps, tolerance, now.length, hopeless,
                    bodies.u, now.solution);
        now.visits += visits_;
    }
    //! [solver]

    //! [until]
    /// Sweeps until there is nothing left to do, as chapter 6 does. Doubles are filled
    /// in once; floats after each pass, with what is left to do then.
    /// \param length  ℓ [m]
    /// \param u       with the effect of solution.lambda; both are changed
    void sweep_until(const WideProblem<Dof>& problem, int most, Real tolerance,
                     Real length, bool hopeless, VecX& u, Solution& solution)
    {
        const auto m = static_cast<std::int64_t>(problem.rows.size());
        solution.status = hopeless ? Status::infeasible : Status::iteration_limit;
        solution.residual = infinity;
        visits_ = solution.iterations = 0;
        bool off = true, filled = false;
        for (int swept = 0; solution.iterations < most && off;) {
            if (!filled)
                fill(problem, bundles, solution.lambda, u, wide), swept = 0;
            if (momentum && filled) going.go_on(wide);
            else if (momentum) going.begin(wide);
            filled = true;
            off = momentum ? wide_sweep(wide, T(tolerance), team(), going)
                           : wide_sweep(wide, T(tolerance), team());
            visits_ += m;
            const bool last = ++solution.iterations == most || !off,
                       passed = in_differences<T> && ++swept == pass;
            if (!last && !passed) continue;
            take_out(problem, u, solution.lambda);
            filled = !in_differences<T>;
            if (!(tolerance > 0)) continue;
            // A small change is no small residual.
            solution.residual =
                natural_residual(problem.rows, solution.lambda, u, length);
            visits_ += m;
            if (solution.residual <= tolerance) solution.status = Status::solved;
            off = solution.status != Status::solved && !hopeless;
        }
    }
    //! [until]

    //! [take_out]
    /// λ and u as the lanes have them.
    void take_out(const WideProblem<Dof>& problem, VecX& u, VecX& lambda)
    {
        last_ = lambda;
        for (std::size_t i = 0; i < wide.place.size(); ++i) {
            const auto [at, l] = wide.place[i];
            if (at < 0) continue;
            const Real found =
                lane(wide.rows[static_cast<std::size_t>(at)].lambda, l);
            Real& own = lambda[static_cast<Index>(i)];
            own = in_differences<T> ? std::clamp(own + found, problem.rows[i].lo,
                                                 problem.rows[i].hi)
                                    : found;
        }
        if constexpr (in_differences<T>) {
            for (std::size_t i = 0; i < problem.rows.size(); ++i)
                problem.rows[i].apply(lambda[static_cast<Index>(i)] -
                                          last_[static_cast<Index>(i)],
                                      u);
        } else get_velocities(wide.u, u);
    }
    //! [take_out]

    /// Other biases, the same u*: the sweeps go on from the present λ and u.
    void solve_again(SecondProblem& second, Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        const Status status = now.solution.status;
        const Real residual = now.solution.residual;
        const int iterations = now.solution.iterations;
        sweep_until({now.rows, &second}, second, bodies.u, now.solution);
        now.solution.status = status;
        now.solution.residual = residual;
        now.solution.iterations = iterations;
        now.visits += visits_;
    }

    /// The biases alone, from rest: v = M⁻¹ Jᵀ Λ.
    void solve_apart(SecondProblem& second, VecX& v, StepData<Dof>& now)
    {
        for (const int k : now.active) v.template segment<Dof>(Dof * k).setZero();
        second.solution.lambda.setZero(static_cast<Index>(now.rows.size()));
        sweep_until({now.rows, &second, true}, second, v, second.solution);
        now.visits += visits_;
    }

private:
    /// Lanes that overwrite each other are to do so in the same way each time.
    int team() const { return careless ? 1 : threads; }

    /// Without a residual, as chapter 6 answers a second problem.
    void sweep_until(const WideProblem<Dof>& problem, const SecondProblem& second,
                     VecX& u, Solution& solution)
    {
        const auto m = static_cast<std::int64_t>(problem.rows.size());
        visits_ = 0;
        bool off = true, filled = false;
        for (int n = 0, swept = 0; n < second.max_sweeps && off; ++n) {
            if (!filled)
                fill(problem, bundles, solution.lambda, u, wide), swept = 0;
            off = wide_sweep(wide, static_cast<T>(second.tolerance), team());
            visits_ += m;
            filled = !in_differences<T> || ++swept < pass;
            if (!filled || n + 1 == second.max_sweeps || !off)
                take_out(problem, u, solution.lambda);
        }
    }

    VecX last_;
    std::int64_t visits_ = 0;
    bool was_careless_ = false;  ///< when the rows took their places
};

template <int Dof, class T, int L>
void WideSolver<Dof, T, L>::require_valid() const
{
    rigid::require_valid(sweeps);
    if (sweeps.alternate)
        throw std::invalid_argument(
            "wide sweeps go forwards only; alternate is on");
    if (pass < 1)
        throw std::invalid_argument("a pass has " + std::to_string(pass) +
                                    " sweeps; it must have one or more");
    if (threads < 1 || threads > most_threads)
        throw std::invalid_argument("the number of threads is " +
                                    std::to_string(threads) + "; it must be 1 to " +
                                    std::to_string(most_threads));
}

}  // namespace rigid
