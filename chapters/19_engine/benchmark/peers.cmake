# Worlds of three engines.
measure_beside(19_engine_benchmark box2d chipmunk)
measure_beside_box2d3(19_engine_benchmark ${PROJECT_SOURCE_DIR}/tests/peers/box2d3_world.cpp)
