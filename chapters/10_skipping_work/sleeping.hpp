/// \file sleeping.hpp
/// When an island may sleep: it has been at rest for a time, and at rest means more than slow.
///
///     ‖u‖ ≤ v_rest  and  ‖u − u_before‖ ≤ min(a_rest, s a) h   for each of its bodies, in each step, for a time t,
///     u_max ≤ p² v_rest,   p = min(1, t/t_rest),   u_max the greatest speed in that time: what lies still need not be
///                                                  watched for all of t_rest, unless something has just woken it
///     ‖u‖ ≤ max(½ u_max, p² ε)     in the last step: the motion dies out,
///     and the step's answer was solved
///
/// (10.7). Here a is the acceleration that a body would have if what acts on it had no counterforce, and s a small part of
/// it. A ball at the top of its flight and a pendulum at its apex have no velocity, but the acceleration g, however small g
/// is; a disc that begins to topple has little of either, but more and more. What sleep costs in accuracy: see (10.8).
#pragma once

#include "chapters/08_warm_starting/impulse_cache.hpp"
#include "chapters/10_skipping_work/awake_set.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace rigid {

struct RestSettings {
    Real speed = 1e-3;         ///< v_rest [ℓ/s]
    Real acceleration = 0.02;  ///< a_rest [ℓ/s²]
    Real time = 0.5;           ///< t_rest [s]

    bool operator==(const RestSettings&) const = default;
};

/// The same in metres, where the settings are measured in the length ℓ of the scene [m].
inline RestSettings in_metres(RestSettings rest, Real length)
{
    rest.speed *= length;
    rest.acceleration *= length;
    return rest;
}

void require_valid(const RestSettings& rest);

/// How long a body has been at rest without a break, and its greatest speed in that time.
struct Rest {
    Real time = 0;       ///< t [s]
    Real top_speed = 0;  ///< u_max, from before its first step on [m/s]
    /// since it was woken or changed, at rest or not [s]
    Real undisturbed = infinity;
};

/// Of a body that is woken or changed: what touches it in each step is not to send it to sleep in each.
constexpr Rest disturbed{0, 0, 0};

//! [rests]
/// s: the part of what acts on a body that may be without a counterforce at rest.
/// With the default a_rest, 9.81 m/s² and ℓ = 1 m the two limits are nearly one.
constexpr Real unbalanced = 1.0 / 400;

/// (10.7) for one body and one step: is it slow, and is its velocity steady?
/// \param rest    what was so until now
/// \param u       velocity after the step [m/s]
/// \param before  and before it [m/s]
/// \param acts    bool(Real): whether what acts on it has at least this a [m/s²]
template <int Dof, class Acts>
Rest still_at_rest(const Rest& rest, const Vec<Dof>& u, const Vec<Dof>& before,
                   const RestSettings& settings, Real h, const Acts& acts)
{
    const bool slow = u.squaredNorm() <= settings.speed * settings.speed;
    const Real change = (u - before).norm();
    const bool steady =
        change <= settings.acceleration * h && acts(change / (unbalanced * h));
    const Real undisturbed = rest.undisturbed + h;
    if (!slow || !steady) return {0, 0, undisturbed};
    return {rest.time + h, std::max({rest.top_speed, before.norm(), u.norm()}),
            undisturbed};
}

/// p: the part of t_rest that it has lasted.
inline Real part_of_rest(const Rest& rest, const RestSettings& settings)
{
    return std::min(Real{1}, rest.time / settings.time);
}
/// Has it lasted for long enough, and does what is left of the motion die out? What
/// glides on does not, nor what has begun to topple: that is faster than before.
/// \param noise  slower than this, after t_rest, it can't be distinguished from the
///               error of the answers [m/s]
inline bool may_sleep(const Rest& rest, Real speed, const RestSettings& settings,
                      Real noise)
{
    const Real p = part_of_rest(rest, settings);
    if (!(p > 0)) return false;
    if (p < 1 && (rest.undisturbed < settings.time ||
                  rest.top_speed > p * p * settings.speed))
        return false;
    return speed <= std::max(rest.top_speed / 2, p * p * noise);
}
//! [rests]

/// The impulses of sleeping islands, as forces λ/h, so that waking up is a warm start.
struct SleepingForces {
    struct Entry {
        ImpulseKey key;
        Real force = 0;  ///< λ/h [N]
        int next = -1;   ///< of the same island, or of the free places
    };
    std::vector<Entry> entries;
    /// K: first entry of the island whose first body this is
    std::vector<int> head;
    int free = -1;

    void put(int body, const ImpulseKey& key, Real force);

    /// Calls take(key, force) for what was put there, and forgets it.
    template <class Take>
    void take_all(int body, const Take& take)
    {
        int place = std::exchange(head[static_cast<std::size_t>(body)], -1);
        while (place >= 0) {
            Entry& entry = entries[static_cast<std::size_t>(place)];
            take(entry.key, entry.force);
            const int next = std::exchange(entry.next, free);
            free = place;
            place = next;
        }
    }
};

/// The impulses of woken bodies go back to the cache from which the next sweeps start.
void remember_woken(SleepingForces& forces, std::span<const int> woken,
                    ImpulseCache& cache);

}  // namespace rigid
