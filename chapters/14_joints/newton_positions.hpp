/// \file newton_positions.hpp
/// The correction stage by Newton's method on C: a few solves of the same factor move the bodies onto their joints.
///
///     x ← x + v h,   J v = −C(x)/h     again and again, with C where the bodies are now; J of the step's start,
///                              or of now where that is no longer good enough
///
/// (14.17). No velocity is touched. Joints give back the whole of C; contacts and limits nothing up to the slop s, and
/// beyond it the part β of what is missing to half of it:
///
///     J v = −β (C + s/2)/h     where C < −s                                                               (14.17a)
///
/// So an overlap ends inside the slop. If it were pushed towards the slop it would come nearer forever and never get there.
#pragma once

#include "chapters/06_sequential_impulse/restitution.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"

namespace rigid {

struct NewtonSettings {
    int most = 8;  ///< iterations a sub-step
    /// they end when no joint is off by more than this [ℓ]
    Real tolerance = 1e-9;
    Real beta = 0.2;       ///< part of an overlap that a sub-step takes back
    Real slop = 5e-3;      ///< s, an overlap of up to this much is left alone [ℓ]
    int sweeps = 10;       ///< of solvers that sweep, in an iteration
    int push_sweeps = 10;  ///< the same where overlaps are to come out
};

struct NewtonPositions : NewtonSettings, Restitution {
    // Of the last step.
    int iterations = 0;
    Real left = 0;  ///< the largest |C| of a joint that was found last [m, rad]
    bool gave_up_pushing = false;  ///< overlaps were left, in the last sub-step
    bool joints_alone = false;     ///< what overlaps gave way, in the last sub-step

    /// of each body: a contact's overlap that is left alone, at most [m]; empty = slop
    std::vector<Real> slops;

    SecondProblem second;
    VecX v;            ///< pseudo-velocities [m/s]
    int renewals = 0;  ///< of J, in the last sub-step

    void require_valid() const
    {
        rigid::require_valid(static_cast<const Restitution&>(*this));
        if (most < 0 || sweeps < 0 || push_sweeps < 0)
            throw std::invalid_argument(
                "Newton's method has " + std::to_string(most) + " iterations of " +
                std::to_string(std::min(sweeps, push_sweeps)) +
                " sweeps; both must be zero or positive");
        if (!(tolerance >= 0) || !(slop >= 0) || !(beta >= 0 && beta <= 1))
            throw std::invalid_argument(
                "Newton's method has the tolerance " + shortest(tolerance) +
                ", the slop " + shortest(slop) + " and beta " + shortest(beta) +
                "; they must be zero or positive, and beta at most 1");
    }

    template <class Scene>
    void rows(const Scene& scene, const StepSettings& settings,
              StepData<3>& now) const
    {
        const Real h = settings.part();
        write_rows(scene.bodies, h, now, [h](const auto& c) {
            if (!has_error(c.kind)) return own_bias(c, h);
            return c.kind == ConstraintKind::unilateral && c.C > 0 ? c.C / h : 0;
        });
        add_bounces(scene, *this, settings, now);
    }

