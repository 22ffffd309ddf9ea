# The program as a reader runs it.
foreach(scene chain bridge dolls crane engine leg cradle)
  add_program_test(ch15 15_trees "runs scene ${scene}" --headless --scene ${scene} --steps 120
                   --method trees,sweeps --csv -)
endforeach()
add_program_test(ch15 15_trees "refuses a chain without links" --headless --scene chain --set links=0 --steps 1)
set_tests_properties("ch15: 15_trees refuses a chain without links" PROPERTIES WILL_FAIL ON)
add_program_test(ch15 15_trees "runs dolls that sleep" --headless --scene dolls --steps 120 --method sleeping --csv -)
