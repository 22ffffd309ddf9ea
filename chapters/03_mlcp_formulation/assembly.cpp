// The functions of assembly.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/assembly.hpp"

namespace rigid {

RIGID_ASSEMBLY(template, 2)
RIGID_ASSEMBLY(template, 3)
RIGID_ASSEMBLY(template, 6)

}  // namespace rigid
