# Two engines, with their own broad phases and their own sleep.
measure_beside(10_skipping_work_benchmark box2d chipmunk)
