/// \file newton_positions.hpp
/// The correction stage by Newton's method on C: a few solves of the same factor move the bodies onto their joints.
///
///     x ← x + v h,   J v = −C(x)/h     again and again, with C where the bodies are now; J of the step's start,
///                              or of now where that is no longer good enough
///
/// (14.17). First what the step itself bends away, the arcs, and there velocities get the same as positions (14.17b): x moves
/// by h u, J u = 0 where it began, and a body on a rod is a chord of its circle too far. That is SHAKE \cite ryckaert1977, and
/// keeps the energy as RATTLE does. Then errors, and no velocity is touched. Joints give back the whole of C; contacts and limits nothing up to the slop s, and
/// beyond it the part β of what is missing to half of it:
///
///     J v = −β (C + s/2)/h     where C < −s                                                               (14.17a)
///
/// So an overlap ends inside the slop. If it were pushed towards the slop it would come nearer forever and never get there.
#pragma once

#include "chapters/06_sequential_impulse/restitution.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"
#include "chapters/11_rotation/rigid_scene.hpp"
#include "chapters/14_joints/reflections.hpp"

#include <span>

namespace rigid {

/// A solver that has the rows of a step as problems of their own, islands: it calls visit(rows, bodies, apart, at_once) for
/// each of them, where apart.solve_apart() solves other biases on these rows alone, and at_once says that its joints are then
/// met, not swept. What has none is one problem.
template <class Solver>
concept SolvesProblems = requires(Solver solver, const StepData<3>& now)
{
    solver.for_each_problem(
        now, [](std::span<const int>, std::span<const int>, auto&, bool) {});
};

struct NewtonSettings {
    int most = 8;          ///< iterations a sub-step, for errors
    int most_follow = 20;  ///< and for the arcs; each halves what is left
    /// they end when no joint is off by more than this [ℓ]
    Real tolerance = 1e-9;
    Real beta = 0.2;       ///< part of an overlap that a sub-step takes back
    Real slop = 5e-3;      ///< s, an overlap of up to this much is left alone [ℓ]
    int sweeps = 10;       ///< of solvers that sweep, in an iteration
    int push_sweeps = 10;  ///< the same where overlaps are to come out
};

struct NewtonPositions : NewtonSettings, Restitution {
private:
    template <class List>
    static auto& at(List& list, int i)
    {
        return list[static_cast<std::size_t>(i)];
    }

public:
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
        note_bounces(scene, *this, settings, now);
        now.besides.setZero(static_cast<Index>(now.rows.size()));
    }

    //! [move]
    /// x ← x + h u, then each problem of the step by itself: the arcs, then errors.
    template <class Scene, class Solver>
    void move(Scene& scene, const StepSettings& settings, Solver& solver,
              StepData<3>& now)
    {
        advance_positions(scene.bodies, settings.part(), now);
        const std::size_t m = now.rows.size();
        second.bias.assign(m, 0);
        second.left_out.assign(m, 0);
        second.tolerance = tolerance * now.length / settings.part() / 10;
        deep_.assign(m, 0);
        goal_.resize(m);
        gained_.resize(scene.bodies.u.size());
        impulse_.resize(static_cast<Index>(m));
        second.solution.lambda.setZero(static_cast<Index>(m));
        if (v.size() != scene.bodies.u.size()) v.setZero(scene.bodies.u.size());
        iterations = renewals = 0;
        left = 0;
        gave_up_pushing = joints_alone = false;
        const auto one = [&](std::span<const int> rows, std::span<const int> bodies,
                             auto& apart, bool at_once) {
            if (at_once) follow(scene, settings.part(), rows, bodies, apart, now);
            correct(scene, settings.part(), rows, bodies, apart, now);
        };
        if constexpr (SolvesProblems<Solver>) solver.for_each_problem(now, one);
        else {
            all_.resize(m);
            std::iota(all_.begin(), all_.end(), 0);
            one(all_, now.active, solver, true);
        }
    }
    //! [move]

