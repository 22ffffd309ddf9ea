#Chains and bridges of two engines.
measure_beside(14_joints_benchmark box2d chipmunk)
