// The functions of warm_start.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/08_warm_starting/warm_start.hpp"

namespace rigid {

void WarmStart::require_valid() const
{
    if (!(factor >= 0 && factor <= 1))
        throw std::invalid_argument("the warm start factor is " + shortest(factor) +
                                    "; it must be from 0 to 1");
    rigid::require_valid(rule);
    if (keep < 0)
        throw std::invalid_argument("keep is " + std::to_string(keep) +
                                    "; it must be zero or positive");
}

}  // namespace rigid
