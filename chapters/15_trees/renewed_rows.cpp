// The functions of renewed_rows.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/renewed_rows.hpp"

namespace rigid {

void RenewedRows::put_back(std::span<const int> rows, StepData<3>& now)
{
    if (!renewed_) return;
    for (const int i : rows)
        std::swap(now.rows[static_cast<std::size_t>(i)],
                  before_[static_cast<std::size_t>(i)]);
    renewed_ = false;
}

}  // namespace rigid
