// The steps of space_method.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/space_method.hpp"

namespace rigid {

template void step(SpaceScene&, const StepSettings&, SpaceSweeps&, StepData<6>&);
template void step(SpaceScene&, const StepSettings&, SpaceExact&, StepData<6>&);
template void step(SpaceScene&, const StepSettings&, SpaceIslands&, StepData<6>&);
template void step(SpaceScene&, const StepSettings&, TouchingBoxes&, StepData<6>&);
template void step(SpaceScene&, const StepSettings&, TouchingCones&, StepData<6>&);

}  // namespace rigid
