/// \file friction_solver.hpp
/// The solver stage of the step with friction: rows become A, q and boxes, and one of the solvers of this chapter finds λ.
///
/// Its methods are chapter 11's with the friction stage on top of their contacts. Sweeps need nothing else: chapter 6's solver takes
/// the bounds of a row from the present impulse of its normal.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/09_active_sets/exact_method.hpp"
#include "chapters/10_skipping_work/by_islands.hpp"
#include "chapters/11_rotation/rigid_method.hpp"
#include "chapters/12_contact_manifolds/awake_manifolds.hpp"
#include "chapters/13_friction/friction_active_sets.hpp"
#include "chapters/13_friction/friction_islands.hpp"
#include "chapters/13_friction/friction_stage.hpp"

namespace rigid {

/// Algorithm 13.2 as a finder: void(Mlcp&, boxes, Solution&).
struct FindFriction {
    FrictionSettings settings;
    FrictionMemory memory;

    void require_valid() const { rigid::require_valid(settings); }
    void operator()(Mlcp& mlcp, std::span<const FrictionBox> boxes, Real enough,
                    Solution& solution)
    {
        settings.enough = enough;
        friction_active_sets(mlcp, boxes, settings, memory, solution);
    }
};

/// Lemke's algorithm on Stewart's and Trinkle's problem as a finder.
struct FindByStewartTrinkle {
    void require_valid() const {}
    void operator()(Mlcp& mlcp, std::span<const FrictionBox> boxes, Real enough,
                    Solution& solution) const;
};

/// What rounding makes of the gap of two corners: four times that of two positions,
/// as far as that is below 10⁻⁷ ℓ/s. Far from the origin nothing is added to it.
template <int Dof>
Real noise_of_corners(const Bodies<Dof>& bodies, const StepData<Dof>& now)
{
    const Real noise = rounded_speed(bodies.x, bodies.u, now.h);
    return std::max(noise, std::min(4 * noise, 1e-7 * now.length));
}

/// What rounding makes of the velocity of a light body under the impulses that hold
/// a heavy one: ε max A_ii max m |u*|, as far as that is below 10⁻⁷ ℓ/s. No λ in
/// doubles has a smaller residual; a λ that is too large is no excuse, for it is not
/// part of this.
template <int Dof>
Real noise_of_impulses(const Bodies<Dof>& bodies, const Mlcp& mlcp,
                       const StepData<Dof>& now)
{
    Real heaviest = 0, mobility = 0;
    for (const int k : now.active)
        if (const Real inverse = bodies.inverse_mass[Dof * k]; inverse > 0)
            heaviest = std::max(
                heaviest, now.u_star.template segment<2>(Dof * k).norm() / inverse);
    for (Index i = 0; i < mlcp.size(); ++i)
        mobility = std::max(mobility, mlcp.A.coeff(i, i));
    return std::min(2 * std::numeric_limits<Real>::epsilon() * mobility * heaviest,
                    1e-7 * now.length);
}

//! [coulomb_solver]
/// The solver stage: λ of the Coulomb problem, u = u* + M⁻¹ Jᵀ λ (3.9).
template <class Find>
struct CoulombSolver : PlainSolver {
    static constexpr bool is_exact = true;

    Find find;
    Find errors;      ///< the second problem of a step has a memory of its own
    Real enough = 0;  ///< a residual below this is none [ℓ/s]

    AssemblyScratch scratch;
    Mlcp mlcp, second_mlcp;
    std::vector<FrictionBox> boxes, none;

    void require_valid() const
    {
        if (!(enough >= 0 && enough < infinity))
            throw std::invalid_argument(
                "the residual that is nothing is " + shortest(enough) +
                " lengths of the scene a second; it must be zero or positive, and "
                "finite");
        find.require_valid();
    }

    template <int Dof>
    void solve(Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        if (now.substep == 0 && !now.second_half) unsolved = 0;
        assemble(now.rows, now.u_star, scratch, mlcp);
        boxes_of(now.rows, boxes);
        nothing_ = std::max({enough * now.length, noise_of_corners(bodies, now),
                             noise_of_impulses(bodies, mlcp, now)});
        find(mlcp, boxes, nothing_, now.solution);
        finish(bodies, now);
    }

