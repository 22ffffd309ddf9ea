# Engines of space, on stacks, heaps and joints.
measure_beside(18_space_benchmark bullet ode)
# And Box3D, where it is installed (or -Dbox3d_DIR=…).
find_package(box3d CONFIG QUIET)
if(TARGET box3d::box3d)
  enable_language(C)   # its C library may want -lm and threads of it
  target_link_libraries(18_space_benchmark PRIVATE box3d::box3d)
  target_compile_definitions(18_space_benchmark PRIVATE RIGID_HAS_BOX3D)
endif()
