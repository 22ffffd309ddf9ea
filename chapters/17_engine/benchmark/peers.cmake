# Worlds of two engines.
measure_beside(17_engine_benchmark box2d chipmunk)
# And of Box2D 3, where it is installed (or -Dbox2d_DIR=…). Its headers have the names of Box2D 2.4's: a library apart.
find_package(box2d 3 CONFIG QUIET)
if(TARGET box2d::box2d)
  enable_language(C)   # its C library may want -lm and threads of it
  add_library(rigid_box2d3_worlds STATIC EXCLUDE_FROM_ALL ${folder}/benchmark/peer_box2d3.cpp)
  target_link_libraries(rigid_box2d3_worlds PRIVATE rigid_common box2d::box2d)
  target_link_libraries(17_engine_benchmark PRIVATE rigid_box2d3_worlds)
  target_compile_definitions(17_engine_benchmark PRIVATE RIGID_HAS_BOX2D3)
endif()
