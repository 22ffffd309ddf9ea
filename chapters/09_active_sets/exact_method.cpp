// The steps of exact_method.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/exact_method.hpp"

namespace rigid {

template void step(DiscScene&, const StepSettings&, ExactMethod&, StepData<2>&);

}  // namespace rigid
