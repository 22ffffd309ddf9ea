/// \file island_pieces.hpp
/// Islands in pieces that threads may share, and whether something bounces in one.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/10_skipping_work/islands.hpp"

#include <algorithm>
#include <span>

namespace rigid {

//! [pieces]
/// Islands of together some 64 rows and more: less is not worth a thread's while.
struct IslandPieces {
    std::vector<int> first;  ///< island of each, and how many islands there are

    int count() const { return static_cast<int>(first.size()) - 1; }
    int begin(int piece) const { return first[static_cast<std::size_t>(piece)]; }

    void list(const Islands& islands)
    {
        first.assign(1, 0);
        std::size_t rows = 0;
        for (int i = 0; i < islands.count(); ++i) {
            rows += islands.rows_of(i).size();
            if (rows < 64 && i + 1 < islands.count()) continue;
            first.push_back(i + 1);
            rows = 0;
        }
    }
};
//! [pieces]

inline bool bounces(std::span<const int> rows, const StepData<3>& now)
{
    return !now.restitution.empty() &&
           std::any_of(rows.begin(), rows.end(), [&](int row) {
               return now.restitution[static_cast<std::size_t>(row)] > 0;
           });
}

}  // namespace rigid