    //! [follow]
    /// (14.17b): C is to be what it was before x moved. Velocities get what positions
    /// get, along the J of the step's start, so nothing of the motion is lost. Where
    /// that J is too old to get there, neither gets anything.
    template <class Scene, class Apart>
    void follow(Scene& scene, Real h, std::span<const int> rows,
                std::span<const int> members, Apart& apart, StepData<3>& now)
    {
        Bodies<3>& bodies = scene.bodies;
        bool joined = false;
        for (const int i : rows) {
            const Constraint<3>& c = at(now.constraints, i);
            at(second.left_out, i) = !has_error(c.kind) && !holds_speed(c, now, i);
            at(second.bias, i) = 0;
            // what Newton's method left is no error of its own
            const bool met = std::abs(c.C) * (is_angle(c) ? now.length : 1) <=
                             10 * tolerance * now.length;
            at(goal_, i) = c.kind != ConstraintKind::bilateral
                               ? std::min(Real{0}, c.C)
                           : met ? 0
                                 : c.C;
            if (is_of_joint(now, i) && has_no_direction(scene, at(now.sources, i)))
                return;
            joined = joined || (has_error(c.kind) && is_of_joint(now, i));
        }
        if (!joined) return;
        keep(bodies, members);
        for (const int k : members) gained_.segment<3>(3 * k).setZero();
        for (const int i : rows) impulse_[i] = 0;
        second.max_sweeps = sweeps;
        Real before = infinity;
        for (int n = 0;; ++n) {
            Real off = 0;
            for (const int i : rows) {
                if (at(second.left_out, i)) continue;
                const Constraint<3>& old = at(now.constraints, i);
                if (!has_error(old.kind)) continue;
                const Constraint<3> c = constraint_at(
                    scene, now, static_cast<std::size_t>(i), bodies.x);
                if (!is_of_joint(now, i)) {
                    at(second.bias, i) = std::max(Real{0}, c.C) / h;
                    continue;
                }
                const Real error = c.C - at(goal_, i);
                at(second.bias, i) = error / h;
                const bool pulls = c.kind == ConstraintKind::bilateral;
                off = std::max(off, (pulls ? std::abs(error) : -error) *
                                        (is_angle(c) ? now.length : 1));
            }
            if (off <= tolerance * now.length) break;
            // solves are right to 1e-9 ℓ/s where rows have bounds
            const bool near = off <= 1e-8 * h * now.length;
            if (near && !(off < before / 2)) break;
            if (n == most_follow || !(off < before / 2)) {
                put_back(bodies, members);
                return;
            }
            before = off;
            second.arcs = true;
            apart.solve_apart(second, v, now);
            second.arcs = false;
            go(bodies, members, h);
            for (const int k : members)
                gained_.segment<3>(3 * k) += v.segment<3>(3 * k);
            for (const int i : rows) impulse_[i] += second.solution.lambda[i];
        }
        for (const int k : members) bodies.velocity(k) += gained_.segment<3>(3 * k);
        for (const int i : rows) {
            now.solution.lambda[i] += impulse_[i];
            now.besides[i] += impulse_[i];
        }
    }
    //! [follow]

    //! [newton]
    /// What is an error, by positions alone.
    template <class Scene, class Apart>
    void correct(Scene& scene, Real h, std::span<const int> rows,
                 std::span<const int> members, Apart& apart, StepData<3>& now)
    {
        Bodies<3>& bodies = scene.bodies;
        Real pushed = 0;  // the largest part of an overlap that is to come out
        Real off = 0, best = 0, part = 1;
        bool fresh = false;  // J is that of the best positions so far
        bool renewed = false, alone = false, gave_up = false;
        int n = 0;
        for (;; ++n) {
            const Real before = off;
            off = 0;
            bool wanted = false, touching = false, joined = false;
            for (const int i : rows) {
                Constraint<3>& c = at(now.constraints, i);
                const bool bounded = c.kind == ConstraintKind::unilateral;
                at(second.left_out, i) = !has_error(c.kind) || (bounded && alone);
                if (at(second.left_out, i)) continue;
                c = constraint_at(scene, now, static_cast<std::size_t>(i),
                                  bodies.x);
                touching = touching ||
                           (bounded && n > 0 && second.solution.lambda[i] != 0);
                // metres of a C: an angle counts as so much at the length ℓ
                const Real unit = is_angle(c) ? now.length : 1;
                if (c.kind == ConstraintKind::bilateral) {
                    joined = true;
                    at(second.bias, i) = c.C / h;
                    off = std::max(off, std::abs(c.C) * unit);
                } else {
                    // (14.17a): what lies too deep comes out once, by the part β
                    const Real s = slop_of(c, now.length) / unit;
                    at(second.bias, i) = std::max(Real{0}, c.C) / h;
                    if (c.C < -s && n == 0) {
                        const Real over = beta * (c.C + s / 2);
                        at(second.bias, i) = over / h;
                        pushed = std::max(pushed, -over * unit);
                        at(deep_, i) = 1;
                        wanted = true;
                    }
                }
            }
            const Real allowed = std::max({best, pushed, tolerance * now.length});
            const bool worse = n > 0 && !(off <= allowed);
            if (worse) {
                put_back(bodies, members);
                off = best;
            } else if (off <= tolerance * now.length && !wanted) break;
            // no answer to both: the joints, and the rest in the next step
            const bool give_up =
                touching &&
                (n >= most || (worse && second.solution.status != Status::solved));
            if (give_up) {
                alone = true;
                continue;
            }
            if (n >= (alone ? 2 * most : most)) break;
            if (worse) {
                if (!fresh) continue;  // with the J of here; then half as far
                part /= 2;
                go(bodies, members, part * h);
                continue;
            }
            keep(bodies, members);
            best = off;
            part = 1;
            // the old J is good enough while it takes nine tenths of the error
            fresh = n > 0 && off > before / 10;
            if (fresh) renewed = renew(scene, rows, apart, now, renewed);
            second.max_sweeps = wanted ? push_sweeps : sweeps;
            apart.solve_apart(second, v, now);
            if (wanted && goes_far(members, now.length, h, std::max(pushed, off))) {
                // overlaps that work against each other: they stay
                gave_up = true;
                for (const int i : rows) {
                    at(deep_, i) = 0;
                    if (at(now.constraints, i).kind == ConstraintKind::unilateral)
                        at(second.bias, i) = std::max(Real{0}, at(second.bias, i));
                }
                apart.solve_apart(second, v, now);
            }
            go(bodies, members, h);
            if (!joined) {  // overlaps come out once
                ++n;
                break;
            }
        }
        if (renewed)  // those that λ belongs to
            for (const int i : rows) std::swap(at(now.rows, i), at(rows_, i));
        iterations = std::max(iterations, n);
        left = std::max(left, off);
        joints_alone = joints_alone || alone;
        gave_up_pushing = gave_up_pushing || gave_up;
    }
    //! [newton]

