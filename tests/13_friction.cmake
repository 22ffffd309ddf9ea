# The program as a reader runs it.
foreach(scene slope disc rod conveyor stick_slip)
  add_program_test(ch13 13_friction "runs scene ${scene}" --headless --scene ${scene} --steps 300
                   --method exact,sweeps,lemke --csv -)
endforeach()
foreach(scene house arch dominoes pool wall rubble)
  add_program_test(ch13 13_friction "runs scene ${scene}" --headless --scene ${scene} --steps 100
                   --method exact,sweeps,skipping --csv -)
endforeach()
add_program_test(ch13 13_friction "refuses a negative friction coefficient" --headless --scene slope --set mu=-1 --steps 1)
set_tests_properties("ch13: 13_friction refuses a negative friction coefficient" PROPERTIES WILL_FAIL ON)
