# Boost.odeint, where it is installed: the same methods, measured beside ours in the same run.
measure_beside(01_euler_integration_benchmark odeint)
target_compile_options(01_euler_integration_benchmark PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
