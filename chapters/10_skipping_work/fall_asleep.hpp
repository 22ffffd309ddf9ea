/// \file fall_asleep.hpp
/// The end of the contacts stage: how long each body has been at rest, and which islands fall asleep (10.7).
#pragma once

#include "chapters/10_skipping_work/row_residual.hpp"
#include "chapters/10_skipping_work/sleepers.hpp"

#include <algorithm>
#include <initializer_list>

namespace rigid {

/// A body that moves and can't be stopped keeps awake what it carries, pulls or bends, however slowly it goes.
template <int Dof>
void Sleepers<Dof>::stay_with_kinematic(const Bodies<Dof>& bodies,
                                        const StepData<Dof>& now)
{
    const auto kinematic = [&](Index k) {
        return k != world && set.is_awake(k) && !bodies.can_move(k);
    };
    for (const int k : set.awake)
        if (kinematic(k)) rests[static_cast<std::size_t>(k)] = disturbed;
    const auto together = [&](std::initializer_list<Index> some) {
        if (std::none_of(some.begin(), some.end(), kinematic)) return;
        for (const Index k : some)
            if (k != world) rests[static_cast<std::size_t>(k)] = disturbed;
    };
    for (const Row<Dof>& row : now.rows) together({row.a, row.b});
    for (const Bend& bend : now.bends)
        together({bend.left, bend.middle, bend.right});
}

/// The velocity of a body as rest measures it [m/s]. Discs only move on; the scene of bodies that turn has its own.
inline Vec<2> measured_velocity(const DiscScene&, Index, const Vec<2>& u)
{
    return u;
}

/// Whether forces and rows, the sum of their sizes, accelerate body k by at least a [m/s²]. In flight that is its
/// acceleration; where it stands it is all that is in balance there.
template <int Dof>
template <class Scene>
bool Sleepers<Dof>::acts_on(const Scene& scene, Index k, Real a,
                            const StepData<Dof>& now)
{
    const Bodies<Dof>& bodies = scene.bodies;
    const auto size = [&](Index body, const Vec<Dof>& of) {
        return measured_velocity(scene, body, of).norm();
    };
    const Real by_forces = size(k, bodies.apply_inverse_mass(k, bodies.force(k)));
    if (by_forces >= a) return true;  // as nearly always
    if (!std::exchange(is_summed_, true)) {
        borne_.setZero(bodies.count());
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const Row<Dof>& row = now.rows[i];
            const Real force =
                std::abs(now.solution.lambda[static_cast<Index>(i)]) / now.h;
            if (row.a != world) borne_[row.a] += force * size(row.a, row.Wa);
            if (row.b != world) borne_[row.b] += force * size(row.b, row.Wb);
        }
    }
    return by_forces + borne_[k] >= a;
}

/// How long each body that is awake has been at rest.
template <int Dof>
template <class Scene>
void Sleepers<Dof>::watch_rest(const Scene& scene, const StepSettings& settings,
                               const StepData<Dof>& now)
{
    const RestSettings slow = in_metres(rest, length);
    bool any_kinematic = false;
    is_summed_ = false;
    for (const int k : set.awake) {
        Rest& so_far = rests[static_cast<std::size_t>(k)];
        const Vec<Dof> u = scene.bodies.velocity(k),
                       before = u_before.template segment<Dof>(Dof * k);
        so_far = still_at_rest<Dof>(
            so_far, measured_velocity(scene, k, u),
            measured_velocity(scene, k, before), slow, settings.h,
            [&](Real a) { return acts_on(scene, k, a, now); });
        any_kinematic = any_kinematic || !scene.bodies.can_move(k);
    }
    if (any_kinematic) stay_with_kinematic(scene.bodies, now);
}

/// (10.7). An island that falls asleep is put where its contacts were found.
template <int Dof>
template <class Scene, class Method>
void Sleepers<Dof>::fall_asleep(Scene& scene, const StepSettings& settings,
                                Method& method, const StepData<Dof>& now)
{
    watch_rest(scene, settings, now);
    if (!sleep) return;
    const RestSettings slow = in_metres(rest, length);
    const Real noise = method.solver.noise() * length;
    // what a correction moves is in no velocity, and would be taken back
    const auto moved = [&](int k) {
        const Vec<Dof> way =
            scene.bodies.position(k) - now.x_found.template segment<Dof>(Dof * k);
        return measured_velocity(scene, k, way).norm();
    };
    const auto restless = [&](int k) {
        const Rest& so_far = rests[static_cast<std::size_t>(k)];
        const Vec<Dof> u = scene.bodies.velocity(k);
        const Real p = part_of_rest(so_far, slow);
        return !may_sleep(so_far, measured_velocity(scene, k, u).norm(), slow,
                          noise) ||
               (p < 1 && moved(k) > p * p * slow.speed * settings.h);
    };
    if (std::all_of(set.awake.begin(), set.awake.end(), restless)) return;

    const Islands* known = method.solver.islands_found();
    if (!known) find_islands(scene.bodies, now, {}, islands), known = &islands;
    for (int i = 0; i < known->count(); ++i) {
        const std::span<const int> members = known->bodies_of(i),
                                   rows = known->rows_of(i);
        if (std::any_of(members.begin(), members.end(), restless)) continue;

        // Rest is only proved by an answer that is one.
        if (!(natural_residual(now, rows, scene.bodies.u) <=
              slow.acceleration * settings.h))
            continue;

        // Overlaps that are being repaid would stay as they are.
        if (rests[static_cast<std::size_t>(members[0])].time < 4 * slow.time &&
            std::any_of(rows.begin(), rows.end(),
                        [&](int row) { return method.correction.pushes(row); }))
            continue;

        //! [fall_asleep]
        set.sleep(members);
        for (const int row : rows)
            forces.put(
                members[0],
                key_of(now.sources[static_cast<std::size_t>(row)], now.contacts),
                now.solution.lambda[row] / settings.part());
        for (const int k : members) {
            rests[static_cast<std::size_t>(k)] = disturbed;  // when it wakes
            scene.bodies.velocity(k).setZero();
            scene.bodies.position(k) = now.x_found.template segment<Dof>(Dof * k);
        }
        //! [fall_asleep]
        fell_asleep += static_cast<int>(members.size());
    }
    if (fell_asleep == 0) return;
    set.tidy();
    changed = true;
}

}  // namespace rigid
