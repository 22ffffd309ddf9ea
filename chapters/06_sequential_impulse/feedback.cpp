// The functions of feedback.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/06_sequential_impulse/feedback.hpp"

namespace rigid {

RIGID_FEEDBACK(template, 2)
RIGID_FEEDBACK(template, 3)
RIGID_FEEDBACK(template, 6)

}  // namespace rigid
