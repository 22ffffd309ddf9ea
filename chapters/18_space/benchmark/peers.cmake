#Engines of space, on stacks and heaps.
measure_beside(18_space_benchmark bullet ode)
