# Runs of the chapter's program: each scene for 300 steps, and what it says where it can't go on.
foreach(scene circle ellipse own_curve pendulum feasible discs chain conflict atwood wedge)
  add_program_test(ch02 02_velocity_constraints "runs the scene ${scene}" --scene ${scene} --headless --steps 300)
endforeach()
add_program_test(ch02 02_velocity_constraints "holds the bead by a spring" --scene circle --method spring --headless --steps 300)
add_program_test(ch02 02_velocity_constraints "solves many discs row by row" --scene discs --headless --steps 300
                 --set count=14 gravity=9.81 rounds=20)
add_program_test(ch02 02_velocity_constraints "says which rows contradict each other" --scene conflict --method refuse
                 --headless --steps 10)
set_tests_properties("ch02: 02_velocity_constraints says which rows contradict each other" PROPERTIES
  PASS_REGULAR_EXPRESSION "no velocity meets row.s. 0, 1, 2 together")
