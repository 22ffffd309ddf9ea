/// \file broad_phase.hpp
/// The pairs of discs that may touch, kept from step to step.
///
///     ‖x_a − x̄_a‖ ≤ skin,  ‖x_b − x̄_b‖ ≤ skin,  ‖x_b − x_a‖ < r_a + r_b + margin
///         ⟹  ‖x̄_b − x̄_a‖ < r_a + r_b + margin + 2 skin
///
/// (10.4). The grid holds each disc at x̄, where it stood when it was last put in. The pairs on the right are listed;
/// while no disc has left its skin, no pair on the left can be missing from the list, so only a disc that has left it
/// queries the grid again \cite verlet1967. The contacts that come out are those of all K²/2 tests, in their order, to the bit.
#pragma once

#include "chapters/10_skipping_work/awake_set.hpp"
#include "chapters/10_skipping_work/collision_filter.hpp"
#include "chapters/10_skipping_work/disc_grid.hpp"
#include "common/contact.hpp"

#include <cstdint>
#include <vector>

namespace rigid {

struct BroadPhase {
    DiscGrid grid;
    CollisionFilter filter;
    Real margin = 0.02;  ///< a pair is a contact when its gap is below this [m]
    /// how far a disc may move before it queries the grid again [m]
    Real skin = 0.01;

    std::vector<std::uint64_t> pairs;  ///< a · 2³² + b, a < b, ascending
    std::vector<std::uint64_t> kept, fresh;
    std::vector<int> stale;              ///< discs that query the grid in this step
    std::vector<std::uint8_t> is_stale;  ///< K: is in that list
    /// distances of two discs that were computed in this step
    std::int64_t tested = 0;
    std::int64_t queries = 0;  ///< discs that queried the grid

    /// How far from its centre a disc looks for the surfaces of others [m]: the right side of (10.4).
    Real reach_of(Real radius) const { return radius + margin + 2 * skin; }

    /// \param scene  its discs are put in; its table of linked pairs is not looked at, see filter_of()
    void reset(const DiscScene& scene, CollisionFilter by);

