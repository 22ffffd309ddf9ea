// The steps of skipping_world.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/10_skipping_work/skipping_world.hpp"

namespace rigid {

template void step(DiscScene&, const StepSettings&, SkippingMethod&, StepData<2>&);

}  // namespace rigid
