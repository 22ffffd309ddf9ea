// The functions of sequential_impulse.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/06_sequential_impulse/sequential_impulse.hpp"

namespace rigid {

RIGID_SEQUENTIAL_IMPULSE(template, 2)
RIGID_SEQUENTIAL_IMPULSE(template, 3)
RIGID_SEQUENTIAL_IMPULSE(template, 6)

}  // namespace rigid
