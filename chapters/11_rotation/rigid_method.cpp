// The steps of rigid_method.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/11_rotation/rigid_method.hpp"

namespace rigid {

template void step(RigidScene&, const StepSettings&, RigidSweeps&, StepData<3>&);
template void step(RigidScene&, const StepSettings&, RigidExact&, StepData<3>&);
template void step(RigidScene&, const StepSettings&, RigidRattle&, StepData<3>&);

}  // namespace rigid
