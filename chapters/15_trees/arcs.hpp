/// \file arcs.hpp
/// What a step bends away: x moves by h u, and J u = 0 where it began, so a body on a rod is a chord of its circle too far.
///
///     C(x) = C before,   x ← x + h v,   u ← u + v,   J v = −(C − C before)/h      again and again        (15.12)
///
/// J is that of the step's start, and velocities get the same as positions. That is SHAKE \cite ryckaert1977, and keeps the
/// energy as RATTLE does.
#pragma once

#include "chapters/11_rotation/rigid_scene.hpp"
#include "chapters/15_trees/newton_settings.hpp"

#include <span>

namespace rigid {

struct Arcs {
    //! [follow]
    /// Where J of the step's start is too old to get there, neither positions nor
    /// velocities get anything.
    template <class Scene, class Apart>
    void follow(Scene& scene, Real h, std::span<const int> rows,
                std::span<const int> members, const NewtonSettings& newton,
                Apart& apart, SecondProblem& second, VecX& v, StepData<3>& now)
    {
        Bodies<3>& bodies = scene.bodies;
        if (!begin(scene, rows, newton, second, now)) return;
        for (const int k : members) gained_.segment<3>(3 * k).setZero();
        before_.keep(bodies, members);
        second.max_sweeps = newton.sweeps;
        Real left = infinity;
        for (int n = 0;; ++n) {
            const Real off = find_errors(scene, h, rows, second, now);
            if (off <= newton.tolerance * now.length) break;
            // solves are right to 1e-9 ℓ/s where rows have bounds
            const bool near = off <= 1e-8 * h * now.length;
            if (near && !(off < left / 2)) break;
            if (n == newton.most_follow || !(off < left / 2)) {
                before_.put_back(bodies, members);
                return;
            }
            left = off;
            second.arcs = true;
            apart.solve_apart(second, v, now);
            second.arcs = false;
            move_by(v, h, bodies, members);
            for (const int k : members)
                gained_.segment<3>(3 * k) += v.segment<3>(3 * k);
            for (const int i : rows) impulse_[i] += second.solution.lambda[i];
        }
        if (energy_of(gained_, bodies, members) >
            energy_of(bodies.u, bodies, members)) {
            before_.put_back(bodies, members);
            return;
        }
        for (const int k : members) bodies.velocity(k) += gained_.segment<3>(3 * k);
        for (const int i : rows) {
            now.solution.lambda[i] += impulse_[i];
            now.besides[i] += impulse_[i];
        }
    }
    //! [follow]

private:
    /// Which rows take part, and what each C is to be.
    /// \return  whether a joint bends anything here
    template <class Scene>
    bool begin(const Scene& scene, std::span<const int> rows,
               const NewtonSettings& newton, SecondProblem& second,
               const StepData<3>& now)
    {
        gained_.resize(scene.bodies.u.size());
        impulse_.resize(static_cast<Index>(now.rows.size()));
        goal_.resize(now.rows.size());
        bool joined = false;
        for (const int i : rows) {
            const auto at = static_cast<std::size_t>(i);
            const Constraint<3>& c = now.constraints[at];
            const bool joint = is_of_joint(now, i);
            if (joint && has_no_direction(scene, now.sources[at])) return false;
            // inerters keep their J u too, and a joint's motor as far as it can
            const bool holds_speed = c.kind == ConstraintKind::inerter ||
                                     (c.kind == ConstraintKind::motor && joint);
            second.left_out[at] = !has_error(c.kind) && !holds_speed;
            second.bias[at] = impulse_[i] = 0;
            // what Newton's method left is no error of its own
            const bool met = std::abs(c.C) * (is_angle(c) ? now.length : 1) <=
                             10 * newton.tolerance * now.length;
            goal_[at] = c.kind != ConstraintKind::bilateral ? std::min(Real{0}, c.C)
                        : met                               ? 0
                                                            : c.C;
            joined = joined || (joint && has_error(c.kind));
        }
        return joined;
    }

    /// Writes the biases of (15.12) where the bodies are now.
    /// \return  the largest error of a joint [m, rad ℓ]
    template <class Scene>
    Real find_errors(const Scene& scene, Real h, std::span<const int> rows,
                     SecondProblem& second, const StepData<3>& now) const
    {
        Real off = 0;
        for (const int i : rows) {
            const auto at = static_cast<std::size_t>(i);
            const ConstraintKind kind = now.constraints[at].kind;
            if (!has_error(kind)) continue;
            const Constraint<3> c = constraint_at(scene, now, at, scene.bodies.x);
            if (!is_of_joint(now, i)) {
                second.bias[at] = std::max(Real{0}, c.C) / h;
                continue;
            }
            const Real error = c.C - goal_[at];
            second.bias[at] = error / h;
            off = std::max(off, (kind == ConstraintKind::bilateral ? std::abs(error)
                                                                   : -error) *
                                    (is_angle(c) ? now.length : 1));
        }
        return off;
    }

    /// [J]
    static Real energy_of(const VecX& u, const Bodies<3>& bodies,
                          std::span<const int> members)
    {
        Real sum = 0;
        for (const int k : members)
            for (Index i = 3 * k; i < 3 * k + 3; ++i)
                if (bodies.inverse_mass[i] > 0)
                    sum += u[i] * u[i] / bodies.inverse_mass[i] / 2;
        return sum;
    }
    /// A distance of zero: J of the step's start says nothing of its end.
    template <class Scene>
    static bool has_no_direction(const Scene& scene, const Source& source)
    {
        const PointJoint& joint =
            scene.joints[static_cast<std::size_t>(source.index)];
        return joint.measure == PointJoint::Measure::distance && joint.length == 0;
    }

    std::vector<Real> goal_;  ///< C of each row where the step began [m, rad]
    PlacesBefore before_;
    VecX gained_;   ///< velocities [m/s]
    VecX impulse_;  ///< of each row [N s]
};

}  // namespace rigid
