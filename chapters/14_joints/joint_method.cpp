// The steps of joint_method.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/14_joints/joint_method.hpp"

namespace rigid {

template void step(JointedScene&, const StepSettings&, JointSweeps<AllBodies>&,
                   StepData<3>&);
template void step(JointedScene&, const StepSettings&, JointSweeps<Manifolds>&,
                   StepData<3>&);
template void step(JointedScene&, const StepSettings&, ExactJoints<AllBodies>&,
                   StepData<3>&);
template void step(JointedScene&, const StepSettings&, ExactJoints<Manifolds>&,
                   StepData<3>&);

}  // namespace rigid
