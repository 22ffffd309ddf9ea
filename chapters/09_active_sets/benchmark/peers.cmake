# Other programs' exact solvers: ODE's and Bullet's Dantzig, Siconos' Lemke.
measure_beside(09_active_sets_benchmark ode siconos bullet)