    /// Disc k = K − 1 is new; it is stale once it is called woken.
    void add(const DiscScene& scene, Index k);
};

inline std::uint64_t pair_code(int a, int b)
{
    return static_cast<std::uint64_t>(a < b ? a : b) << 32 |
           static_cast<std::uint64_t>(a < b ? b : a);
}
inline int first_of(std::uint64_t pair) { return static_cast<int>(pair >> 32); }
inline int second_of(std::uint64_t pair)
{
    return static_cast<int>(pair & 0xffffffffu);
}
inline int other_of(std::uint64_t pair, int k)
{
    return first_of(pair) == k ? second_of(pair) : first_of(pair);
}

//! [touches]
/// The contact of two discs, if their gap is below the margin: the test of
/// find_contacts() for one pair.
inline bool touches(const DiscScene& scene, Index a, Index b, Real margin,
                    Contact& contact)
{
    const Vec2 d = scene.bodies.position(b) - scene.bodies.position(a);
    const Real reach = scene.radius[a] + scene.radius[b] + margin;
    if (d.squaredNorm() >= reach * reach) return false;
    contact = disc_contact(scene, scene.bodies.x, a, b);
    return true;
}
//! [touches]

/// Brings the list of pairs up to date with x. A sleeper within the margin of an awake disc is
/// woken, with its island, and queries as well. Afterwards no pair that is missing can have a gap below the margin,
/// unless neither of the two is awake.
/// \param scene  positions, radii, masses
/// \param set    the awake bodies; may gain members
inline void update_pairs(const DiscScene& scene, AwakeSet& set, BroadPhase& broad)
{
    const VecX& x = scene.bodies.x;
    const auto at = [](auto& list, int i) -> auto&
    {
        return list[static_cast<std::size_t>(i)];
    };
    const auto movable = [&](int k) { return scene.bodies.can_move(k); };
    const auto is = [&](int k, Activity activity) {
        return at(set.activity, k) == activity;
    };
    const auto may_ask = [&](int k) {
        return !is(k, Activity::asleep) && !is(k, Activity::gone);
    };
    const auto renew = [&](int k) {  // all move before the first query
        if (std::exchange(at(broad.is_stale, k), std::uint8_t{1}) == 0)
            broad.stale.push_back(k);
        if (!is(k, Activity::gone)) broad.grid.move(k, x.segment<2>(2 * k));
    };
    const auto wake_if_close = [&](int a, int b) {
        ++broad.tested;
        Contact contact;
        if (!touches(scene, a, b, broad.margin, contact)) return;
        const std::size_t before = set.woken.size();
        set.wake(b);
        for (std::size_t i = before; i < set.woken.size(); ++i) renew(set.woken[i]);
    };

    broad.tested = 0;

    //! [kept]
    // (10.4): which discs have left their skins? (Discs woken since the last step
    // query too: their pairs were not kept.)
    const Real allowed = broad.skin * broad.skin;
    for (const int k : set.woken) renew(k);
    for (const int k : set.awake)
        if (!((x.segment<2>(2 * k) - broad.grid.position(k)).squaredNorm() <=
              allowed))
            renew(k);

    // What is still true of the old list.
    broad.kept.clear();
    for (const std::uint64_t pair : broad.pairs) {
        const int a = first_of(pair), b = second_of(pair);
        if (at(broad.is_stale, a) || at(broad.is_stale, b) ||
            !(set.is_awake(a) || set.is_awake(b)))
            continue;
        if (is(a, Activity::gone) || is(b, Activity::gone)) continue;
        broad.kept.push_back(pair);
        if (set.is_asleep(b)) wake_if_close(a, b);
        else if (set.is_asleep(a)) wake_if_close(b, a);
    }
    //! [kept]

    //! [ask]
    // Query the grid. The list may grow on the way: a sleeper that is found close
    // by is woken, and queries too.
    broad.fresh.clear();
    broad.grid.tested = broad.grid.cells = 0;
    const std::size_t before_asking = broad.stale.size();
    for (std::size_t i = 0; i < broad.stale.size(); ++i) {
        const int k = broad.stale[i];
        if (!may_ask(k)) continue;
        const std::uint64_t groups =
            at(broad.filter.meets, broad.filter.group_of(k));
        const std::size_t found = broad.fresh.size();
        broad.grid.near(
            x.segment<2>(2 * k), broad.reach_of(scene.radius[k]), groups,
            [&](int b) {
                // Of two that query, the lower one finds the other; but its query
                // may have been before k was woken and moved.
                if (b == k || (i < before_asking && b < k &&
                               at(broad.is_stale, b) && may_ask(b)))
                    return;
                if (!movable(k) && !movable(b)) return;
                if (!set.is_awake(k) && !set.is_awake(b)) return;
                if (broad.filter.forbids(std::min(b, k), std::max(b, k))) return;
                broad.fresh.push_back(pair_code(b, k));
            });
        // the grid may change again
        for (std::size_t j = found; j < broad.fresh.size(); ++j)
            if (const int b = other_of(broad.fresh[j], k); set.is_asleep(b))
                wake_if_close(k, b);
    }
    //! [ask]
    broad.queries = static_cast<std::int64_t>(broad.stale.size());
    for (const int k : broad.stale) at(broad.is_stale, k) = 0;
    broad.stale.clear();
    broad.tested += broad.grid.tested;

    // Old and new, in order, none twice.
    if (!std::is_sorted(broad.fresh.begin(), broad.fresh.end()))
        std::sort(broad.fresh.begin(), broad.fresh.end());
    broad.pairs.resize(broad.kept.size() + broad.fresh.size());
    std::merge(broad.kept.begin(), broad.kept.end(), broad.fresh.begin(),
               broad.fresh.end(), broad.pairs.begin());
    broad.pairs.erase(std::unique(broad.pairs.begin(), broad.pairs.end()),
                      broad.pairs.end());
}

/// The contacts of awake discs, with each other, with what is fixed and with the walls: what
/// find_contacts() says of them, in the same order.
void awake_contacts(const DiscScene& scene, const AwakeSet& set, BroadPhase& broad,
                    std::vector<Contact>& contacts);

}  // namespace rigid
