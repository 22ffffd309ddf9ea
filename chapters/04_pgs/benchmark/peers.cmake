# Bullet's solver of the same name, in doubles.
measure_beside(04_pgs_benchmark bullet)
