/// \file newton_positions.hpp
/// The correction stage by Newton's method on C: a few solves of the same factor move the bodies onto their joints.
///
///     x ← x + v h,   J v = −C(x)/h     again and again, with C where the bodies are now; J of the step's start,
///                              or of now where that is no longer good enough
///
/// (15.11). First what the step itself bends away, the arcs of (15.12): velocities get it too. Then errors, and no velocity is
/// touched. Joints give back the whole of C; contacts and limits nothing up to the slop s, and beyond it the part β of what is
/// missing to half of it:
///
///     J v = −β (C + s/2)/h     where C < −s                                                               (15.17)
///
/// So an overlap ends inside the slop. If it were pushed towards the slop it would come nearer forever and never get there.
#pragma once

#include "chapters/06_sequential_impulse/restitution.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"
#include "chapters/11_rotation/rigid_scene.hpp"
#include "chapters/15_trees/arcs.hpp"
#include "chapters/15_trees/held_limits.hpp"
#include "chapters/15_trees/reflections.hpp"
#include "chapters/15_trees/renewed_rows.hpp"

#include <span>

namespace rigid {

struct NewtonPositions : NewtonSettings, Restitution, PlainCorrection {
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
    /// problems with a joint open by more than s, or an overlap > ℓ/20 given up
    int unmet = 0;
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
        rigid::require_valid(static_cast<const NewtonSettings&>(*this));
    }
    void describe(StabilizerSettings& s) const { s.beta = beta, s.slop = slop; }

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
    template <class Scene, SolvesProblems Solver>
    void move(Scene& scene, const StepSettings& settings, Solver& solver,
              StepData<3>& now)
    {
        advance_positions(scene.bodies, settings.part(), now);
        const std::size_t m = now.rows.size();
        second.bias.assign(m, 0);
        second.left_out.assign(m, 0);
        second.tolerance = tolerance * now.length / settings.part() / 10;
        deep_.assign(m, 0);
        second.solution.lambda.setZero(static_cast<Index>(m));
        if (v.size() != scene.bodies.u.size()) v.setZero(scene.bodies.u.size());
        iterations = renewals = unmet = 0, left = 0;
        gave_up_pushing = joints_alone = false;
        const auto one = [&](std::span<const int> rows, std::span<const int> bodies,
                             auto& apart, Corrected what) {
            stop_beside(rows, now.rows, scene.bodies, v);
            if (what == Corrected::arcs_and_errors)
                arcs_.follow(scene, settings.part(), rows, bodies, *this, apart,
                             second, v, now);
            correct(scene, settings.part(), rows, bodies, what, apart, now);
        };
        solver.for_each_problem(now, one);
        solver.bounce_late(scene.bodies, now);
    }
    //! [move]

