// The steps of soft_method.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/16_soft_constraints/soft_method.hpp"

namespace rigid {

template void step(JointedScene&, const StepSettings&, SoftSweeps<Manifolds>&,
                   StepData<3>&);
template void step(JointedScene&, const StepSettings&, PositionSweeps<Manifolds>&,
                   StepData<3>&);
template void step(JointedScene&, const StepSettings&, BodyDescent<Manifolds>&,
                   StepData<3>&);

}  // namespace rigid
