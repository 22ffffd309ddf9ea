// The functions of softness.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/16_soft_constraints/softness.hpp"

namespace rigid {

void require_valid(const Softness& how, std::string_view name)
{
    if (!(how.frequency > 0))
        throw std::invalid_argument("the frequency of " + std::string(name) +
                                    " is " + shortest(how.frequency) +
                                    " Hz; it must be positive (infinite: hard)");
    // (hω)² must be more than nothing
    if (how.frequency < 1e-75)
        throw std::invalid_argument("the frequency of " + std::string(name) +
                                    " is " + shortest(how.frequency) +
                                    " Hz; it must be 1e-75 or more");
    if (!(how.damping_ratio >= 0) || !std::isfinite(how.damping_ratio))
        throw std::invalid_argument("the damping ratio of " + std::string(name) +
                                    " is " + shortest(how.damping_ratio) +
                                    "; it must be zero or positive and finite");
}

}  // namespace rigid
