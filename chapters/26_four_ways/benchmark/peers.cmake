# Engines of impulses and of coordinates, on the scenes of the ways.
measure_beside(26_four_ways_benchmark bullet ode)