    //! [newton]
    template <class Scene, class Solver>
    void move(Scene& scene, const StepSettings& settings, Solver& solver,
              StepData<3>& now)
    {
        auto& bodies = scene.bodies;
        const Real h = settings.part();
        advance_positions(bodies, h, now);
        const std::size_t m = now.rows.size();
        second.bias.assign(m, 0);
        second.left_out.assign(m, 0);
        deep_.assign(m, 0);
        second.tolerance = tolerance * now.length / h / 10;
        if (v.size() != bodies.u.size()) v.setZero(bodies.u.size());
        renewals = 0;
        gave_up_pushing = false;
        Real pushed = 0;  // the largest part of an overlap that is to come out
        Real best = 0, part = 1;
        bool fresh = false;  // J is that of the best positions so far
        joints_alone = false;
        for (iterations = 0;; ++iterations) {
            const Real before = left;
            left = 0;
            bool wanted = false, touching = false, joined = false;
            for (std::size_t i = 0; i < m; ++i) {
                Constraint<3>& c = now.constraints[i];
                const bool bounded = c.kind == ConstraintKind::unilateral;
                second.left_out[i] =
                    !has_error(c.kind) || (bounded && joints_alone);
                if (second.left_out[i]) continue;
                c = constraint_at(scene, now, i, bodies.x);
                touching = touching || bounded;
                // metres of a C: an angle counts as so much at the length ℓ
                const Real unit = is_angle(c) ? now.length : 1;
                if (c.kind == ConstraintKind::bilateral) {
                    joined = true;
                    second.bias[i] = c.C / h;
                    left = std::max(left, std::abs(c.C) * unit);
                } else {
                    // (14.17a): what lies too deep comes out once, by the part β
                    const Real s = slop_of(c, now.length) / unit;
                    second.bias[i] = std::max(Real{0}, c.C) / h;
                    if (c.C < -s && iterations == 0) {
                        const Real over = beta * (c.C + s / 2);
                        second.bias[i] = over / h;
                        pushed = std::max(pushed, -over * unit);
                        deep_[i] = 1;
                        wanted = true;
                    }
                }
            }
            const Real allowed = std::max({best, pushed, tolerance * now.length});
            const bool worse = iterations > 0 && !(left <= allowed);
            if (worse) {
                put_back(bodies, now);
                left = best;
            } else if (left <= tolerance * now.length && !wanted) break;
            // no answer to both: the joints, and the rest in the next step
            const bool give_up =
                touching && (iterations >= most ||
                             (worse && second.solution.status != Status::solved));
            if (give_up) {
                joints_alone = true;
                continue;
            }
            if (iterations >= (joints_alone ? 2 * most : most)) break;
            if (worse) {
                if (!fresh) continue;  // with the J of here; then half as far
                part /= 2;
                go(bodies, part * h, now);
                continue;
            }
            keep(bodies, now);
            best = left;
            part = 1;
            // the old J is good enough while it takes nine tenths of the error
            fresh = iterations > 0 && left > before / 10;
            if (fresh) renew(scene, solver, now);
            second.max_sweeps = wanted ? push_sweeps : sweeps;
            solver.solve_apart(second, v, now);
            if (wanted && goes_far(now, h, std::max(pushed, left))) {
                // overlaps that work against each other: they stay
                gave_up_pushing = true;
                deep_.assign(m, 0);
                for (std::size_t i = 0; i < m; ++i)
                    if (now.constraints[i].kind == ConstraintKind::unilateral)
                        second.bias[i] = std::max(Real{0}, second.bias[i]);
                solver.solve_apart(second, v, now);
            }
            go(bodies, h, now);
            if (!joined) {  // overlaps come out once
                ++iterations;
                break;
            }
        }
        if (renewals > 0) now.rows.swap(rows_);  // those that λ belongs to
    }
    //! [newton]

    /// Whether the last sub-step pushed the two of this row apart.
    bool pushes(int row) const { return deep_[static_cast<std::size_t>(row)] != 0; }

private:
    void go(Bodies<3>& bodies, Real h, const StepData<3>& now) const
    {
        for (const int k : now.active) bodies.integrate(k, v.segment<3>(3 * k), h);
    }
    void keep(const Bodies<3>& bodies, const StepData<3>& now)
    {
        kept_.resize(bodies.x.size());
        for (const int k : now.active) kept_.segment<3>(3 * k) = bodies.position(k);
    }
    void put_back(Bodies<3>& bodies, const StepData<3>& now) const
    {
        for (const int k : now.active) bodies.position(k) = kept_.segment<3>(3 * k);
    }

    Real slop_of(const Constraint<3>& c, Real length) const
    {
        Real least = slop * length;
        if (is_angle(c)) return least;  // a body's own is one of metres
        for (const Index k : {c.a, c.b})
            if (k != world && k < static_cast<Index>(slops.size()))
                least = std::min(least, slops[static_cast<std::size_t>(k)]);
        return least;
    }

    /// Whether C is in radians: its row moves no centroid.
    static bool is_angle(const Constraint<3>& c)
    {
        return c.Jb.head<2>().isZero(0) &&
               (c.a == world || c.Ja.head<2>().isZero(0));
    }

    /// Whether v moves a body much farther than what is to be corrected, and by more than a twentieth of ℓ.
    bool goes_far(const StepData<3>& now, Real h, Real wanted) const
    {
        Real farthest = 0;
        for (const int k : now.active)
            farthest = std::max(farthest, h * v.segment<2>(3 * k).norm());
        return !(farthest <= std::max(8 * wanted, now.length / 20));
    }

    /// J where the bodies are now, for solvers that have a factor of it.
    template <class Scene, class Solver>
    void renew(const Scene& scene, Solver& solver, StepData<3>& now)
    {
        const Bodies<3>& bodies = scene.bodies;
        if constexpr (requires { solver.factor_again(bodies, now); }) {
            if (renewals++ == 0) rows_ = now.rows;
            for (std::size_t i = 0; i < now.rows.size(); ++i) {
                if (second.left_out[i])  // not looked at yet
                    now.constraints[i] = constraint_at(scene, now, i, bodies.x);
                const Row<3> row =
                    bilateral(now.constraints[i], bodies.inverse_mass);
                now.rows[i].Ja = row.Ja, now.rows[i].Jb = row.Jb;
                now.rows[i].Wa = row.Wa, now.rows[i].Wb = row.Wb;
            }
            solver.factor_again(bodies, now);
        }
    }
    std::vector<Row<3>> rows_;
    std::vector<char> deep_;  ///< of each row, 1: its overlap is being repaid
    VecX kept_;  ///< positions of the active bodies with the least error so far
};

}  // namespace rigid
