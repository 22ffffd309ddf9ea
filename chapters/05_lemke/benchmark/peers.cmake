# Siconos' and Bullet's Lemke.
measure_beside(05_lemke_benchmark siconos bullet)