    //! [newton]
    /// What is an error, by positions alone.
    template <class Scene, class Apart>
    void correct(Scene& scene, Real h, std::span<const int> rows,
                 std::span<const int> members, Corrected what, Apart& apart,
                 StepData<3>& now)
    {
        Bodies<3>& bodies = scene.bodies;
        const bool renews = what != Corrected::errors;  // sweeps keep their J
        Real pushed = 0;  // the largest part of an overlap that is to come out
        Real off = 0, best = 0, part = 1, deepest = 0;
        bool fresh = false;  // J is that of the best positions so far
        bool alone = what == Corrected::joints, gave_up = false, jointed = false;
        bool unanswered = false;  // what is to come out, if it is solved exactly
        int n = 0, times = 1;  // iterations, and how many of them a long one counts
        int begun = 0;         // the first with these rows
        if (alone) held_.hold(scene, rows, now);
        for (;; n += times) {
            const Real before = off;
            Real bent = 0;  // what J did not foresee
            off = 0, times = 1;
            bool wanted = false, touching = false, joined = false;
            for (const int i : rows) {
                Constraint<3>& c = at(now.constraints, i);
                const bool bounded = c.kind == ConstraintKind::unilateral;
                const bool held = bounded && at(now.rows, i).lo < 0;
                at(second.left_out, i) =
                    !has_error(c.kind) || (bounded && alone && !held);
                if (at(second.left_out, i)) continue;
                c = constraint_at(scene, now, static_cast<std::size_t>(i),
                                  bodies.x);
                touching = touching ||
                           (bounded && n > 0 && second.solution.lambda[i] != 0);
                // metres of a C: an angle counts as so much at the length ℓ
                const Real unit = is_angle(c) ? now.length : 1;
                if (!bounded || held) {
                    const Real error = held ? std::min(Real{0}, c.C) : c.C;
                    joined = jointed = what != Corrected::overlaps;
                    at(second.bias, i) = error / h;
                    if (!joined) continue;
                    off = std::max(off, std::abs(error) * unit);
                    if (n > 0) bent = std::max(bent, foreseen_.off(i, c.C) * unit);
                } else {
                    // (15.17): what lies too deep comes out once, by the part β
                    const Real all = slop * now.length;  // an angle's, too
                    const Real s =
                        (is_angle(c) ? all : least_slop(all, c, slops)) / unit;
                    at(second.bias, i) = std::max(Real{0}, c.C) / h;
                    if (c.C < -s && n == 0) {
                        const Real over = beta * (c.C + s / 2);
                        at(second.bias, i) = over / h;
                        pushed = std::max(pushed, -over * unit);
                        deepest = std::max(deepest, -c.C * unit);
                        at(deep_, i) = 1;
                        wanted = true;
                    }
                }
            }
            const Real allowed = std::max({best, pushed, tolerance * now.length});
            const bool worse = n > 0 && !(off <= allowed);
            if (worse) {
                best_.put_back(bodies, members);
                off = best;
            } else if (off <= tolerance * now.length && !wanted) break;
            // no answer to both: the joints, and the rest in the next step
            const bool give_up =
                touching && (n >= most_swept ||
                             (worse && second.solution.status != Status::solved));
            if (give_up) {
                alone = true, begun = n + 1;
                continue;
            }
            const int swept = alone ? 2 * most_swept : most_swept;
            if (n >= (what == Corrected::errors ? swept : most)) break;
            if (worse) {
                // with J and K of here; then half as far
                if (renews && !fresh) continue;
                part /= 2;
                move_by(v, part * h, bodies, members);
                continue;
            }
            best_.keep(bodies, members);
            best = off;
            part = 1;
            // what a round leaves beyond a tenth asks for another J where this one did
            // not foresee it; of sweeps, beyond a half, for longer rounds
            const bool slow = n > begun && off > before / 10;
            fresh = n > 0 ? renews && slow && bent > off / 10
                          : what == Corrected::joints;
            if (fresh) {
                renewed_.renew(scene, h, rows, members, second, n > 0, apart, now);
                ++renewals;
            } else if (slow && off > before / 2 && !renews)
                times = rounds(off, before, bent, swept - n);
            second.max_sweeps = wanted ? push_sweeps : times * sweeps;
            apart.solve_apart(second, v, now);
            const auto is_far = [&] {
                return goes_far(v, members, now.length, h, std::max(pushed, off));
            };
            if (wanted && what == Corrected::arcs_and_errors)
                unanswered = second.solution.status != Status::solved;
            if (wanted && is_far()) {
                // overlaps that work against each other: they stay
                gave_up = true;
                for (const int i : rows) {
                    at(deep_, i) = 0;
                    if (at(now.constraints, i).kind == ConstraintKind::unilateral)
                        at(second.bias, i) = std::max(Real{0}, at(second.bias, i));
                }
                apart.solve_apart(second, v, now);
                // nor is there an answer without them (of joints the error tells)
                if (!joined && is_far()) break;
            }
            foreseen_.note(h, rows, v, now);
            move_by(v, h, bodies, members);
            if (!joined) {  // overlaps come out once
                ++n;
                break;
            }
        }
        renewed_.put_back(rows, members, bodies, now);
        held_.let_go(now);
        iterations = std::max(iterations, n);
        left = std::max(left, off);
        unmet += (jointed && !(off <= slop * now.length)) ||
                 ((gave_up || unanswered) && deepest > now.length / 20);
        joints_alone = joints_alone || (alone && what != Corrected::joints);
        gave_up_pushing = gave_up_pushing || gave_up;
    }
    //! [newton]

    /// Whether the last sub-step pushed the two of this row apart.
    bool pushes(int row) const { return deep_[static_cast<std::size_t>(row)] != 0; }

private:
    Arcs arcs_;
    RenewedRows renewed_;
    PlacesBefore best_;  ///< with the least error so far
    ForeseenErrors foreseen_;
    std::vector<char> deep_;  ///< of each row, 1: its overlap is being repaid
    HeldLimits held_;
};

}  // namespace rigid
