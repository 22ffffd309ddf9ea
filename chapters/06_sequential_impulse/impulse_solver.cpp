// The functions of impulse_solver.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/06_sequential_impulse/impulse_solver.hpp"

namespace rigid {

RIGID_IMPULSE_SOLVER(template, 2)
RIGID_IMPULSE_SOLVER(template, 3)
RIGID_IMPULSE_SOLVER(template, 6)

}  // namespace rigid
