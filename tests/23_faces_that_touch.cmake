# The program as a reader runs it.
add_program_test(ch23 23_faces_that_touch "runs scene stack" --headless --scene stack --steps 120
                 --method four_points,one_point --csv -)
add_program_test(ch23 23_faces_that_touch "runs scene over" --headless --scene over --steps 300 --csv -)
