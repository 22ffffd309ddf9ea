/// \file renumbered_impulses.hpp
/// Where impulses are known by the numbers of joint rows, and how they follow when a joint gets other rows, or goes.
#pragma once

#include "chapters/19_engine/resting_forces.hpp"

namespace rigid {

//! [renumber]
/// Impulses are known by the numbers of their rows: in the cache, of sleepers among
/// what they will wake with, and of the last step. Those of a joint get other numbers,
/// or are forgotten: the old numbers may be of another joint when the step begins.
/// \param number  int(int): of row 0, 1 … of the joint; −1: it is forgotten
template <class Number>
void renumber_impulses(EngineState& state, const PlacedJoint& placed,
                       const Number& number)
{
    const auto renumber = [&](int& row) {
        if (row >= placed.first && row < placed.first + placed.count)
            row = number(row - placed.first);
        return row >= 0;
    };
    const auto rename = [&](ImpulseKey& key) {
        return key.first != ImpulseKey::of_a_machine || renumber(key.second);
    };
    ImpulseCache& cache = state.method.start.cache;
    const auto entry_of = [&](const ImpulseKey& key) {
        return entry_near(cache, cache.entries.begin(), key);
    };
    const auto first = static_cast<std::size_t>(placed.first),
               last = first + static_cast<std::size_t>(placed.count);
    const auto from = entry_of(joint_key(first)), to = entry_of(joint_key(last));
    std::vector<ImpulseCache::Entry> its(from, to);
    cache.entries.erase(from, to);
    for (ImpulseCache::Entry& it : its)
        if (rename(it.key)) cache.entries.insert(entry_of(it.key), it);
    note_places(cache);

    ToldManifolds& sleepers = state.awake();
    std::vector<SleepingForces::Entry> kept;
    const auto rename_of = [&](int body) {
        kept.clear();
        sleepers.forces.take_all(body, [&](ImpulseKey key, Real force) {
            if (rename(key)) kept.push_back({key, force});
        });
        for (const SleepingForces::Entry& it : kept)
            sleepers.forces.put(body, it.key, it.force);
    };
    for (const Index k : {placed.joint.a, placed.joint.b}) {
        if (!is_asleep(state, k)) continue;
        auto body = static_cast<int>(k);
        do {
            rename_of(body);
            body = sleepers.set.ring[static_cast<std::size_t>(body)];
        } while (body != k);
    }
    for (const int k : sleepers.set.woken) rename_of(k);  // since the last step

    if (!state.is_answered()) return;
    for (std::size_t i = 0; i < state.now.sources.size(); ++i)
        if (Source& it = state.now.sources[i]; it.of == Source::Of::joint) {
            int row = it.index;
            if (renumber(row)) it.index = row;
            else state.now.solution.lambda[static_cast<Index>(i)] = 0;
        }
}

/// Whether two rows measure the same and hold it in the same way.
inline bool is_same_row(const PointJoint& x, const PointJoint& y)
{
    return x.measure == y.measure && x.direction == y.direction &&
           x.kind == y.kind && x.sense == y.sense;
}
//! [renumber]

}  // namespace rigid
