/// \file reflections.hpp
/// The impacts of a step, before its rows are solved: what approaches bounces, and what it hits by that bounces next.
///
///     V = { contacts with J u < −slowest that close within the step }
///     J_V (u* + v) = v⁺,   M v = J_Vᵀ Λ,   Λ ≥ 0,  joints J v = 0         u ← u + v,  u* ← u* + v,   until V is empty
///
/// (15.24). Contacts that do not approach have no part in an impact. So a ball that is hit hits the next one, with 1 mm or
/// nothing between them: a cradle passes its blow on. Each round keeps the energy where e = 1 and takes some where e < 1.
/// \cite smith2012
///
/// The speed v⁺ of a contact is that with which the fall would end, times e, less what the way back to where it is takes:
///
///     v⁺²/2 + a C + a h v⁺/2 = e² (v²/2 + a C + a h v/2),    v = −J u,   a = (J u − J u*)/h ≥ 0                        (15.25)
///
/// v²/2 + a C + a h v/2 is what symplectic Euler keeps in a uniform field, so the height of a bounce does not depend on where
/// in its step it falls.
///
/// A row that has bounced and would again, but after the step, waits: the rows of the step let its gap close and no more, and it
/// bounces there, at the end. So what flies to and fro between two walls keeps its speed in any room.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/06_sequential_impulse/restitution.hpp"
#include "chapters/15_trees/impact_times.hpp"

#include <cmath>
#include <span>

namespace rigid {

//! [note]
/// e of each row of the step, and from which approach on; empty if nothing bounces.
template <class Scene>
void note_bounces(const Scene& scene, const Restitution& bounce,
                  const StepSettings& settings, StepData<Scene::dof>& now)
{
    now.restitution.clear();
    now.slowest_bounce = bounce.threshold * scene.gravity.norm() * settings.part();
    for (std::size_t i = 0; i < now.constraints.size(); ++i) {
        if (!now.constraints[i].bounces) continue;
        const Real e = std::max(bounce.restitution, own_restitution(scene, now, i));
        if (!(e > 0)) continue;
        now.restitution.resize(now.rows.size(), 0);
        now.restitution[i] = e;
    }
}
//! [note]

/// (15.25) [m/s]: the speed after a bounce; 0 if it does not carry it off.
/// \param v    of the approach, positive [m/s]
/// \param a    by which forces bring it nearer [m/s²]
/// \param gap  C ≥ 0 [m]
/// \param from C where it leaves [m]
inline Real bounced_speed(Real e, Real v, Real a, Real gap, Real from, Real h)
{
    const Real energy = e * e * (v * v / 2 + a * gap + a * h * v / 2) - a * from,
               half = a * h / 2;
    return energy > 0 ? std::sqrt(half * half + 2 * energy) - half : 0;
}

struct Reflections {
private:
    template <class List>
    static auto& at(List& list, int i)
    {
        return list[static_cast<std::size_t>(i)];
    }

public:
    int most = 60;   ///< rounds; what approaches then bounces at the end
    int rounds = 0;  ///< of the last call
    VecX impulse;    ///< of each row, in the last call that had it [N s]
    /// of each row: its fastest bounce in the sub-steps so far [m/s]; empty = none
    std::vector<Real> bounced;
    bool any_late = false;  ///< a row of the last call bounces at the end

    //! [reflect]
    /// \param rows, members  of one problem of the step
    /// \param apart  solves other biases on them: v = M⁻¹ Jᵀ Λ
    template <class Apart>
    void operator()(std::span<const int> rows, std::span<const int> members,
                    Apart& apart, const Bodies<3>& bodies, StepData<3>& now)
    {
        begin(rows, members, bodies, now);
        for (const int i : rows) {
            impulse[i] = 0;
            at(fastest_, i) = at(late_, i) = 0;
        }
        bool any = find_approaching(rows, now);
        for (rounds = 0; any && rounds < most; ++rounds) {
            apart.solve_apart(second_, v_, now);
            for (const int i : rows)
                if (at(when_, i) >= 0) times_.reach(at(now.rows, i), at(when_, i));
            for (const int k : members) {
                times_.u.segment<3>(3 * k) += v_.segment<3>(3 * k);
                now.u_star.segment<3>(3 * k) += v_.segment<3>(3 * k);
            }
            for (const int i : rows) impulse[i] += second_.solution.lambda[i];
            any = find_approaching(rows, now);
        }
        list_late(rows, any, now);
    }

    /// What the rows of a problem gave in its impacts is theirs, too.
    void add_impulses(std::span<const int> rows, StepData<3>& now)
    {
        if (bounced.empty()) bounced.resize(now.rows.size(), 0);
        for (const int i : rows) {
            now.solution.lambda[i] += impulse[i];
            now.besides[i] += impulse[i];
            if (impulse[i] > 0 && at(now.restitution, i) > 0)
                at(bounced, i) = std::max(at(bounced, i), at(fastest_, i));
        }
    }
    //! [reflect]

