# The whole step of two engines.
measure_beside(08_warm_starting_benchmark box2d chipmunk)
