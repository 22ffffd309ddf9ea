# Worlds of two engines.
measure_beside(17_engine_benchmark box2d chipmunk)