    /// Whether the last sub-step pushed the two of this row apart.
    bool pushes(int row) const { return deep_[static_cast<std::size_t>(row)] != 0; }

private:
    /// Whether the arcs are to leave J u as it is: of an inerter, and of a joint's motor as far as it can.
    static bool holds_speed(const Constraint<3>& c, const StepData<3>& now, int i)
    {
        return c.kind == ConstraintKind::inerter ||
               (c.kind == ConstraintKind::motor && is_of_joint(now, i));
    }
    /// A distance of zero: J of the step's start says nothing of its end.
    template <class Scene>
    static bool has_no_direction(const Scene& scene, const Source& source)
    {
        const PointJoint& joint =
            scene.joints[static_cast<std::size_t>(source.index)];
        return joint.measure == PointJoint::Measure::distance && joint.length == 0;
    }
    static bool is_of_joint(const StepData<3>& now, int row)
    {
        return at(now.sources, row).of == Source::Of::joint;
    }
    void go(Bodies<3>& bodies, std::span<const int> members, Real h) const
    {
        for (const int k : members) bodies.integrate(k, v.segment<3>(3 * k), h);
    }
    void keep(const Bodies<3>& bodies, std::span<const int> members)
    {
        kept_.resize(bodies.x.size());
        for (const int k : members) kept_.segment<3>(3 * k) = bodies.position(k);
    }
    void put_back(Bodies<3>& bodies, std::span<const int> members) const
    {
        for (const int k : members) bodies.position(k) = kept_.segment<3>(3 * k);
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
    bool goes_far(std::span<const int> members, Real length, Real h,
                  Real wanted) const
    {
        Real farthest = 0;
        for (const int k : members)
            farthest = std::max(farthest, h * v.segment<2>(3 * k).norm());
        return !(farthest <= std::max(8 * wanted, length / 20));
    }

    /// J where the bodies are now.
    /// \param again  whether the rows of the step are kept already
    template <class Scene, class Apart>
    bool renew(const Scene& scene, std::span<const int> rows, Apart& apart,
               StepData<3>& now, bool again)
    {
        const Bodies<3>& bodies = scene.bodies;
        // a solver that has no factor of J has nothing to renew
        if constexpr (!requires { apart.factor_again(bodies, now); }) return false;
        else {
            ++renewals;
            rows_.resize(now.rows.size());
            for (const int i : rows) {
                Row<3>& row = at(now.rows, i);
                if (!again) at(rows_, i) = row;
                Constraint<3>& c = at(now.constraints, i);
                if (at(second.left_out, i))  // not looked at yet
                    c = constraint_at(scene, now, static_cast<std::size_t>(i),
                                      bodies.x);
                const Row<3> fresh = bilateral(c, bodies.inverse_mass);
                row.Ja = fresh.Ja, row.Jb = fresh.Jb;
                row.Wa = fresh.Wa, row.Wb = fresh.Wb;
            }
            apart.factor_again(bodies, now);
            return true;
        }
    }
    std::vector<int> all_;      ///< rows
    std::vector<Row<3>> rows_;  ///< of the step, where J was renewed
    std::vector<char> deep_;    ///< of each row, 1: its overlap is being repaid
    std::vector<Real> goal_;    ///< C of each row where the step began [m, rad]
    VecX kept_;     ///< positions of the bodies with the least error so far
    VecX gained_;   ///< velocities, by the arcs [m/s]
    VecX impulse_;  ///< of each row, by the arcs [N s]
};

}  // namespace rigid
