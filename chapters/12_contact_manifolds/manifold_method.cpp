// The steps of manifold_method.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/12_contact_manifolds/manifold_method.hpp"

namespace rigid {

template void step(RigidScene&, const StepSettings&, ManifoldSweeps&, StepData<3>&);
template void step(RigidScene&, const StepSettings&, ManifoldExact&, StepData<3>&);

}  // namespace rigid
