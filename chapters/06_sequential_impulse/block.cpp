// The functions of block.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/06_sequential_impulse/block.hpp"

namespace rigid {

RIGID_BLOCK(template, 2)
RIGID_BLOCK(template, 3)
RIGID_BLOCK(template, 6)

}  // namespace rigid
