# The program as a reader runs it.
add_program_test(ch24 24_friction_is_a_disc "runs scene slide" --headless --scene slide --steps 300
                 --method cone,box,pyramid,exact_cone --csv -)
foreach(scene stack heap table low_ball rattleback)
  add_program_test(ch24 24_friction_is_a_disc "runs scene ${scene}" --headless --scene ${scene} --steps 300
                   --method cone,box,exact_cone --csv -)
endforeach()
add_program_test(ch24 24_friction_is_a_disc "refuses a heap of none" --headless --scene heap --set bodies=0 --steps 1)
set_tests_properties("ch24: 24_friction_is_a_disc refuses a heap of none" PROPERTIES WILL_FAIL ON)
