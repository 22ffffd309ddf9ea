/// \file spring_forces.hpp
/// A constraint as a spring: the penalty method, with its force at the start of the step or at its end.
///
///     f = −(k C + c dC/dt)                    joints; contacts only where C < 0 and f > 0
///     f = K (−C)^{3/2}                        the same with Hertz's law
///     f_t = −(k s + c v_t), |f_t| ≤ μ f_n     s: how far the point has moved since it stuck
///
/// (26.1) to (26.3), (26.10). Both are stages of chapter 3's step: a correction that makes every row a spring, and two solvers. The
/// explicit one is no solver at all, it writes λ = h f down; at the end of the step the springs are soft rows (16.6).
/// \cite moore1988 \cite cundall1979
#pragma once

#include "chapters/15_trees/tree_method.hpp"
#include "chapters/26_four_ways/require_values.hpp"
#include "common/elementary.hpp"

namespace rigid {

//! [limit]
/// (26.3): the stiffest spring that symplectic Euler bears, k h² + 2 c h = 4 m [N/m]; zero or less: the damper alone is too much.
/// \param m  what the spring moves, 1/A of its row [kg]
/// \param c  of the damper, at least 0 [N s/m]
inline Real largest_stiffness(Real m, Real c, Real h)
{
    require_positive({{"the mass", m}, {"the step", h}});
    require_not_negative({{"the damper", c}});
    return (4 * m - 2 * c * h) / (h * h);
}

/// The longest step for a spring and its damper, from the same equation, by the form of its root that subtracts nothing [s].
inline Real largest_step(Real m, Real k, Real c)
{
    require_positive({{"the mass", m}, {"the stiffness", k}});
    require_not_negative({{"the damper", c}});
    return 4 * m / (c + hypot(c, 2 * std::sqrt(k) * std::sqrt(m)));
}
//! [limit]

/// ζ of a damper with which a ball leaves with e times its speed, if its spring may pull: e = exp(−π ζ/√(1 − ζ²)).
/// A contact that only pushes leaves a little faster. \param e  more than 0, at most 1
inline Real damping_ratio_of(Real e)
{
    if (!(e > 0 && e <= 1))
        throw std::invalid_argument(
            "the part of its speed that a bounce keeps is " + shortest(e) +
            "; it must be above 0 and at most 1");
    const Real l = log(e);
    return -l / std::sqrt(pi * pi + l * l);
}

/// The spring of every row. Lengths in metres; what turns is measured at ℓ, so its stiffness is k ℓ².
struct PenaltySprings {
    Real stiffness = 1e4;    ///< k of joints and contacts [N/m]
    Real joint_ratio = 0.1;  ///< ζ of joints, with the mass that the row alone sees
    /// the same of contacts; those of a surface with e > 0 have damping_ratio_of(e)
    Real contact_ratio = 0.2;
    Real friction_ratio = 0.7;  ///< of the springs along a contact
    /// Hertz's law: contacts push with K (−C)^{3/2}; 0: with k [N/m^{3/2}]
    Real hertz = 0;
};

/// Throws std::invalid_argument, naming the setting and its value, unless all make sense.
void require_valid(const PenaltySprings& springs);

//! [hertz]
/// Two elastic balls, or one and a floor: f = K d^{3/2} at the overlap d.
struct HertzSpring {
    Real secant = 0;   ///< f/d [N/m]
    Real tangent = 0;  ///< df/dd, what (26.3) asks for [N/m]
};
inline HertzSpring hertz_spring(Real K, Real d)
{
    const Real secant = K * std::sqrt(d);  // d at least 0
    return {secant, 1.5 * secant};
}
/// The deepest overlap of a mass m that arrives with v [m], and how long it
/// touches [s]: ½ m v² = ⅖ K d^{5/2}, and 2 ∫ ds/√(1 − s^{5/2}) from 0 to 1.
inline Real hertz_overlap(Real m, Real K, Real v)
{
    require_positive({{"the mass", m}, {"K", K}, {"the speed", v}});
    return pow(5 * m * v * v / (4 * K), 0.4);
}
inline Real hertz_time(Real m, Real K, Real v)
{
    return 2.943275184324705 * hertz_overlap(m, K, v) / v;
}
//! [hertz]

//! [stretch]
/// How far a contact's point has moved along since it stuck, from step to step; and
/// how far it has rolled since its moment held it.
struct Stretch {
    Index a = world, b = 0, feature = 0;
    Real s = 0;               ///< [m], [rad]
    int part = tangent_part;  ///< or rolling_part
};
//! [stretch]

/// The correction stage: every row that has an error, and every friction row, becomes a spring.
struct SpringForces : PlainCorrection {
    PenaltySprings springs;

