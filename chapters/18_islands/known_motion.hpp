/// \file known_motion.hpp
/// Whether the rows of a step move what those of the step before moved: only then do old islands and trees still fit.
#pragma once

#include "chapters/10_skipping_work/islands.hpp"

#include <vector>

namespace rigid {

/// Which bodies the rows of a step move. A heavy body and a short arm may make that nothing in one step and something in
/// the next.
class KnownMotion {
public:
    /// Whether it is as in the step before.
    bool is_same(const std::vector<Row<3>>& rows)
    {
        bool same = moves_.size() == rows.size();
        moves_.resize(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto here =
                static_cast<char>(2 * moves_a(rows[i]) + moves_b(rows[i]));
            same = same && moves_[i] == here;
            moves_[i] = here;
        }
        return same;
    }

private:
    std::vector<char> moves_;  ///< of each row: which of its bodies
};

}  // namespace rigid
