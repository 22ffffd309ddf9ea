// The steps of corrected_method.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/07_baumgarte/corrected_method.hpp"

namespace rigid {

template void step(DiscScene&, const StepSettings&, CorrectedMethod&, StepData<2>&);

}  // namespace rigid
