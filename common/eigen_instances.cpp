// The instances that eigen_instances.hpp declares.
#define RIGID_INSTANCE template
#include "common/eigen_instances.hpp"
