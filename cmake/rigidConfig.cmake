# find_package(rigid CONFIG) gives rigid::engine (chapters 1 to 19) and rigid::physics (all).
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 NO_MODULE)
include(${CMAKE_CURRENT_LIST_DIR}/rigidTargets.cmake)