    /// Other biases, the same u*: λ and u become the answer to them.
    template <int Dof>
    void solve_again(SecondProblem& second, Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            mlcp.q[static_cast<Index>(i)] += second.bias[i] - now.rows[i].bias;
        find(mlcp, boxes, nothing_, now.solution);
        finish(bodies, now);
    }

    /// The biases alone, from rest: v = M⁻¹ Jᵀ Λ. Errors are corrected without
    /// friction.
    template <int Dof>
    void solve_apart(SecondProblem& second, VecX& v, StepData<Dof>& now)
    {
        second_mlcp = mlcp;
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const auto row = static_cast<Index>(i);
            second_mlcp.q[row] = second.left_out[i] ? 0 : second.bias[i];
            second_mlcp.lo[row] = second.left_out[i] ? 0 : now.rows[i].lo;
            second_mlcp.hi[row] = second.left_out[i] ? 0 : now.rows[i].hi;
        }
        if (second.solution.lambda.size() != mlcp.size())
            second.solution.lambda.setZero(mlcp.size());
        errors(second_mlcp, none, nothing_, second.solution);
        unsolved += second.solution.status != Status::solved;
        for (const int k : now.active) v.template segment<Dof>(Dof * k).setZero();
        apply(now.rows, second.solution.lambda, v);
    }

private:
    template <int Dof>
    void finish(Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        unsolved += now.solution.status != Status::solved;
        for (const int k : now.active)
            bodies.velocity(k) = now.u_star.template segment<Dof>(Dof * k);
        apply(now.rows, now.solution.lambda, bodies.u);
    }

    Real nothing_ = 0;
};
//! [coulomb_solver]

/// Last step's impulses as they were: where the guesses of the exact solver begin.
inline WarmStart last_impulses()
{
    WarmStart start;
    start.from = Start::previous;
    return start;
}

//! [steady]
/// What keeps a tower at rest under sweeps that are not finished (section 13.5):
/// contacts stay closed by half a per cent of ℓ, and no velocity remains that only
/// was there to correct.
inline Correction steady_contacts()
{
    Correction correction;
    correction.method = Stabilizer::relaxation;
    correction.slop = 0.005;
    return correction;
}
//! [steady]

//! [method]
template <class Contacts>
struct FrictionSweeps {
    WithFriction<Contacts> contacts;
    Correction correction = steady_contacts();
    WarmStart start;
    HoldOrSlide<ImpulseSolver<3>> solver;
};

/// Chapter 10's skips: islands by themselves, each until it is good enough, and
/// those at rest not at all.
struct SkippingFriction {
    WithFriction<AwakeManifolds> contacts;
    Correction correction = steady_contacts();
    WarmStart start;
    HoldOrSlide<IslandSolver<3, ExactFrictionIslands>> solver;
};

template <class Contacts>
struct ExactFriction {
    WithFriction<Contacts> contacts;
    Correction correction;
    WarmStart start = last_impulses();
    HoldOrSlide<CoulombSolver<FindFriction>> solver;
};

template <class Contacts>
struct LemkeFriction {
    WithFriction<Contacts> contacts;
    Correction correction;
    ColdStart start;
    HoldOrSlide<CoulombSolver<FindByStewartTrinkle>> solver;
};
//! [method]

// Compiled once, in friction_solver.cpp.
extern template void step(RoughScene&, const StepSettings&,
                          FrictionSweeps<AllBodies>&, StepData<3>&);
extern template void step(RoughScene&, const StepSettings&,
                          FrictionSweeps<Manifolds>&, StepData<3>&);
extern template void step(RoughScene&, const StepSettings&,
                          ExactFriction<AllBodies>&, StepData<3>&);
extern template void step(RoughScene&, const StepSettings&,
                          ExactFriction<Manifolds>&, StepData<3>&);
extern template void step(RoughScene&, const StepSettings&,
                          LemkeFriction<AllBodies>&, StepData<3>&);
extern template void step(RoughScene&, const StepSettings&, SkippingFriction&,
                          StepData<3>&);

}  // namespace rigid
