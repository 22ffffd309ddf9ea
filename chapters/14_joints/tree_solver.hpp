/// \file tree_solver.hpp
/// The solver stage of the step: the joints at once, and the rest by sweeps on top of them.
///
///     repeat     rows with bounds, one after the other, (6.5)
///                all joints at once: J u + γ λ + b = 0, from the u that these left
///
/// (14.15): block Gauss-Seidel, with all joints as one block. Without rows that have bounds it is one exact solve.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/14_joints/joint_factor.hpp"

namespace rigid {

//! [tree_solver]
struct TreeSolver {
    int sweeps = 10;  ///< over the rows with bounds, at most
    /// they end when none changes a row by more than this [ℓ/s]
    Real tolerance = 1e-9;

    // What is kept from step to step.
    JointFactor joints;
    JointFactor apart;    ///< of solve_apart(), where springs are left out
    int sweeps_made = 0;  ///< of the last solve

    void require_valid() const
    {
        if (sweeps < 0)
            throw std::invalid_argument("the number of sweeps is " +
                                        std::to_string(sweeps) +
                                        "; it must be zero or positive");
        if (!(tolerance >= 0))
            throw std::invalid_argument("the tolerance of the sweeps is " +
                                        shortest(tolerance) +
                                        "; it must be zero or positive");
    }

    void solve(Bodies<3>& bodies, StepData<3>& now)
    {
        joints.factor(now.rows, bodies.inverse_mass);
        inverse_mass_ = bodies.inverse_mass;
        VecX& lambda = now.solution.lambda;
        for (const int k : now.active)
            bodies.velocity(k) = now.u_star.segment<3>(3 * k);
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            Real& start = lambda[static_cast<Index>(i)];
            if (JointTree::takes(now.rows[i])) start = 0;
            else {
                const auto [lo, hi] = bounds_of(now.rows[i], lambda);
                start = std::clamp(start, lo, hi);
                now.rows[i].apply(start, bodies.u);
            }
        }
        bias_.resize(lambda.size());
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            bias_[static_cast<Index>(i)] = now.rows[i].bias;
        run(joints, {}, sweeps, tolerance * now.length, bodies.u, lambda, now);
        judge(bodies.u, lambda, now, now.solution);
    }

    /// Other biases, the same u*: on from the present λ and u.
    void solve_again(SecondProblem& second, Bodies<3>& bodies, StepData<3>& now)
    {
        take(second.bias);
        run(joints, {}, std::max(sweeps, 1), tolerance * now.length, bodies.u,
            now.solution.lambda, now);
        judge(bodies.u, now.solution.lambda, now, now.solution);
    }

    /// The rows have another J: what solve_apart() needs.
    void factor_again(const Bodies<3>& bodies, const StepData<3>& now)
    {
        inverse_mass_ = bodies.inverse_mass;
        joints.factor(now.rows, inverse_mass_);
    }

    /// The biases alone, from rest: v = M⁻¹ Jᵀ Λ.
    void solve_apart(SecondProblem& second, VecX& v, StepData<3>& now)
    {
        take(second.bias);
        for (const int k : now.active) v.segment<3>(3 * k).setZero();
        second.solution.lambda.setZero(bias_.size());
        bool same =
            true;  // are the joints of this problem those of the velocities?
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            same = same && !(second.left_out[i] && JointTree::takes(now.rows[i]));
        if (!same) apart.factor(now.rows, inverse_mass_, second.left_out);
        run(same ? joints : apart, second.left_out, second.max_sweeps,
            second.tolerance, v, second.solution.lambda, now);
        second.solution.status = Status::solved;
    }
    //! [tree_solver]

private:
    void take(const std::vector<Real>& bias)
    {
        bias_ =
            Eigen::Map<const VecX>(bias.data(), static_cast<Index>(bias.size()));
    }

    //! [run]
    /// (14.15), from the present λ and u on.
    /// \param left_out  1: a row without impulse; empty = none
    void run(JointFactor& factor, const std::vector<char>& left_out, int most,
             Real small, VecX& u, VecX& lambda, StepData<3>& now)
    {
        sweeps_made = 0;
        solve_joints(factor, u, lambda, now);
        for (int changed = 1; sweeps_made < most && changed > 0; ++sweeps_made) {
            changed = 0;
            for (std::size_t i = 0; i < now.rows.size(); ++i) {
                const Row<3>& row = now.rows[i];
                if (JointTree::takes(row) || (!left_out.empty() && left_out[i]))
                    continue;
                ++now.visits;
                const auto k = static_cast<Index>(i);
                const Real A = row.diagonal();
                if (!(A > 0)) continue;
                const Real w = row.velocity(u) - row.bias + bias_[k] +
                               row.softness * lambda[k];
                const auto [lo, hi] = bounds_of(row, lambda);
                const Real change =
                    std::clamp(lambda[k] - w / A, lo, hi) - lambda[k];
                lambda[k] += change;
                row.apply(change, u);
                changed += !(std::abs(change) * A <= small);
            }
            if (changed > 0) solve_joints(factor, u, lambda, now);
        }
    }

    /// What is missing to J u + γ λ + b = 0 in each row of the joints.
    void solve_joints(JointFactor& factor, VecX& u, VecX& lambda,
                      const StepData<3>& now)
    {
        missing_ = bias_;
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            missing_[static_cast<Index>(i)] +=
                now.rows[i].softness * lambda[static_cast<Index>(i)];
        change_.setZero(lambda.size());
        factor.solve(now.rows, missing_, u, change_);
        lambda += change_;
    }
    //! [run]

    /// `solved` if the natural residual of λ, from the velocities themselves, is below the tolerance.
    void judge(const VecX& u, const VecX& lambda, const StepData<3>& now,
               Solution& solution) const
    {
        Real residual = 0;
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const Row<3>& row = now.rows[i];
            const auto k = static_cast<Index>(i);
            const Real w =
                row.velocity(u) - row.bias + bias_[k] + row.softness * lambda[k];
            const auto [lo, hi] = bounds_of(row, lambda);
            const Real r =
                natural_residual_row(row.diagonal(), lambda[k], w, lo, hi);
            if (!(r <= residual)) residual = r;
        }
        solution.residual = residual;
        solution.iterations = sweeps_made;
        solution.status = residual <= std::max(tolerance, 1e-9) * now.length
                              ? Status::solved
                          : joints.tree.dependent > 0 || !std::isfinite(residual)
                              ? Status::singular
                              : Status::iteration_limit;
    }

    VecX bias_, missing_, change_, inverse_mass_;
};

}  // namespace rigid
