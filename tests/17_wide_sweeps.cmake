# The program as a reader runs it.
foreach(scene pyramid column pile)
  add_program_test(ch17 17_wide_sweeps "runs scene ${scene}" --headless --scene ${scene} --steps 60
                   --method given,wide,floats --csv -)
endforeach()
add_program_test(ch17 17_wide_sweeps "runs on two threads" --headless --scene pyramid --set threads=2 --steps 20)
add_program_test(ch17 17_wide_sweeps "refuses no threads" --headless --scene pyramid --set threads=0 --steps 1)
set_tests_properties("ch17: 17_wide_sweeps refuses no threads" PROPERTIES WILL_FAIL ON)
