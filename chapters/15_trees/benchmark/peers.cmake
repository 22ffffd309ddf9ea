# Chains, bridges and dolls of three engines.
measure_beside(15_trees_benchmark box2d chipmunk)
measure_beside_box2d3(15_trees_benchmark ${folder}/benchmark/peers_box2d3.cpp)
