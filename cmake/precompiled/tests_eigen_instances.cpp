// The same instances for the tests, where Eigen counts what it allocates.
#include "tests/counted_eigen.hpp"
#define RIGID_INSTANCE template
#include "common/eigen_instances.hpp"
