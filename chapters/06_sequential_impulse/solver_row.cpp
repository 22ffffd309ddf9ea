// The functions of solver_row.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/06_sequential_impulse/solver_row.hpp"

namespace rigid {

void require_order(std::span<const int> order, std::size_t m,
                   std::vector<char>& seen)
{
    if (order.empty()) return;
    if (order.size() != m)
        throw std::invalid_argument("the order names " +
                                    std::to_string(order.size()) +
                                    " rows; there are " + std::to_string(m));
    seen.assign(m, 0);
    for (const int i : order) {
        if (i < 0 || static_cast<std::size_t>(i) >= m ||
            seen[static_cast<std::size_t>(i)])
            throw std::invalid_argument(
                "the order names row " + std::to_string(i) +
                " twice or out of range; it must name each row once");
        seen[static_cast<std::size_t>(i)] = 1;
    }
}

RIGID_SOLVER_ROW(template, 2)
RIGID_SOLVER_ROW(template, 3)
RIGID_SOLVER_ROW(template, 6)

}  // namespace rigid
