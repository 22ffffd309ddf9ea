/// \file tree_solver.hpp
/// The solver stage of the step: the joints at once, and above them the rows with bounds.
///
///     û, what joints alone make of u*  →  λ of the rows with bounds, (15.10)  →  joints from u* and these impulses
///
/// Where an island of (15.10) has too many rows for guesses: sweeps over its A. Without (15.10): rounds of sweeps, and all
/// joints after each, (15.9). Whatever was done, the natural residual of all rows decides whether it is called solved.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/03_mlcp_formulation/verification.hpp"
#include "chapters/15_trees/bounded_rows.hpp"
#include "chapters/15_trees/joint_answer.hpp"
#include "chapters/15_trees/newton_settings.hpp"
#include "chapters/15_trees/reflections.hpp"

#include <array>

namespace rigid {

//! [tree_solver]
struct TreeSolver : PlainSolver {
    int sweeps = 40;  ///< over the rows with bounds of larger islands
    /// rounds end when none changes a row by more than this [ℓ/s]
    Real tolerance = 1e-9;
    /// rows of an island that are found exactly, at most; 0: rounds of (15.9)
    int most_exact = 600;
    FrictionSettings exact;  ///< how hard it tries

    // What is kept from step to step.
    JointFactor joints;
    JointFactor apart;    ///< of solve_apart(), where springs are left out
    BoundedRows bounded;  ///< above the joints
    /// the same of other problems: errors, and arcs
    struct Apart {
        BoundedRows bounded;
        bool listed = false;         ///< A is that of these rows and joints
        std::vector<char> left_out;  ///< of the last one
    };
    std::array<Apart, 2> others;
    Reflections reflections;
    int sweeps_made = 0;  ///< of the last solve

    void require_valid() const
    {
        const auto refuse = [](const std::string& what) {
            throw std::invalid_argument(what + "; it must be zero or positive");
        };
        if (sweeps < 0) refuse("the number of sweeps is " + std::to_string(sweeps));
        require_tolerance("the sweeps", tolerance);
        if (most_exact < 0)
            refuse("the rows with bounds that are found exactly are at most " +
                   std::to_string(most_exact));
        rigid::require_valid(exact);
    }
    Real noise() const { return tolerance; }

    void solve(Bodies<3>& bodies, StepData<3>& now)
    {
        factor_again(bodies, now);
        if (now.substep == 0) reflections.bounced.clear();
        all_.resize(now.rows.size());
        std::iota(all_.begin(), all_.end(), 0);
        if (!now.restitution.empty())  // impacts come first
            reflections(all_, now.active, *this, bodies, now);
        biases_of(now.rows, bias_);
        answer(bodies, now);
        if (!now.restitution.empty()) reflections.add_impulses(all_, now);
    }

    /// All rows are one problem.
    template <class Visit>
    void for_each_problem(const StepData<3>& now, const Visit& visit)
    {
        visit(all_, now.active, *this, Corrected::arcs_and_errors);
    }

    /// What bounces at the end of a sub-step, after the positions.
    void bounce_late(Bodies<3>& bodies, StepData<3>& now)
    {
        if (now.restitution.empty() || !reflections.any_late) return;
        factor_again(bodies, now);  // J is that of the rows again
        reflections.at_the_end(all_, now.active, *this, bodies, now);
    }

    /// Other biases, the same u*.
    void solve_again(SecondProblem& second, Bodies<3>& bodies, StepData<3>& now)
    {
        take(second.bias);
        answer(bodies, now);
    }

    /// The rows have another J: what solve_apart() needs.
    void factor_again(const Bodies<3>& bodies, const StepData<3>& now)
    {
        inverse_mass_ = bodies.inverse_mass;
        joints.factor(now.rows, inverse_mass_);
        listed_ = others[0].listed = others[1].listed = false;
        enough_ = std::max(std::max(tolerance, 1e-9) * now.length,
                           noise_of_corners(bodies, now));
    }

