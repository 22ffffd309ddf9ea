/// \file heap_steps.hpp
/// A heap that moves, in small steps of its own: chapter 8's idea on chapter 17's lanes.
///
///     once:   rows into lanes
///     K ×:    u += k M⁻¹ f;  u += M⁻¹ Jᵀ λ;  two visits of each row;  x += k u;  one without what pushes out                      (18.4a)
///
/// with k = h/K, and C and J of contacts and pins where the bodies are by then (turning_contacts.hpp, turning_pins.hpp). What
/// moves has another λ in each step; a small step is worth more to it than a sweep. What the last visit finds off by much is
/// visited again (caught_bodies.hpp).
///
/// What hangs on joints pushes nothing out, for a push that a joint holds back stays in the velocities. What it is off by,
/// joints and overlaps, is corrected afterwards by positions alone.
#pragma once

#include "chapters/15_trees/newton_settings.hpp"
#include "chapters/18_islands/caught_bodies.hpp"
#include "chapters/18_islands/lane_errors.hpp"
#include "chapters/18_islands/step_part.hpp"

namespace rigid {

//! [settings]
struct HeapSteps {
    int least = 8;     ///< K, in a whole step, at least
    int visits = 2;    ///< of each row in a small step, before bodies move
    int substeps = 1;  ///< of the whole step
    Real beta = 0.4;   ///< part of an overlap that a small step takes back
    Real fastest = 3;  ///< overlaps are pushed out no faster [ℓ/s]
    Real slop = 5e-3;  ///< an overlap of half of this much is left alone [ℓ]
    /// a joint that is off by more asks for twice as many small steps [ℓ, rad]
    Real open = 5e-3;
    int most = 128;  ///< K, where joints ask for more
    /// what the last visit finds off by more than this part of the speed of the fastest
    /// body, and by more than so much, is visited again [ℓ/s] …
    Real slow = 0.05, slowest = 1e-3;
    int again = 48;  ///< … in so many passes of a small step, at most
    /// of each body: the same, at most [m]; empty = slop
    std::vector<Real> slops;

    /// K in a sub-step: so many that in a whole step an impulse gets from the
    /// ground to the farthest body.
    /// \param length  N, of the island
    int count(int length) const
    {
        const int needed = (length + visits) / (visits + 1);
        return 1 + (std::max(least, needed) - 1) / substeps;
    }

    /// s/2 of a contact [m]
    Real left_alone(const Constraint<3>& c, Real length) const
    {
        return least_slop(slop * length, c, slops) / 2;
    }
};
//! [settings]

/// \throws std::invalid_argument  if a number of it makes no sense
void require_valid(const HeapSteps& how);

/// The small steps of one heap whose rows are in lanes.
class HeapInLanes {
    static constexpr int lanes = full_lanes<Real>;
    using V = Lanes<Real, lanes>;
    using Wide = WideRows<3, Real, lanes>;

    template <class List>
    static auto& of(List& list, int k)
    {
        return list[static_cast<std::size_t>(k)];
    }

public:
    Real residual = 0;  ///< of the last small step [m/s]

    //! [small_steps]
    /// A sub-step of the whole step; u and λ of the part are changed.
    /// \param count   K, at least
    /// \param joined  joints are in it
    /// \param whole   the step that the part is of
    void operator()(const HeapSteps& how, int count, bool joined,
                    const StepData<3>& whole, StepPart& part,
                    const Bundles& bundles, Wide& wide)
    {
        StepData<3>& now = part.now;
        const auto go = [&](int parts) {
            split(parts, now);
            put_in(how, whole, part, bundles, wide);
            take_steps(how, count, joined, part, wide);
        };
        go(count);
        while (errors_.open_by() > how.open * now.length && count < how.most)
            count *= 2, go(2);  // from the beginning
        residual = wide_residual(wide);
        take_out(count, part, wide);
    }

private:
    void take_steps(const HeapSteps& how, int count, bool joined, StepPart& part,
                    Wide& wide)
    {
        StepData<3>& now = part.now;
        const Real h = now.h / count,
                   fastest = joined ? 0 : how.fastest * now.length,
                   until = std::max(how.slow * fastest_body(now),
                                    how.slowest * now.length);
        const LanePush push{how.beta / h, fastest}, none{};
        const auto set_biases = [&](std::size_t p) {
            errors_.set_biases(push, h, p, wide);
        };
        const auto look = [&](std::size_t p) {
            errors_.look(p, wide);
            errors_.set_biases(none, h, p, wide);
        };
        const Index bodies = part.local.count();
        for (int n = 0; n < count; ++n) {
            begin_small_step(count, part, wide);
            for (int v = 0; v < how.visits; ++v)
                caught_.visit_all(infinity, bodies, wide, set_biases);
            errors_.follow(now.active, h, wide);
            bool off = caught_.visit_all(until, bodies, wide, look);
            for (int v = 0; v < how.again && off; ++v)
                off = caught_.visit_near(until, wide);
        }
        now.visits += caught_.take_visits();
    }
    //! [small_steps]

    //! [begin_small_step]
    /// u += k M⁻¹ f;  u += M⁻¹ Jᵀ λ
    static void begin_small_step(int count, const StepPart& part, Wide& wide)
    {
        for (const int k : part.now.active)
            for (int d = 0; d < 3; ++d)
                of(wide.u, k).u[d] +=
                    (part.now.u_star[3 * k + d] - part.local.u[3 * k + d]) / count;
        apply_impulses(wide);
    }
    //! [begin_small_step]

    /// Before any impulse [m/s]
    static Real fastest_body(const StepData<3>& now)
    {
        Real speed = 0;
        for (const int k : now.active)
            speed = std::max(speed, now.u_star.segment<2>(3 * k).norm());
        return speed;
    }

public:
    /// Where the bodies of the part are after it.
    void move(const StepPart& part, Bodies<3>& bodies) const
    {
        for (const int k : part.now.active) {
            const int body = part.bodies[static_cast<std::size_t>(k)];
            bodies.position(body) = part.local.x.segment<3>(3 * k);
            bodies.integrate(body, errors_.gone(k), 1);
        }
    }

private:
    /// Impulses and bounds of a step in so many parts.
    static void split(int parts, StepData<3>& now)
    {
        now.solution.lambda /= parts;
        for (Row<3>& row : now.rows) row.lo /= parts, row.hi /= parts;
        clamp_start(now.rows, now.solution.lambda);
    }

    void put_in(const HeapSteps& how, const StepData<3>& whole, StepPart& part,
                const Bundles& bundles, Wide& wide)
    {
        StepData<3>& now = part.now;
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            if (has_error(of(whole.constraints, part.rows[i]).kind))
                now.rows[i].bias = 0;
        fill(WideProblem<3>{now.rows}, bundles, now.solution.lambda, part.local.u,
             wide);
        const auto left_alone = [&](const Constraint<3>& c) {
            return how.left_alone(c, whole.length);
        };
        errors_.put_in(left_alone, whole, part, wide);
    }

    /// λ of the whole sub-step, and u.
    static void take_out(int count, StepPart& part, const Wide& wide)
    {
        VecX& lambda = part.now.solution.lambda;
        get_velocities(wide.u, part.local.u);
        for (std::size_t i = 0; i < wide.place.size(); ++i) {
            const auto [row, lane_of] = wide.place[i];
            if (row >= 0)
                lambda[static_cast<Index>(i)] =
                    lane(of(wide.rows, row).lambda, lane_of);
        }
        lambda *= count;
    }

    LaneErrors errors_;
    CaughtBodies caught_;
};

}  // namespace rigid
