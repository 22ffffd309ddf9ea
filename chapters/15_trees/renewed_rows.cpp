// The functions of renewed_rows.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/renewed_rows.hpp"

namespace rigid {

void RenewedRows::begin(std::span<const int> rows, std::span<const int> members,
                        const Bodies<3>& bodies, const StepData<3>& now)
{
    stiffness_.resize(bodies.u.size());
    for (const int k : members) stiffness_.segment<3>(3 * k).setZero();
    if (renewed_) return;
    before_.resize(now.rows.size());
    own_.resize(bodies.u.size());
    for (const int i : rows)
        before_[static_cast<std::size_t>(i)] =
            now.rows[static_cast<std::size_t>(i)];
    for (const int k : members)
        own_.segment<3>(3 * k) = bodies.inverse_mass.segment<3>(3 * k);
    renewed_ = true;
}

void RenewedRows::put_back(std::span<const int> rows, std::span<const int> members,
                           Bodies<3>& bodies, StepData<3>& now)
{
    if (!renewed_) return;
    for (const int i : rows)
        std::swap(now.rows[static_cast<std::size_t>(i)],
                  before_[static_cast<std::size_t>(i)]);
    for (const int k : members)
        bodies.inverse_mass.segment<3>(3 * k) = own_.segment<3>(3 * k);
    renewed_ = false;
}

}  // namespace rigid