    /// The biases alone, from rest: v = M⁻¹ Jᵀ Λ.
    void solve_apart(SecondProblem& second, VecX& v, StepData<3>& now)
    {
        take(second.bias);
        VecX& lambda = second.solution.lambda;
        if (lambda.size() != bias_.size()) lambda.setZero(bias_.size());
        // are the joints of this problem those of the velocities?
        bool same = true;
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            same = same && !(second.left_out[i] && JointTree::takes(now.rows[i]));
            if (second.left_out[i]) lambda[static_cast<Index>(i)] = 0;
        }
        Apart& other = others[second.arcs];
        if (!other.listed || second.left_out != other.left_out) {
            other.left_out = second.left_out;
            other.listed = false;
            if (!same) others[!second.arcs].listed = false;  // they share a factor
        }
        if (!same && !other.listed)
            apart.factor(now.rows, inverse_mass_, second.left_out);
        const auto from_rest = [&] {
            for (const int k : now.active) v.segment<3>(3 * k).setZero();
        };
        const bool done =
            run(same ? joints : apart, other.bounded, other.listed, second.left_out,
                same && listed_ ? &bounded : nullptr, second.max_sweeps,
                second.tolerance, from_rest, v, lambda, now);
        second.solution.status = done ? Status::solved : Status::iteration_limit;
    }
    //! [tree_solver]

private:
    void take(const std::vector<Real>& bias)
    {
        bias_ =
            Eigen::Map<const VecX>(bias.data(), static_cast<Index>(bias.size()));
    }

    void answer(Bodies<3>& bodies, StepData<3>& now);

    //! [run]
    /// Algorithm 15.2.
    /// \param listed    whether A is that of these rows and joints
    /// \param left_out  1: a row without impulse; empty = none
    /// \param known     has A of these joints, perhaps of other rows; nullptr = none
    /// \param begin     sets u to u*; lambda is where the rows with bounds start
    /// \return          whether the rows with bounds have an answer
    template <class Begin>
    bool run(JointFactor& factor, BoundedRows& above, bool& listed,
             const std::vector<char>& left_out, const BoundedRows* known, int most,
             Real small, const Begin& begin, VecX& u, VecX& lambda,
             StepData<3>& now)
    {
        const bool any = clamp_start(now.rows, left_out, lambda);
        answer_.unlike = 0;
        begin();
        bool found = !any;
        if (any && most_exact > 0) {
            answer_.solve(factor, now.rows, bias_, u, lambda);  // û
            if (!listed)
                above.eliminate(factor, now.rows, left_out, u.size() / 3, known);
            now.visits += above.islands.listed;
            above.solve(now.rows, u, bias_, exact, most_exact, most, enough_ / 2,
                        lambda);
            found = above.unsolved == 0;
            begin();
        }
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            Real& here = lambda[static_cast<Index>(i)];
            if (JointTree::takes(now.rows[i])) here = 0;
            else now.rows[i].apply(here, u);
        }
        answer_.solve(factor, now.rows, bias_, u, lambda);
        if (factor.tree.carried > much_carried)
            answer_.refine(factor, now.rows, bias_, enough_ / 2, begin, u, lambda);
        listed = true;
        sweeps_made = any && most_exact > 0 ? above.sweeps_made : 0;
        if (found || most_exact > 0) return found;
        return sweep_on(factor, left_out, most, small, u, lambda, now);
    }
    //! [run]

    /// (15.9), from the present λ and u on.
    bool sweep_on(JointFactor& factor, const std::vector<char>& left_out, int most,
                  Real small, VecX& u, VecX& lambda, StepData<3>& now);

    /// `solved` if the natural residual of λ, of the velocities, is below the tolerance, and not all is noise.
    void judge(const VecX& u, const VecX& lambda, const StepData<3>& now,
               Solution& solution) const;

    VecX bias_, inverse_mass_;
    JointAnswer answer_;
    Real enough_ = 0;  ///< a residual below this is none [m/s]
    // is A that of the present rows?
    bool listed_ = false;
    std::vector<int> all_;  ///< rows
};

}  // namespace rigid
