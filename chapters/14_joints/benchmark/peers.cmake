# Chains, bridges and dolls of three engines.
measure_beside(14_joints_benchmark box2d chipmunk)
measure_beside_box2d3(14_joints_benchmark ${folder}/benchmark/peers_box2d3.cpp)
