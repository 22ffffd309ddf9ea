# Engines of impulses, of coordinates, and of soft accelerations, on the scenes of the ways; solvers of other programs on their forces.
measure_beside(26_four_ways_benchmark bullet ode simbody mujoco siconos)