    // What is kept from step to step.
    std::vector<Stretch> stretched, before;

    void require_valid() const { rigid::require_valid(springs); }
    void describe(StabilizerSettings&) const {}

    /// Rows with the b and γ of springs at the end of the step; constraints with their k, c and C.
    void rows(const JointedScene& scene, const StepSettings& settings,
              StepData<3>& now);

    template <class Solver>
    void move(JointedScene& scene, const StepSettings& settings, Solver&,
              StepData<3>& now)
    {
        advance_positions(scene.bodies, settings.part(), now);
        stretch(scene.bodies.u, settings.part(), now);
    }

private:
    Real stretch_of(const Contact& contact, int part) const;
    void stretch(const VecX& u, Real h, const StepData<3>& now);
};

//! [explicit]
/// The solver stage that solves nothing: λ = h f, with C and dC/dt where the step
/// starts. A motor brings its own row to its speed, as far as its force allows.
struct ExplicitSprings : PlainSolver {
    void solve(Bodies<3>& bodies, StepData<3>& now) const
    {
        VecX& lambda = now.solution.lambda;
        lambda.resize(static_cast<Index>(now.rows.size()));
        const VecX& u = bodies.u;  // of the start
        const auto pushed = [&](std::size_t i) {
            const Constraint<3>& c = now.constraints[i];
            const Row<3>& row = now.rows[i];
            const Real rate = row.velocity(u) - row.bias;              // J u
            if (c.kind == ConstraintKind::unilateral) return Real{0};  // open
            if (c.kind == ConstraintKind::spring)
                return -now.h * (c.stiffness * c.C + c.damping * rate);
            const Real A = row.inverse_effective_mass();
            return A > 0 ? (c.speed - rate) / A : 0;
        };
        for (const bool bounded : {false, true})  // friction after its normals
            for (std::size_t i = 0; i < now.rows.size(); ++i) {
                if ((now.rows[i].bounded_by >= 0) != bounded) continue;
                const auto [lo, hi] = bounds_of(now.rows[i], lambda);
                lambda[static_cast<Index>(i)] = std::clamp(pushed(i), lo, hi);
            }
        for (const int k : now.active)
            bodies.velocity(k) = now.u_star.segment<3>(3 * k);
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            now.rows[i].apply(lambda[static_cast<Index>(i)], bodies.u);
        now.solution.status = Status::iteration_limit;  // nothing was solved
        now.solution.residual = infinity;
    }
};
//! [explicit]

//! [methods]
template <class Contacts>
struct ExplicitPenalty {
    WithJoints<WithFriction<Contacts>> contacts;
    SpringForces correction;
    ColdStart start;
    ExplicitSprings solver;
};

template <class Contacts>
struct ImplicitPenalty {
    WithJoints<WithFriction<Contacts>> contacts;
    SpringForces correction;
    WarmStart start = last_impulses();
    CoulombSolver<FindFriction> solver;
};
//! [methods]

// Compiled once, in spring_forces.cpp.
extern template void step(JointedScene&, const StepSettings&,
                          ExplicitPenalty<Manifolds>&, StepData<3>&);
extern template void step(JointedScene&, const StepSettings&,
                          ImplicitPenalty<Manifolds>&, StepData<3>&);

}  // namespace rigid
