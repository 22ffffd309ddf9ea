/// \file skipping_step.hpp
/// Chapter 8's step without what needs nothing: who sleeps is not looked at, pairs that are far apart are not tested,
/// and each island is solved by itself for as long as it needs.
///
///     who is awake → contacts → u* → rows → islands → λ start → λ → u → x → who sleeps
///
/// Without sleeping and with the same sweeps its bits are those of chapter 8's warm_step().
#pragma once

#include "chapters/10_skipping_work/awake_rows.hpp"
#include "chapters/10_skipping_work/island_solver.hpp"

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

/// Who belongs together, and the order of the rows. While the rows are those of yesterday, so are the islands.
inline void find_islands(SkippingWorld& now, Order order, bool same_bodies)
{
    if (same_bodies && order == now.ordered && now.keys == now.arranged) return;
    const std::span<const int> bodies(now.set.awake);
    separate(now.scene.bodies.count(), bodies, now.islands);
    // A torsional spring acts on three discs at once: they are of one island, whatever rows they have.
    for (const Bend& bend : now.active_bends) {
        const std::array<Index, 3> discs = {bend.left, bend.middle, bend.right};
        for (const Index a : discs)
            for (const Index b : discs)
                if (now.scene.bodies.inverse_mass[2 * a] > 0 && now.scene.bodies.inverse_mass[2 * b] > 0)
                    now.islands.unite(static_cast<int>(a), static_cast<int>(b));
    }
    now.order.clear();
    if (order == Order::coloured)
        colour_rows_of<2>(bodies, now.scene.bodies.count(), now.rows, now.colouring, now.order);
    join_by_rows<2>(bodies, now.rows, now.order, now.islands);
    now.arranged = now.keys;
    now.ordered = order;
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

/// How long each body that is awake has been at rest, its velocity, and its new position.
inline void move_on(SkippingWorld& now, const SkippingSettings& settings)
{
    Bodies<2>& bodies = now.scene.bodies;
    for (const int k : now.set.awake) {
        const Vec2 u = now.memory.u.segment<2>(2 * k), before = bodies.velocity(k);
        Real& rested = now.rested[static_cast<std::size_t>(k)];
        rested = time_at_rest<2>(rested, u, before, settings.rest, settings.h);
        // What nothing can stop does not rest while it moves, however slowly.
        if (!(bodies.inverse_mass[2 * k] > 0) && u.squaredNorm() > 0) rested = 0;
        bodies.velocity(k) = u;
        bodies.position(k) += settings.h * u;
    }
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

/// Islands that have been at rest for long enough fall asleep (10.8); their forces are kept for the morning.
inline void fall_asleep(SkippingWorld& now, const SkippingSettings& settings)
{
    for (int i = 0; settings.sleep && i < now.islands.count(); ++i) {
        const std::span<const int> members = now.islands.bodies_of(i), rows = now.islands.rows_of(i);
        Real shortest = infinity;
        for (const int k : members) shortest = std::min(shortest, now.rested[static_cast<std::size_t>(k)]);
        if (shortest < settings.rest.time) continue;

        // Rest is only proved by an answer that is one; and what moves by itself keeps awake what it touches.
        const std::span<const SolverRow<2>> solved(
            now.memory.rows.data() + now.islands.first_row[static_cast<std::size_t>(i)], rows.size());
        const bool carried = std::any_of(rows.begin(), rows.end(), [&](int row) {
            const auto moves = [&](Index k) {
                return k != world && now.set.is_awake(k) && !(now.scene.bodies.inverse_mass[2 * k] > 0);
            };
            return moves(now.rows[static_cast<std::size_t>(row)].a) ||
                   moves(now.rows[static_cast<std::size_t>(row)].b);
        });
        if (carried || !(natural_residual(solved, now.memory.u) <= settings.rest.acceleration * settings.h))
            continue;

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

    // Each island by itself; then new velocities and positions.
    solve_islands(now, settings);
    move_on(now, settings);
    count_work(now, same_rows);
    fall_asleep(now, settings);
}
//! [step]

}  // namespace rigid
