// The functions of best_multiple.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/08_warm_starting/best_multiple.hpp"

namespace rigid {

void require_valid(const MultipleRule& rule)
{
    if (!(rule.near_one >= 0))
        throw std::invalid_argument("near_one is " + shortest(rule.near_one) +
                                    "; it must be zero or positive");
    if (!(rule.most >= 1))
        throw std::invalid_argument("the greatest multiple is " +
                                    shortest(rule.most) + "; it must be 1 or more");
}

RIGID_BEST_MULTIPLE(template, 2)
RIGID_BEST_MULTIPLE(template, 3)
RIGID_BEST_MULTIPLE(template, 6)

}  // namespace rigid
