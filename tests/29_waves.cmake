# The program as a reader runs it.
add_program_test(ch29 29_waves "runs scene string" --headless --scene string --steps 100
                 --method leapfrog,trapezoidal,implicit,sines --csv -)
foreach(scene dispersion pool dam basin)
  add_program_test(ch29 29_waves "runs scene ${scene}" --headless --scene ${scene} --steps 60 --csv -)
endforeach()
foreach(scene boxes boat raft duck)
  add_program_test(ch29 29_waves "runs scene ${scene}" --headless --scene ${scene} --steps 120 --method trees,sweeps --csv -)
endforeach()
add_program_test(ch29 29_waves "refuses sines with open ends" --headless --scene string --method sines --set ends=2 --steps 1)
set_tests_properties("ch29: 29_waves refuses sines with open ends" PROPERTIES WILL_FAIL ON)
