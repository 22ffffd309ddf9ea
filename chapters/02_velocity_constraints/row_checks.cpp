// The functions of row_checks.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/02_velocity_constraints/row_checks.hpp"

namespace rigid {

RIGID_ROW_CHECKS(template, 2)
RIGID_ROW_CHECKS(template, 3)
RIGID_ROW_CHECKS(template, 6)

}  // namespace rigid
