# The collide functions of two engines.
measure_beside(12_contact_manifolds_benchmark box2d chipmunk)
