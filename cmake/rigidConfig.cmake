# find_package(rigid CONFIG) gives rigid::physics.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 NO_MODULE)
include(${CMAKE_CURRENT_LIST_DIR}/rigidTargets.cmake)
