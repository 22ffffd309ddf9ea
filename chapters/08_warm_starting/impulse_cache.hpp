/// \file impulse_cache.hpp
/// The impulses of the previous step under keys that stay the same, so that the sweeps need not start from zero.
///
///     λ_start = λ_old · h / h_old     for a row that was there,      (8.4)
///     λ_start = 0                     for a row that is new
///
/// Data only: the cache sets where a solver starts, never where it ends. It depends on neither rows nor bodies.
#pragma once

#include "chapters/08_warm_starting/key_sort.hpp"
#include "common/contact.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

//! [key]
/// Which row it is. The number of a row changes whenever a contact comes or goes;
/// its key does not.
struct ImpulseKey {
    /// body a, the world (−1), `of_a_joint`, `of_a_machine` or `of_a_body`
    std::int32_t first = 0;
    std::int32_t second = 0;   ///< body b, or the number of the joint or machine
    std::int32_t feature = 0;  ///< which of several contacts or rows of this pair
    std::int32_t part = 0;     ///< which row of this contact (chapter 13)

    static constexpr std::int32_t of_a_body = -4, of_a_joint = -3,
                                  of_a_machine = -2;
    bool operator==(const ImpulseKey&) const = default;
    /// One number after the other, two of them in one comparison.
    auto operator<=>(const ImpulseKey& other) const
    {
        const auto both = [](std::int64_t high, std::int32_t low) {
            return high * 0x1'0000'0000 + low;
        };
        const auto bodies = both(first, second) <=> both(other.first, other.second);
        return bodies != 0
                   ? bodies
                   : both(feature, part) <=> both(other.feature, other.part);
    }
};

inline ImpulseKey link_key(std::size_t joint, int row = 0)
{
    return {ImpulseKey::of_a_joint, static_cast<std::int32_t>(joint), row, 0};
}

inline ImpulseKey joint_key(std::size_t machine, int part = 0)
{
    return {ImpulseKey::of_a_machine, static_cast<std::int32_t>(machine), 0, part};
}

inline ImpulseKey contact_key(const Contact& contact, int part = 0)
{
    return {static_cast<std::int32_t>(contact.shape_a()),
            static_cast<std::int32_t>(contact.shape_b()),
            static_cast<std::int32_t>(contact.feature), part};
}
//! [key]

std::string to_string(const ImpulseKey& key);

/// What was remembered, in ascending order of the keys. All memory is kept from step to step.
struct ImpulseCache {
    struct Entry {
        ImpulseKey key;
        int unseen = 0;  ///< steps since this row was there last
        /// in the order in which the rows came to the last store(); those that are
        /// gone come after them
        std::uint32_t row = 0;
        Real lambda = 0;  ///< [N s]
    };
    std::vector<Entry> entries;
    std::vector<Entry> spare;  ///< where store() writes before it swaps
    /// the entry of each row, in that order: a guess, the key tells whether it is right
    std::vector<std::uint32_t> place;
    SortScratch<Entry> scratch;
    Real h = 0;  ///< time step of the impulses that are stored [s]
    /// steps that an impulse outlives its row; 0 = a row that goes is forgotten
    int keep = 0;
    int found = 0;  ///< rows that the last load() found
    /// rows that it had to search for, because they were not the next in line
    int searched = 0;
};

// Compiled once, in impulse_cache.cpp.
extern template void sort_by_key(std::vector<ImpulseCache::Entry>&,
                                 SortScratch<ImpulseCache::Entry>&);

/// The first entry that is not below a key. Rows seldom change places by much: a few
/// entries about the place where the key was expected are looked at first.
inline std::vector<ImpulseCache::Entry>::iterator
entry_near(ImpulseCache& cache, std::vector<ImpulseCache::Entry>::iterator expected,
           const ImpulseKey& key)
{
    const auto below = [](const ImpulseCache::Entry& entry, const ImpulseKey& it) {
        return entry.key < it;
    };
    auto first = cache.entries.begin(), last = cache.entries.end();
    if (expected - first > 4 && below(*(expected - 4), key)) first = expected - 4;
    if (last - expected > 4 && !below(*(expected + 4), key)) last = expected + 4;
    return std::lower_bound(first, last, key, below);
}

//! [places]
/// Where the entry of each row is, for load() and store() of the same rows.
inline void note_places(ImpulseCache& cache)
{
    cache.place.assign(cache.entries.size(), 0);
    std::uint32_t at = 0;
    for (const ImpulseCache::Entry& entry : cache.entries) {
        if (entry.row < cache.place.size()) cache.place[entry.row] = at;
        ++at;
    }
}
/// Whether the entry of this row is where it is guessed.
inline bool is_at(const ImpulseCache& cache, std::size_t row, const ImpulseKey& key)
{
    return row < cache.place.size() && cache.place[row] < cache.entries.size() &&
           cache.entries[cache.place[row]].key == key;
}
/// Whether the entries are those of these rows, one for one, where they are guessed.
inline bool knows(const ImpulseCache& cache, std::span<const ImpulseKey> keys)
{
    if (cache.entries.size() != keys.size()) return false;
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (!is_at(cache, i, keys[i])) return false;
    return true;
}
//! [places]

