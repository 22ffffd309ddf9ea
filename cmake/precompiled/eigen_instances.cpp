// The instances that eigen_instances.hpp declares.
#define RIGID_INSTANCE template
#include "cmake/precompiled/eigen_instances.hpp"
