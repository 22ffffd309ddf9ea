# Engines of impulses, of coordinates, and of soft accelerations, on the scenes of the ways.
measure_beside(26_four_ways_benchmark bullet ode simbody mujoco)
