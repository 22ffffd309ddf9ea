# Siconos' planar friction solvers.
measure_beside(13_friction_benchmark siconos)
