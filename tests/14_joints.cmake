# The program as a reader runs it.
foreach(scene chain bridge dolls crane engine leg cradle car trebuchet walkers excavator)
  add_program_test(ch14 14_joints "runs scene ${scene}" --headless --scene ${scene} --steps 120
                   --method trees,sweeps --csv -)
endforeach()
add_program_test(ch14 14_joints "refuses a chain without links" --headless --scene chain --set links=0 --steps 1)
set_tests_properties("ch14: 14_joints refuses a chain without links" PROPERTIES WILL_FAIL ON)
add_program_test(ch14 14_joints "runs dolls that sleep" --headless --scene dolls --steps 120 --method sleeping --csv -)
