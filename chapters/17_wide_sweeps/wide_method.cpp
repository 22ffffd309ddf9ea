// The steps of wide_method.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/17_wide_sweeps/wide_method.hpp"

namespace rigid {

template void step(JointedScene&, const StepSettings&, WideSweeps<Manifolds>&,
                   StepData<3>&);
template void step(JointedScene&, const StepSettings&,
                   WideSweeps<Manifolds, float>&, StepData<3>&);

}  // namespace rigid