    //! [late]
    /// The bounces that were left for the end, of contacts that did close; positions
    /// are what they are.
    template <class Apart>
    void at_the_end(std::span<const int> rows, std::span<const int> members,
                    Apart& apart, Bodies<3>& bodies, StepData<3>& now)
    {
        for (const int i : rows) {
            const Row<3>& row = at(now.rows, i);
            const bool late =
                at(late_, i) > 0 && now.solution.lambda[i] > now.besides[i];
            at(second_.left_out, i) = !late && !holds(at(now.constraints, i).kind);
            at(second_.bias, i) =
                late ? row.velocity(bodies.u) - row.bias - at(late_, i) : 0;
        }
        with_friction(rows, bodies.u, now);
        apart.solve_apart(second_, v_, now);
        for (const int k : members) bodies.velocity(k) += v_.segment<3>(3 * k);
        for (const int i : rows) impulse[i] = second_.solution.lambda[i];
        add_impulses(rows, now);
    }
    //! [late]

private:
    void begin(std::span<const int> rows, std::span<const int> members,
               const Bodies<3>& bodies, const StepData<3>& now)
    {
        const std::size_t m = now.rows.size();
        second_.bias.resize(m);
        second_.left_out.resize(m);
        second_.max_sweeps = 100;
        second_.tolerance = 1e-9 * now.length;
        second_.solution.lambda.resize(static_cast<Index>(m));
        impulse.resize(static_cast<Index>(m));
        late_.resize(m), fastest_.resize(m), when_.resize(m), times_.resize(bodies);
        if (v_.size() != bodies.u.size()) v_.setZero(bodies.u.size());
        for (const int k : members) times_.begin(bodies, k);
        for (const int i : rows)  // what cannot move may have a velocity
            for (const Index k : {at(now.rows, i).a, at(now.rows, i).b})
                if (k != world)
                    times_.begin(bodies, k), v_.segment<3>(3 * k).setZero();
    }

    //! [approaching]
    /// V, and what its rows ask for; friction of its contacts goes with them.
    bool find_approaching(std::span<const int> rows, const StepData<3>& now)
    {
        bool any = false;
        for (const int i : rows) {
            const Row<3>& row = at(now.rows, i);
            const Constraint<3>& c = at(now.constraints, i);
            at(second_.left_out, i) = !holds(c.kind);
            at(second_.bias, i) = 0;
            at(when_, i) = -1;
            if (!(at(now.restitution, i) > 0) || at(late_, i) > 0) continue;
            const Real gap = std::max(Real{0}, c.C),
                       v = row.bias - row.velocity(times_.u),
                       after = row.velocity(now.u_star) - row.bias;
            if (!(v > now.slowest_bounce) || !(gap + now.h * after < 0)) continue;
            const Real a = std::max(Real{0}, -(v + after) / now.h),
                       off = bounced_speed(at(now.restitution, i), v, a, gap, gap,
                                           now.h);
            if (!(off > 0)) continue;
            const Real t = times_.of(row, gap, v);
            if (impulse[i] > 0 && t > now.h) {
                at(late_, i) = off;
                continue;
            }
            at(when_, i) = t;
            at(fastest_, i) = std::max(at(fastest_, i), v);
            at(second_.left_out, i) = 0;
            at(second_.bias, i) = after - off;
            any = true;
        }
        if (any) with_friction(rows, now.u_star, now);
        return any;
    }
    //! [approaching]

    void with_friction(std::span<const int> rows, const VecX& u,
                       const StepData<3>& now)
    {
        for (const int i : rows) {
            const Row<3>& row = at(now.rows, i);
            if (row.bounded_by < 0 || at(second_.left_out, row.bounded_by))
                continue;
            at(second_.left_out, i) = 0;
            at(second_.bias, i) = row.velocity(u);
        }
    }

    /// With which speed each late row leaves, from where its gap is closed.
    /// \param unfinished  so are those that the last round has found
    void list_late(std::span<const int> rows, bool unfinished,
                   const StepData<3>& now)
    {
        any_late = false;
        for (const int i : rows) {
            if (!(at(late_, i) > 0) && !(unfinished && at(when_, i) >= 0)) continue;
            const Row<3>& row = at(now.rows, i);
            const Real v = row.bias - row.velocity(times_.u),
                       after = row.velocity(now.u_star) - row.bias,
                       a = std::max(Real{0}, -(v + after) / now.h),
                       gap = std::max(Real{0}, at(now.constraints, i).C);
            at(late_, i) =
                v > now.slowest_bounce
                    ? bounced_speed(at(now.restitution, i), v, a, gap, 0, now.h)
                    : 0;
            at(fastest_, i) = std::max(at(fastest_, i), v);
            any_late = any_late || at(late_, i) > 0;
        }
    }

    /// What holds during an impact: joints. (A limit or a rope that is struck holds from the step's own rows on.)
    static bool holds(ConstraintKind kind)
    {
        return kind == ConstraintKind::bilateral || kind == ConstraintKind::inerter;
    }

    SecondProblem second_;
    VecX v_;
    ImpactTimes times_;
    // Of each row, in the last call that had it.
    std::vector<Real> late_;  ///< its speed after the bounce at the end; 0 = none
    std::vector<Real> fastest_;  ///< its fastest approach that bounced [m/s]
    std::vector<Real> when_;     ///< its impact of this round; −1 = not in V [s]
};

}  // namespace rigid