//! [load]
/// Where the sweeps start, (8.4). Does not allocate once `lambda` has been as long.
/// \param cache   what store() remembered
/// \param keys    one for each row of this step, in any order
/// \param h       time step [s]
/// \param lambda  becomes one number for each key [N s]
inline void load(ImpulseCache& cache, std::span<const ImpulseKey> keys, Real h,
                 VecX& lambda)
{
    lambda.setZero(static_cast<Index>(keys.size()));
    cache.found = cache.searched = 0;
    // an impulse is a force times h
    const Real scale = cache.h > 0 ? h / cache.h : 0;
    auto near = cache.entries.begin();
    for (std::size_t i = 0, row = 0; i < keys.size(); ++i) {
        // Most rows are those of the step before, in the order that they had there.
        if (is_at(cache, row, keys[i]))
            near = cache.entries.begin() +
                   static_cast<std::ptrdiff_t>(cache.place[row]);
        else {
            ++cache.searched;
            near = entry_near(cache, near, keys[i]);
            if (near == cache.entries.end() || near->key != keys[i]) continue;
            row = near->row;
        }
        lambda[static_cast<Index>(i)] = scale * near->lambda;
        ++cache.found;
        ++row;
    }
}
//! [load]

/// The impulse of one row in the step before, for a step of h [N s], if it was there.
inline std::optional<Real> remembered(const ImpulseCache& cache,
                                      const ImpulseKey& key, Real h)
{
    const auto at =
        std::lower_bound(cache.entries.begin(), cache.entries.end(), key,
                         [](const ImpulseCache::Entry& entry,
                            const ImpulseKey& it) { return entry.key < it; });
    if (at == cache.entries.end() || at->key != key || !(cache.h > 0)) return {};
    return h / cache.h * at->lambda;
}

//! [store]
/// Remembers the answer of a step, and for `cache.keep` more steps the impulses of
/// rows that are gone. An impulse that is not finite is not remembered. Does not
/// allocate once it has seen so many rows.
/// \param cache   is overwritten
/// \param keys    one for each row, each key once; throws std::invalid_argument
///                otherwise
/// \param lambda  one for each key [N s]
/// \param h       time step of these impulses [s]
inline void store(ImpulseCache& cache, std::span<const ImpulseKey> keys,
                  const VecX& lambda, Real h)
{
    if (static_cast<Index>(keys.size()) != lambda.size())
        throw std::invalid_argument("there are " + std::to_string(keys.size()) +
                                    " keys for " + std::to_string(lambda.size()) +
                                    " impulses");
    if (knows(cache, keys) && lambda.allFinite()) {  // the same rows once more
        for (std::size_t i = 0; i < keys.size(); ++i) {
            ImpulseCache::Entry& entry = cache.entries[cache.place[i]];
            entry.lambda = lambda[static_cast<Index>(i)], entry.unseen = 0;
        }
        cache.h = h;
        return;
    }
    const auto ascending = [](const ImpulseCache::Entry& a,
                              const ImpulseCache::Entry& b) {
        return a.key < b.key;
    };
    std::vector<ImpulseCache::Entry>& present = cache.spare;
    present.clear();
    for (std::size_t i = 0; i < keys.size(); ++i)
        present.push_back({keys[i], 0, static_cast<std::uint32_t>(i),
                           lambda[static_cast<Index>(i)]});
    sort_by_key(present, cache.scratch);
    for (std::size_t i = 1; i < present.size(); ++i)
        if (present[i - 1].key == present[i].key)
            throw std::invalid_argument("two rows have the key " +
                                        to_string(present[i].key));

    // What is missing in this step but still remembered goes behind its rows.
    const std::size_t rows = present.size();
    std::size_t i = 0;
    for (const ImpulseCache::Entry& old : cache.entries) {
        if (old.unseen >= cache.keep) continue;
        while (i < rows && present[i].key < old.key) ++i;
        if (i == rows || present[i].key != old.key)
            present.push_back({old.key, old.unseen + 1,
                               static_cast<std::uint32_t>(present.size()),
                               h / cache.h * old.lambda});
    }
    if (present.size() > rows) std::sort(present.begin(), present.end(), ascending);

    std::erase_if(present, [](const ImpulseCache::Entry& entry) {
        return !std::isfinite(entry.lambda);
    });
    std::swap(cache.entries, cache.spare);
    cache.h = h;
    note_places(cache);
}
//! [store]

}  // namespace rigid
