# Boost.odeint, where it is installed: the same methods, measured beside ours in the same run.
find_package(Boost 1.67 QUIET)
if(Boost_FOUND)
  target_include_directories(01_euler_integration_benchmark SYSTEM PRIVATE ${Boost_INCLUDE_DIRS})
  target_compile_definitions(01_euler_integration_benchmark PRIVATE RIGID_HAS_ODEINT)
else()
  message(STATUS "Boost not found: chapter 1 is measured without Boost.odeint beside it")
endif()
target_compile_options(01_euler_integration_benchmark PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
