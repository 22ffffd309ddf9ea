# The program as a reader runs it.
foreach(scene car trebuchet walkers excavator)
  add_program_test(ch14 14_joints "runs scene ${scene}" --headless --scene ${scene} --steps 120
                   --method exact,sweeps --csv -)
endforeach()
add_program_test(ch14 14_joints "refuses a walk without walkers" --headless --scene walkers --set walkers=0 --steps 1)
set_tests_properties("ch14: 14_joints refuses a walk without walkers" PROPERTIES WILL_FAIL ON)
