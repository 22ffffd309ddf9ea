/// \file skipping_step.hpp
/// Chapter 8's step without what needs nothing: who sleeps is not looked at, pairs that are far apart are not tested,
/// and each island is solved by itself for as long as it needs.
///
///     who is awake → contacts → u* → rows → islands → λ start → λ → u → who sleeps → x
///
/// Without sleeping and with the same sweeps its bits are those of chapter 8's warm_step().
#pragma once

#include "chapters/10_skipping_work/awake_rows.hpp"
#include "chapters/10_skipping_work/island_solver.hpp"

#include <initializer_list>

namespace rigid {

/// Each island by itself, from yesterday's λ. The answer is in memory.u and lambda.
inline void solve_islands(SkippingWorld& now, const SkippingSettings& settings)
{
    const auto m = static_cast<Index>(now.rows.size());
    if (settings.warm) load(now.cache, now.keys, settings.h, now.lambda);
    else now.lambda.setZero(m);
    for (Index i = 0; i < m; ++i) {
        const Row<2>& row = now.rows[static_cast<std::size_t>(i)];
        now.lambda[i] = std::clamp(now.lambda[i], row.lo, row.hi);
    }
    prepare<2>(now.rows, now.islands.rows, now.lambda, now.memory.rows);
    for (const SolverRow<2>& row : now.memory.rows) {
        now.memory.u.segment<2>(row.a) += row.Wa * row.lambda;
        now.memory.u.segment<2>(row.b) += row.Wb * row.lambda;
    }
    const auto solve = [&](std::span<SolverRow<2>> rows) {
        if (rows.empty()) return;
        if (static_cast<int>(rows.size()) <= settings.exact_rows) {
            const IslandAnswer exact =
                solve_exactly(rows, settings.sweeps.tolerance, now.exact, now.memory.u);
            now.counters.visits += exact.visits;
            if (exact.status == Status::solved) {
                ++now.counters.exact;
                return;
            }
        }
        const IslandAnswer answer = sweep_island(rows, settings.sweeps, now.memory.u);
        now.counters.sweeps = std::max(now.counters.sweeps, answer.sweeps);
        now.counters.visits += answer.visits;
        now.counters.unsolved += answer.status != Status::solved;
    };
    const std::span<SolverRow<2>> all(now.memory.rows);
    if (settings.islands)
        for (int i = 0; i < now.islands.count(); ++i)
            solve(all.subspan(static_cast<std::size_t>(now.islands.first_row[static_cast<std::size_t>(i)]),
                              now.islands.rows_of(i).size()));
    else solve(all);
    for (std::size_t k = 0; k < now.memory.rows.size(); ++k)
        now.lambda[now.islands.rows[k]] = now.memory.rows[k].lambda;
    store(now.cache, now.keys, now.lambda, settings.h);
}

/// The contacts of those who are awake; true if they are those of the step before and may have kept their rows.
inline bool step_contacts(SkippingWorld& now, Real slack)
{
    if (slack > 0) {
        keep_contacts(now.scene, now.set, now.broad, slack, now.kept, now.contacts);
        return now.kept.same;
    }
    awake_contacts(now.scene, now.set, now.broad, now.contacts);
    now.kept = {};
    return false;
}

/// What moves and can't be stopped keeps awake whom it carries, pulls or bends, however slowly it goes.
inline void stay_with_drivers(SkippingWorld& now)
{
    const auto drives = [&](Index k) {
        return k != world && now.set.is_awake(k) && !(now.scene.bodies.inverse_mass[2 * k] > 0);
    };
    for (const int k : now.set.awake)
        if (drives(k)) now.rests[static_cast<std::size_t>(k)] = {};
    const auto together = [&](std::initializer_list<Index> bodies) {
        if (std::none_of(bodies.begin(), bodies.end(), drives)) return;
        for (const Index k : bodies)
            if (k != world) now.rests[static_cast<std::size_t>(k)] = {};
    };
    for (const Row<2>& row : now.rows) together({row.a, row.b});
    for (const Bend& bend : now.active_bends) together({bend.left, bend.middle, bend.right});
}

/// The new velocity, and how long it has been at rest, for each body that is awake.
inline void new_velocities(SkippingWorld& now, const SkippingSettings& settings)
{
    Bodies<2>& bodies = now.scene.bodies;
    bool driven = false;
    for (const int k : now.set.awake) {
        const Vec2 u = now.memory.u.segment<2>(2 * k), before = bodies.velocity(k);
        Rest& rest = now.rests[static_cast<std::size_t>(k)];
        rest = still_at_rest<2>(rest, u, before, settings.rest, settings.h);
        driven = driven || !(bodies.inverse_mass[2 * k] > 0);
        bodies.velocity(k) = u;
    }
    if (driven) stay_with_drivers(now);
}

/// What the step looked at.
inline void count_work(SkippingWorld& now, bool same_rows)
{
    now.counters.awake = static_cast<int>(now.set.awake.size());
    now.counters.islands = now.islands.count();
    now.counters.contacts = static_cast<int>(now.contacts.size());
    now.counters.rows = static_cast<int>(now.rows.size());
    now.counters.kept_rows = static_cast<int>(same_rows ? now.kept.reused + std::int64_t(now.kept.walls) : 0);
    now.counters.asked = static_cast<int>(now.broad.asked);
    now.counters.tested = now.broad.tested;
}

/// Islands that have been at rest for long enough fall asleep (10.8); their forces are kept for the morning. They
/// stop before they move: who sleeps stands where its contacts were found.
inline void fall_asleep(SkippingWorld& now, const SkippingSettings& settings)
{
    for (int i = 0; settings.sleep && i < now.islands.count(); ++i) {
        const std::span<const int> members = now.islands.bodies_of(i), rows = now.islands.rows_of(i);
        const auto restless = [&](int k) {
            return !may_sleep(now.rests[static_cast<std::size_t>(k)], now.scene.bodies.velocity(k).norm(),
                              settings.rest, settings.sweeps.tolerance);
        };
        if (std::any_of(members.begin(), members.end(), restless)) continue;

        // Rest is only proved by an answer that is one.
        const std::span<const SolverRow<2>> solved(
            now.memory.rows.data() + now.islands.first_row[static_cast<std::size_t>(i)], rows.size());
        if (!(natural_residual(solved, now.memory.u) <= settings.rest.acceleration * settings.h)) continue;

        //! [fall_asleep]
        now.set.sleep(members);
        for (const int row : rows)
            now.forces.put(members[0], now.keys[static_cast<std::size_t>(row)], now.lambda[row] / settings.h);
        for (const int k : members) {
            now.scene.bodies.velocity(k).setZero();
            now.memory.u.segment<2>(2 * k).setZero();
        }
        //! [fall_asleep]
        now.counters.fell_asleep += static_cast<int>(members.size());
    }
    if (now.counters.fell_asleep == 0) return;
    now.set.tidy();
    now.changed = true;
}

//! [step]
/// One time step. Depends on its arguments alone.
inline void skipping_step(SkippingWorld& now, const SkippingSettings& settings)
{
    now.counters = {};
    wake_by_changes(now, settings);
    if (now.set.awake.empty()) return;

    // Who may touch whom; who is touched wakes.
    update_pairs(now.scene, now.set, now.broad);
    if (!now.set.woken.empty()) get_up(now);
    const bool same_bodies = !now.changed;
    collect_active(now);
    const bool same_rows = step_contacts(now, settings.row_slack) && same_bodies;

    // u*, rows and islands of those who are awake.
    awake_forces(now, settings);
    awake_rows(now, settings, same_rows);
    find_islands(now, settings.order, same_bodies);

    // Each island by itself; who has been at rest for long enough sleeps, the others move on.
    solve_islands(now, settings);
    new_velocities(now, settings);
    count_work(now, same_rows);
    fall_asleep(now, settings);
    for (const int k : now.set.awake)
        now.scene.bodies.position(k) += settings.h * now.scene.bodies.velocity(k);
}
//! [step]

}  // namespace rigid
