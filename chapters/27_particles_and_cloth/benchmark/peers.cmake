# Bullet's two kinds of cloth.
measure_beside(27_particles_and_cloth_benchmark bullet)
