// The steps of warm_method.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/08_warm_starting/warm_method.hpp"

namespace rigid {

template void step(DiscScene&, const StepSettings&, WarmMethod&, StepData<2>&);

}  // namespace rigid
