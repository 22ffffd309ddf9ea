/// \file waits.hpp
/// How long a sweep has to wait, counted: the longest chain of visits each of which needs what the one before has written.
///
///     d_i = 1 + max(d of the last visits of bodies a and b),      time of a sweep ≥ max_i d_i · latency of a visit
///
/// (17.1), (17.2).
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"

#include <span>

namespace rigid {

//! [waits]
/// (17.1): the longest chain of one sweep.
/// \param order  row numbers in the order of the visits; empty = as they are
template <int Dof>
int longest_chain(const std::vector<Row<Dof>>& rows, std::span<const int> order,
                  Index bodies)
{
    std::vector<int> written(static_cast<std::size_t>(bodies), 0);
    int longest = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Row<Dof>& row =
            rows[order.empty() ? k : static_cast<std::size_t>(order[k])];
        // a body that cannot move is only read
        const bool a = row.a != world && !row.Wa.isZero(0), b = !row.Wb.isZero(0);
        int depth = 0;
        if (a) depth = std::max(depth, written[static_cast<std::size_t>(row.a)]);
        if (b) depth = std::max(depth, written[static_cast<std::size_t>(row.b)]);
        ++depth;
        if (a) written[static_cast<std::size_t>(row.a)] = depth;
        if (b) written[static_cast<std::size_t>(row.b)] = depth;
        longest = std::max(longest, depth);
    }
    return longest;
}
//! [waits]

}  // namespace rigid
