/// \file heap_steps.hpp
/// A heap that moves, in small steps of its own: chapter 8's idea on chapter 17's lanes.
///
///     once:   rows into lanes, C of each contact
///     K ×:    u += k M⁻¹ f;  u += M⁻¹ Jᵀ λ;  two visits of each row;  x += k u, C += k J u;  one without what pushes out       (18.4a)
///
/// with k = h/K. J and M⁻¹ Jᵀ are those of the beginning, and C goes on along J: what is left out is how normals turn and
/// points go along their faces, of second order in how far a pair moves in the step. What moves has another λ in each step; a
/// small step is worth more to it than a sweep.
#pragma once

#include "chapters/17_wide_sweeps/wide_solver.hpp"
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
        Real left = slop * length;
        for (const Index k : {c.a, c.b})
            if (k != world && k < static_cast<Index>(slops.size()))
                left = std::min(left, slops[static_cast<std::size_t>(k)]);
        return left / 2;
    }
};
//! [settings]

/// What a small step asks of a row besides J u: C of a contact, and what it gives back.
template <class V>
struct LaneError {
    V C{};       ///< [m]
    V slop{};    ///< s/2 [m]
    V is_gap{};  ///< 1: of a contact's normal; 0: of friction
    V rate{};    ///< J u of what nothing moves, and b of friction [m/s]
};

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
    /// \param count        K
    /// \param constraints  of the step; those of the part are all of contacts
    void operator()(const HeapSteps& how, int count,
                    const std::vector<Constraint<3>>& constraints, StepPart& part,
                    const Bundles& bundles, Wide& wide)
    {
        StepData<3>& now = part.now;
        const Real h = now.h / count;
        now.solution.lambda /= count;
        clamp_start(now.rows, now.solution.lambda);
        put_in(how, constraints, part, bundles, wide);
        moved_.assign(wide.u.size(), {});
        for (int n = 0; n < count; ++n) {
            for (const int k : now.active)
                for (int d = 0; d < 3; ++d)
                    of(wide.u, k).u[d] +=
                        (now.u_star[3 * k + d] - part.local.u[3 * k + d]) / count;
            set_biases(how.beta / h, how.fastest * now.length, h, wide);
            apply_impulses(wide);
            for (int v = 0; v < how.visits; ++v) wide_sweep(wide, Real{0}, 1);
            for (const int k : now.active)
                for (int d = 0; d < 3; ++d)
                    of(moved_, k).u[d] += h * of(wide.u, k).u[d];
            follow(h, wide);
            set_biases(0, 0, h, wide);
            wide_sweep(wide, Real{0}, 1);
        }
        now.visits +=
            (how.visits + 1) * count * static_cast<std::int64_t>(now.rows.size());
        take_out(h, count, part, wide);
    }
    //! [small_steps]

    /// Where the bodies of the part are after it.
    void move(const StepPart& part, Bodies<3>& bodies) const
    {
        for (const int k : part.now.active) {
            const auto& by = of(moved_, k).u;
            const int body = part.bodies[static_cast<std::size_t>(k)];
            bodies.position(body) = part.local.x.segment<3>(3 * k);
            bodies.integrate(body, Vec<3>(by[0], by[1], by[2]), 1);
        }
    }

private:
    void put_in(const HeapSteps& how, const std::vector<Constraint<3>>& constraints,
                StepPart& part, const Bundles& bundles, Wide& wide)
    {
        StepData<3>& now = part.now;
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            if (has_error(of(constraints, part.rows[i]).kind)) now.rows[i].bias = 0;
        fill(WideProblem<3>{now.rows}, bundles, now.solution.lambda, part.local.u,
             wide);
        errors_.assign(wide.rows.size(), {});
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const auto [row, lane] = wide.place[i];
            const Constraint<3>& c = of(constraints, part.rows[i]);
            if (row < 0 || !has_error(c.kind)) continue;
            LaneError<V>& error = of(errors_, row);
            write_lane(error.C, lane, c.C);
            write_lane(error.slop, lane, how.left_alone(c, now.length));
            write_lane(error.is_gap, lane, 1);
        }
        for (std::size_t i = 0; i < errors_.size(); ++i)
            errors_[i].rate = wide.rows[i].bias;
    }

    //! [biases]
    /// (18.4b): a gap may close; of an overlap so much goes out a second, no faster
    /// than this.
    void set_biases(Real per_second, Real fastest, Real h, Wide& wide) const
    {
        const V none{}, step = none + h, part = none + per_second,
                        most = none - fastest;
        for (std::size_t i = 0; i < errors_.size(); ++i) {
            const LaneError<V>& error = errors_[i];
            const V open = at_least(error.C, none),
                    deep = at_most(error.C + error.slop, none);
            wide.rows[i].bias =
                error.rate +
                error.is_gap * (open / step + at_least(part * deep, most));
        }
    }
    /// C ← C + h J u
    void follow(Real h, const Wide& wide)
    {
        for (const Packet<lanes>& packet : wide.packets) {
            V ua[3], ub[3];
            gather<3, Real, lanes>(wide.u.data(), packet.a.data(), ua);
            gather<3, Real, lanes>(wide.u.data(), packet.b.data(), ub);
            for (int r = packet.first; r < packet.first + packet.rows; ++r) {
                const auto& row = of(wide.rows, r);
                V speed = of(errors_, r).rate;
                for (int d = 0; d < 3; ++d)
                    speed = speed + row.Ja[d] * ua[d] + row.Jb[d] * ub[d];
                of(errors_, r).C = of(errors_, r).C + speed * (V{} + h);
            }
        }
    }
    //! [biases]

    /// λ of the whole sub-step, u, and what the last visits left.
    void take_out(Real h, int count, StepPart& part, const Wide& wide)
    {
        StepData<3>& now = part.now;
        VecX& lambda = now.solution.lambda;
        get_velocities(wide.u, part.local.u);
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const auto [row, lane_of] = wide.place[i];
            if (row < 0) continue;
            lambda[static_cast<Index>(i)] =
                lane(of(wide.rows, row).lambda, lane_of);
            if (lane(of(errors_, row).is_gap, lane_of) > 0)
                now.rows[i].bias =
                    std::max(Real{0}, lane(of(errors_, row).C, lane_of)) / h;
        }
        residual = natural_residual(now.rows, lambda, part.local.u);
        lambda *= count;
    }

    std::vector<LaneError<V>> errors_;  ///< of each row of the lanes
    std::vector<Slot<3, Real>> moved_;  ///< x − x of the beginning, of each body
};

}  // namespace rigid
