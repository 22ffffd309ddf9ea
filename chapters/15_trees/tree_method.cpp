// The steps of tree_method.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/tree_method.hpp"

namespace rigid {

template void step(JointedScene&, const StepSettings&, JointTrees<AllBodies>&,
                   StepData<3>&);
template void step(JointedScene&, const StepSettings&, JointTrees<Manifolds>&,
                   StepData<3>&);
template void step(JointedScene&, const StepSettings&, SkippingJoints&,
                   StepData<3>&);
template void step(JointedScene&, const StepSettings&, JointRattle<Manifolds>&,
                   StepData<3>&);

}  // namespace rigid
