// The functions of broad_phase.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/10_skipping_work/broad_phase.hpp"

namespace rigid {

void BroadPhase::reset(const DiscScene& scene, CollisionFilter by)
{
    filter = std::move(by);
    const Index K = scene.bodies.count();
    grid.reset(K, margin + 2 * skin);
    for (Index k = 0; k < K; ++k)
        grid.insert(static_cast<int>(k), scene.bodies.position(k), scene.radius[k],
                    filter.group_of(k));
    pairs.clear();
    is_stale.assign(static_cast<std::size_t>(K), 1);  // no disc has queried yet
    stale.clear();
    for (int k = 0; k < static_cast<int>(K); ++k) stale.push_back(k);
}

void BroadPhase::add(const DiscScene& scene, Index k)
{
    if (!filter.group.empty()) filter.group.push_back(0);
    if (!filter.first.empty()) filter.first.push_back(filter.first.back());
    grid.grow(k + 1);
    grid.insert(static_cast<int>(k), scene.bodies.position(k), scene.radius[k],
                filter.group_of(k));
    is_stale.push_back(0);
}

void awake_contacts(const DiscScene& scene, const AwakeSet& set, BroadPhase& broad,
                    std::vector<Contact>& contacts)
{
    contacts.clear();
    Contact contact;
    broad.tested += static_cast<std::int64_t>(broad.pairs.size());
    for (const std::uint64_t pair : broad.pairs)
        if (touches(scene, first_of(pair), second_of(pair), broad.margin, contact))
            contacts.push_back(contact);
    for (const int b : set.awake) {
        if (!scene.bodies.can_move(b)) continue;
        for_each_wall(scene, b, broad.margin,
                      [&](const Contact& wall) { contacts.push_back(wall); });
    }
}

}  // namespace rigid
