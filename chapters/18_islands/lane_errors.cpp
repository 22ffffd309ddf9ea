// The functions of lane_errors.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/18_islands/lane_errors.hpp"

namespace rigid {

//! [biases]
void LaneErrors::set_biases(const LanePush& push, Real h, std::size_t p,
                            Wide& wide) const
{
    const V none{}, step = none + h, part = none + push.per_second,
                    most = none - push.fastest;
    for (std::size_t i = first_[p]; i < first_[p + 1]; ++i) {
        const LaneError<V>& error = rows[i];
        const V open = at_least(error.C, none),
                deep = at_most(error.C + error.slop, none);
        wide.rows[static_cast<std::size_t>(error.row)].bias =
            error.rate + at_least(error.kind, none) *
                             (open / step + at_least(part * deep, most));
    }
}
//! [biases]

}  // namespace rigid
