/// \file block_descent.hpp
/// Body by body in place of row by row: block descent on the energy of an implicit step, and its augmented form.
///
///     G(x) = Σ ½ (x − y)ᵀ M (x − y)/h² + Σ ½ s r(x)²,   y = x₀ + h u*                                 (16.26)
///     body    Δx = H⁻¹ f,   f = −M (x − y)/h² + Σ Jᵀ F,   H = M/h² + Σ s JᵀJ + Σ |F| D              (16.28)
///     row     F = clamp(λ − s r, lo, hi);   after each sweep λ ← F, s grows with |r| while F is free    (16.30)
///
/// D has the lengths of the columns of ∂J/∂x (joint_curvature.hpp). A spring has λ = 0 and grows to its own stiffness.
/// Contacts are linear over a sub-step, C + J (x − x₀), as their authors have them. Vertex block descent \cite chen2024 and
/// its augmented form \cite giles2025, from their equations, on the constraints of this book.
#pragma once

#include "chapters/06_sequential_impulse/restitution.hpp"
#include "chapters/08_warm_starting/warm_start.hpp"
#include "chapters/16_soft_constraints/block_solve.hpp"
#include "chapters/16_soft_constraints/joint_curvature.hpp"
#include "chapters/16_soft_constraints/position_rows.hpp"

namespace rigid {

//! [settings]
/// The correction stage; solver stage FreeVelocities, start stage last_impulses().
struct BlockDescent : PlainCorrection {
    int sweeps = 10;
    Real alpha = 0.95;  ///< part of an error at the start that is left alone
    Real gamma = 0.99;  ///< part of λ and s that a step starts from
    /// growth of s: by so many m/h² for an error of one ℓ; 0 = s stays
    Real beta = 1e5;
    /// s of a hard row to begin with, and at most [m/h², m = 1/(J M⁻¹ Jᵀ)]
    Real first = 1, most = 1e9;
    bool augmented = true;  ///< false: λ = 0, a spring of stiffness s

    // What is kept from step to step.
    VecX x0, d;              ///< start of the sub-step, and x − x₀ [m]
    VecX y;                  ///< x₀ + h u* [m]
    VecX before, last;       ///< u before this sub-step and the one before [m/s]
    VecX force;              ///< λ of each row [N]
    VecX stiffness;          ///< s of each row [m/h²]
    std::vector<Real> left;  ///< the error that is left alone [m]
    std::vector<ImpulseKey> keys;
    ImpulseCache cache;  ///< of s
    RowsOfBodies meet;
    //! [settings]

    void require_valid() const;

    template <class Scene>
    void rows(const Scene& scene, const StepSettings& settings,
              StepData<Scene::dof>& now)
    {
        const Real h = settings.part();
        write_rows(scene.bodies, h, now,
                   [h](const auto& c) { return gap_bias(c, h); });
        last = before.size() == scene.bodies.u.size() ? before : scene.bodies.u;
        before = scene.bodies.u;
        if (now.substep > 0) return;
        keys.clear();
        for (const Source& source : now.sources)
            keys.push_back(key_of(source, now.contacts));
        load(cache, keys, 1, stiffness);
        meet.find<Scene::dof>(now.rows, scene.bodies.count());
    }

    //! [move]
    template <class Scene, class Solver>
    void move(Scene& scene, const StepSettings& settings, Solver&,
              StepData<Scene::dof>& now)
    {
        constexpr int Dof = Scene::dof;
        auto& bodies = scene.bodies;
        const Real h = settings.part();
        begin(bodies, h, now);
        // contacts are linear over a sub-step, joints follow their curve
        const auto at = [&](std::size_t i) {
            if (now.sources[i].of == Source::Of::joint)
                return constraint_at(scene, now, i, bodies.x);
            Constraint<Dof> c = now.constraints[i];
            c.C += along(c, d);
            return c;
        };
        now.visits += find_curvatures(scene, now, meet);
        for (int s = 0; s < sweeps; ++s) {
            for (const int k : now.active)
                if (bodies.can_move(k)) visit(k, h, at, now, bodies);
            for (std::size_t i = 0; i < now.rows.size(); ++i)
                raise(i, h, at(i), now);  // (16.30)
        }
        now.visits += 3 * static_cast<std::int64_t>(now.rows.size()) * sweeps;
        for (const int k : now.active)
            bodies.velocity(k) = d.template segment<Dof>(Dof * k) / h;
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            now.solution.lambda[static_cast<Index>(i)] =
                h * (is_augmented(now.rows[i])
                         ? force[static_cast<Index>(i)]
                         : push(i, stiffness_of(i, h, now), at(i), h, now));
        if (now.substep + 1 == settings.substeps) store(cache, keys, stiffness, 1);
    }

