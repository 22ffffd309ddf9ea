# Chains, bridges and dolls of two engines.
measure_beside(14_joints_benchmark box2d chipmunk)
# And of Box2D 3, where it is installed (or -Dbox2d_DIR=…). Its headers have the names of Box2D 2.4's: a library apart.
find_package(box2d 3 CONFIG QUIET)
if(TARGET box2d::box2d)
  enable_language(C)   # its C library may want -lm and threads of it
  add_library(rigid_box2d3_joints STATIC EXCLUDE_FROM_ALL ${folder}/benchmark/peers_box2d3.cpp)
  target_link_libraries(rigid_box2d3_joints PRIVATE rigid_common box2d::box2d)
  target_link_libraries(14_joints_benchmark PRIVATE rigid_box2d3_joints)
  target_compile_definitions(14_joints_benchmark PRIVATE RIGID_HAS_BOX2D3)
endif()
