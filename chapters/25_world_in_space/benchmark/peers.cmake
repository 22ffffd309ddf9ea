# Engines of space, on stacks, heaps and joints.
measure_beside(25_world_in_space_benchmark bullet ode)
# And Box3D, where it is installed (or -Dbox3d_DIR=…).
find_package(box3d CONFIG QUIET)
if(TARGET box3d::box3d)
  enable_language(C)   # its C library may want -lm and threads of it
  target_link_libraries(25_world_in_space_benchmark PRIVATE box3d::box3d)
  target_compile_definitions(25_world_in_space_benchmark PRIVATE RIGID_HAS_BOX3D)
endif()
# And Jolt (or -DJolt_DIR=…). It is compiled for its own processor, which its target says: a library apart.
find_package(Jolt CONFIG QUIET)
if(TARGET Jolt::Jolt)
  add_library(25_world_in_space_jolt STATIC EXCLUDE_FROM_ALL chapters/25_world_in_space/benchmark/jolt_world.cpp)
  target_compile_features(25_world_in_space_jolt PRIVATE cxx_std_20)
  target_include_directories(25_world_in_space_jolt PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(25_world_in_space_jolt PRIVATE Jolt::Jolt)
  target_link_libraries(25_world_in_space_benchmark PRIVATE 25_world_in_space_jolt)
  target_compile_definitions(25_world_in_space_benchmark PRIVATE RIGID_HAS_JOLT)
endif()