    /// (16.28): one body, all others where they are.
    template <int Dof, class At>
    void visit(int k, Real h, const At& at, const StepData<Dof>& now,
               Bodies<Dof>& bodies)
    {
        const Vec<Dof> W = bodies.inverse_mass.template segment<Dof>(Dof * k),
                       inertia = W.cwiseInverse() / (h * h);
        Vec<Dof> f = -inertia.cwiseProduct(bodies.position(k) -
                                           y.template segment<Dof>(Dof * k));
        Mat<Dof> H = inertia.asDiagonal();
        for (const RowsOfBodies::Meeting& one : meet.of(k)) {
            const auto i = static_cast<std::size_t>(one.row);
            const Constraint<Dof> c = at(i);
            const RowVec<Dof>& J = one.is_a ? c.Ja : c.Jb;
            const Real s = stiffness_of(i, h, now), F = push(i, s, c, h, now);
            f += J.transpose() * F;
            H += s * J.transpose() * J;
            H += (std::abs(F) * meet.curvature<Dof>(one)).asDiagonal();
        }
        for (int i = 0; i < Dof; ++i) {
            if (W[i] > 0) continue;
            // nothing pushes it that way: (16.28) is Δx = 0
            f[i] = 0;
            H.row(i).setZero();
            H.col(i).setZero();
            H(i, i) = 1;
        }
        const Vec<Dof> change = solve_definite(H, f);
        bodies.position(k) += change;
        d.template segment<Dof>(Dof * k) += change;
    }
    //! [move]

    //! [row]
    /// s of a row [N/m]. A spring has no more than its own.
    template <int Dof>
    Real stiffness_of(std::size_t i, Real h, const StepData<Dof>& now) const
    {
        const Row<Dof>& row = now.rows[i];
        const Real A = row.inverse_effective_mass();
        if (!(A > 0)) return 0;  // it pushes nothing
        const Real s = stiffness[static_cast<Index>(i)] / (h * h * A);
        return row.softness > 0 ? std::min(s, 1 / (h * h * row.softness)) : s;
    }

    /// F of (16.30).
    template <int Dof>
    Real push(std::size_t i, Real s, const Constraint<Dof>& c, Real h,
              const StepData<Dof>& now) const
    {
        const auto [lo, hi] = bounds(now.rows[i], h);
        const Real r = position_residual(c, along(c, d), h) - left[i];
        return std::clamp(force[static_cast<Index>(i)] - s * r, lo, hi);
    }

    /// (16.30) after a sweep: λ, and s where the force is free.
    template <int Dof>
    void raise(std::size_t i, Real h, const Constraint<Dof>& c,
               const StepData<Dof>& now)
    {
        const auto index = static_cast<Index>(i);
        const Real s = stiffness_of(i, h, now), F = push(i, s, c, h, now);
        const auto [lo, hi] = bounds(now.rows[i], h);
        const Real r = position_residual(c, along(c, d), h) - left[i];
        if (is_augmented(now.rows[i])) force[index] = F;
        if (F > lo && F < hi)
            stiffness[index] =
                std::min(most, stiffness[index] + beta * std::abs(r) / now.length);
    }
    //! [row]

private:
    /// A spring needs no λ: its stiffness is what it is.
    template <int Dof>
    bool is_augmented(const Row<Dof>& row) const
    {
        return augmented && !(row.softness > 0);
    }

    template <int Dof>
    std::pair<Real, Real> bounds(const Row<Dof>& row, Real h) const
    {
        if (row.bounded_by < 0) return {row.lo / h, row.hi / h};
        const Real bound = row.friction * std::max(Real{0}, force[row.bounded_by]);
        return {-bound, bound};
    }

    //! [begin]
    /// Where x, λ and s start. A body that its contacts hold starts where it is, one
    /// that falls starts where it falls to.
    template <int Dof>
    void begin(Bodies<Dof>& bodies, Real h, const StepData<Dof>& now)
    {
        x0 = y = bodies.x;
        d.setZero(x0.size());
        for (const int k : now.active) {
            const Index at = Dof * k;
            const Vec<Dof> u = before.template segment<Dof>(at),
                           pull = now.u_star.template segment<Dof>(at) - u,
                           change = u - last.template segment<Dof>(at);
            const Real square = pull.squaredNorm();
            const Real part =
                square > 0 ? std::clamp<Real>(pull.dot(change) / square, 0, 1) : 0;
            y.template segment<Dof>(at) += h * now.u_star.template segment<Dof>(at);
            d.template segment<Dof>(at) = h * (u + part * pull);
            bodies.position(k) += d.template segment<Dof>(at);
        }
        const auto m = static_cast<Index>(now.rows.size());
        force.setZero(m);
        left.assign(now.rows.size(), 0);
        for (Index i = 0; i < m; ++i) {
            const auto row = static_cast<std::size_t>(i);
            const Constraint<Dof>& c = now.constraints[row];
            if (is_augmented(now.rows[row]))
                force[i] = alpha * gamma / h * now.solution.lambda[i];
            stiffness[i] = std::clamp(gamma * stiffness[i], first, most);
            if (!augmented || !has_error(c.kind)) continue;
            left[row] = alpha * (c.kind == ConstraintKind::unilateral
                                     ? std::min(Real{0}, c.C)
                                     : c.C);
        }
    }
    //! [begin]
};

}  // namespace rigid
