# The program as a reader runs it.
add_program_test(ch22 22_distance_of_solids "runs scene pass" --headless --scene pass --steps 300 --csv -)
