// The functions of body_groups.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/08_warm_starting/body_groups.hpp"

namespace rigid {

RIGID_BODY_GROUPS(template, 2)
RIGID_BODY_GROUPS(template, 3)
RIGID_BODY_GROUPS(template, 6)

}  // namespace rigid
