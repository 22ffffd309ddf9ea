// The functions of bounded_islands.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/bounded_islands.hpp"

namespace rigid {

//! [list]
void BoundedIslands::list(const std::vector<Row<3>>& all,
                          const Assemblies& assemblies,
                          const std::vector<char>& left_out)
{
    assemblies_ = &assemblies;
    const int places = assemblies.count() + static_cast<int>(assemblies.of.size());
    lowest_.resize(static_cast<std::size_t>(places));
    std::iota(lowest_.begin(), lowest_.end(), 0);
    number.assign(all.size(), -1);
    of.resize(all.size());
    on_.assign(static_cast<std::size_t>(places) + 1, 0);
    listed = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Row<3>& row = all[i];
        if (JointTree::takes(row) || (!left_out.empty() && left_out[i])) continue;
        const auto [a, b] = places_of(row);
        if (a < 0 && b < 0) continue;  // nothing that it could move
        number[i] = 0;
        ++listed;
        for (const int place : {a, b})
            if (place >= 0) ++at(on_, place + 1);
        if (a >= 0 && b >= 0) unite(lowest_, a, b);
    }
    // which rows are on each place
    for (std::size_t i = 1; i < on_.size(); ++i) on_[i] += on_[i - 1];
    next_.assign(on_.begin(), on_.end());
    rows_on_.resize(static_cast<std::size_t>(on_.back()));
    // and which are in each island
    island_.assign(static_cast<std::size_t>(places), -1);
    count = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (number[i] < 0) continue;
        const auto [a, b] = places_of(all[i]);
        for (const int place : {a, b})
            if (place >= 0) at(rows_on_, at(next_, place)++) = static_cast<int>(i);
        int& island = at(island_, lowest_of(lowest_, std::max(a, b)));
        if (island < 0) {
            island = count++;
            if (static_cast<int>(rows.size()) < count) rows.emplace_back();
            at(rows, island).clear();
        }
        of[i] = island;
        number[i] = static_cast<int>(at(rows, island).size());
        at(rows, island).push_back(static_cast<int>(i));
    }
}
//! [list]

}  // namespace rigid
