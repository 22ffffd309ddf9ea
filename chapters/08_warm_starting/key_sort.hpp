/// \file key_sort.hpp
/// Into ascending order of the keys, where most of it is in order already.
///
///     tangents of contacts 1, 2, 3, … | normals of contacts 1, 2, 3, …      two runs, each nearly ascending
///
/// Linear for rows as a step lists them: insertion within a run, and the runs are merged.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rigid {

/// Memory that is kept from sort to sort.
template <class Entry>
struct SortScratch {
    std::vector<Entry> merged;
    std::vector<std::size_t> runs;  ///< where each run begins, and the end
};

/// Merges runs two by two until one is left.
template <class Entry, class Ascending>
void merge_runs(std::vector<Entry>& entries, SortScratch<Entry>& scratch,
                const Ascending& ascending)
{
    std::vector<std::size_t>& runs = scratch.runs;
    for (; runs.size() > 2; entries.swap(scratch.merged)) {
        scratch.merged.resize(entries.size());
        const auto at = [](std::vector<Entry>& list, std::size_t i) {
            return list.begin() + static_cast<std::ptrdiff_t>(i);
        };
        const std::size_t end = runs.back();
        std::size_t kept = 0;
        for (std::size_t r = 0; r + 1 < runs.size(); r += 2) {
            const std::size_t first = runs[r], middle = runs[r + 1],
                              last = r + 2 < runs.size() ? runs[r + 2] : end;
            std::merge(at(entries, first), at(entries, middle), at(entries, middle),
                       at(entries, last), at(scratch.merged, first), ascending);
            runs[kept++] = first;
        }
        runs[kept++] = end;
        runs.resize(kept);
    }
}

//! [sort]
/// Rows come as a few runs, one for each kind of row, in which most are a few places
/// from where they belong. What comes in no such order gets an ordinary sort.
template <class Entry>
void sort_by_key(std::vector<Entry>& entries, SortScratch<Entry>& scratch)
{
    // a contact has a few rows, so what is farther off begins another kind of row
    constexpr std::size_t far = 16, most_runs = 8;
    const auto ascending = [](const Entry& a, const Entry& b) {
        return a.key < b.key;
    };
    std::vector<std::size_t>& runs = scratch.runs;
    runs.assign(1, 0);
    for (std::size_t i = 1; i < entries.size(); ++i) {
        const Entry here = entries[i];
        if (!ascending(here, entries[i - 1])) continue;
        if (i - runs.back() >= far && ascending(here, entries[i - far])) {
            if (runs.size() == most_runs)
                return std::sort(entries.begin(), entries.end(), ascending);
            runs.push_back(i);
            continue;
        }
        std::size_t place = i;
        for (; place > runs.back() && ascending(here, entries[place - 1]); --place)
            entries[place] = entries[place - 1];
        entries[place] = here;
    }
    runs.push_back(entries.size());
    merge_runs(entries, scratch, ascending);
}
//! [sort]

}  // namespace rigid
