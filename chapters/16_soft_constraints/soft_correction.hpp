/// \file soft_correction.hpp
/// The correction stage of the step where joints and contacts are stiff springs.
///
///     rows    w = J u + b + γ λ             b, γ by (16.8); a gap: b = C/h, γ = 0
///             w = J u + b + γ (λ − λ⁻)      preloaded: λ⁻ is the impulse of the step before, (16.15)
///     move    x ← x + h u                   with the velocity that corrects
///             w = J u                       relaxation: the same rows, hard and without b, from the same u*
///
/// What carries a load sags by the load over the stiffness (16.11). Preloaded by the load it does not. \cite catto2011
#pragma once

#include "chapters/07_baumgarte/correction.hpp"
#include "chapters/16_soft_constraints/softness.hpp"

namespace rigid {

/// What becomes of the velocity that was only there to correct.
enum class SoftFinish : unsigned char {
    none,        ///< it stays
    relaxation,  ///< the solver answers the hard rows without b: it goes
    /// the same, and after the last sub-step x is moved until no error is left
    projection,
};

//! [soft_correction]
struct SoftCorrection : Restitution, PlainCorrection {
    Softness contacts{30, 10}, joints{60, 2};
    /// turns of a spring in a sub-step, at most: sweeps get slower with stiffer rows
    Real most_turn = 0.25;
    Real push_out = infinity;  ///< an error is corrected at most so fast [ℓ/s]
    SoftFinish finish = SoftFinish::relaxation;
    bool preloaded = false;
    /// of the finish by projection
    StabilizerSettings repair{Stabilizer::projection, 1, 0, 0, infinity, 100, 1e-9};

    // What is kept from step to step.
    std::vector<Real> goal;      ///< of projection [m]
    std::vector<char> bounces_;  ///< 1: the row is a bounce

    void require_valid() const
    {
        rigid::require_valid(static_cast<const Restitution&>(*this));
        rigid::require_valid(contacts, "contacts");
        rigid::require_valid(joints, "joints");
        rigid::require_valid(repair);
        if (!(most_turn > 0))
            throw std::invalid_argument("most_turn is " + shortest(most_turn) +
                                        "; it must be positive");
        if (!(push_out >= 0))
            throw std::invalid_argument("push_out is " + shortest(push_out) +
                                        "; it must be zero or positive");
    }

    /// The spring of a constraint in a sub-step of h.
    Softness softness(ConstraintKind kind, bool bounces, Real h) const
    {
        Softness how =
            kind == ConstraintKind::unilateral && bounces ? contacts : joints;
        how.frequency = std::min(how.frequency, most_turn / h);
        return how;
    }

    //! [rows]
    template <class Scene>
    void rows(const Scene& scene, const StepSettings& settings,
              StepData<Scene::dof>& now)
    {
        const Real h = settings.part();
        write_rows(scene.bodies, h, now,
                   [h](const auto& c) { return gap_bias(c, h); });
        const VecX& last = now.solution.lambda;
        const bool known =
            preloaded && last.size() == static_cast<Index>(now.rows.size());
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const auto& c = now.constraints[i];
            auto& row = now.rows[i];
            if (!has_error(c.kind)) continue;
            row.softness = 0;
            if (c.kind == ConstraintKind::unilateral && c.C > 0) continue;
            const Softness how = softness(c.kind, c.bounces, h);
            soften(soft_terms(how, row.inverse_effective_mass(), h), c.C,
                   push_out * now.length, row);
            if (known)  // (16.15)
                row.bias -= row.softness * last[static_cast<Index>(i)];
        }
        find_bounces(scene, settings, now);
    }
    //! [rows]

    //! [move]
    template <class Scene, class Solver>
    void move(Scene& scene, const StepSettings& settings, Solver& solver,
              StepData<Scene::dof>& now)
    {
        auto& bodies = scene.bodies;
        const Real h = settings.part();
        if (finish == SoftFinish::none) {
            advance_positions(bodies, h, now);
            return;
        }
        harden(bodies.u, h, now);
        advance_positions(bodies, h, now);
        solver.solve(bodies, now);
        if (finish == SoftFinish::projection &&
            now.substep + 1 == settings.substeps)
            now.visits += project_positions<Scene::dof>(
                [&](std::size_t i, const VecX& x) {
                    return constraint_at(scene, now, i, x);
                },
                now.constraints.size(), bodies.inverse_mass,
                in_metres(repair, now.length), settings.h, goal, bodies.x);
    }

    /// The rows of relaxation: of joints and contacts J u = 0, of a gap what is left
    /// of it after this step, of a bounce what it is.
    /// \param u  of the answer of the soft rows [m/s]
    template <int Dof>
    void harden(const VecX& u, Real h, StepData<Dof>& now) const
    {
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const Constraint<Dof>& c = now.constraints[i];
            Row<Dof>& row = now.rows[i];
            if (!has_error(c.kind) || bounces_[i]) continue;
            row.softness = 0;
            row.bias = 0;
            if (c.kind == ConstraintKind::unilateral && c.C > 0)
                row.bias = std::max(Real{0}, predicted(row, c.C, u, h)) / h;
        }
    }
    //! [move]

private:
    /// Chapter 6's bounces: such a row is hard.
    template <class Scene>
    void find_bounces(const Scene& scene, const StepSettings& settings,
                      StepData<Scene::dof>& now)
    {
        bounces_.assign(now.rows.size(), 0);
        before_.resize(now.rows.size());
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            before_[i] = now.rows[i].bias;
        add_bounces(scene, *this, settings, now);
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            bounces_[i] = now.rows[i].bias < before_[i];
            if (bounces_[i]) now.rows[i].softness = 0;
        }
    }

    std::vector<Real> before_;
};
//! [soft_correction]

}  // namespace rigid
