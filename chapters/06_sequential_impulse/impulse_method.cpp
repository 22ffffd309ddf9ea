// The steps of impulse_method.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/06_sequential_impulse/impulse_method.hpp"

namespace rigid {

template void step(DiscScene&, const StepSettings&, ImpulseMethod&, StepData<2>&);

}  // namespace rigid
