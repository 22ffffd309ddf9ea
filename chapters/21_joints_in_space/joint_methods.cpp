// The steps of joint_methods.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/21_joints_in_space/joint_methods.hpp"

namespace rigid {

template void step(JointedSolids&, const StepSettings&, SpaceSweeps&, StepData<6>&);
template void step(JointedSolids&, const StepSettings&, SpaceExact&, StepData<6>&);
template void step(JointedSolids&, const StepSettings&, SpaceIslands&,
                   StepData<6>&);

}  // namespace rigid
