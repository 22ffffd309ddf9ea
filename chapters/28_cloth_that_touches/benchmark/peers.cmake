# Bullet's btSoftBody.
measure_beside(28_cloth_that_touches_benchmark bullet)
